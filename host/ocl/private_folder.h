#pragma once

#include <chrono>
#include <filesystem>
#include <string>

/// Folders of compiled programs, ours and those of drivers: who holds one, and whether it can be trusted.
/// Drivers run what is in them: what another user could have put there must not be used.
namespace offing::ocl {

/// While it lives and is held, no other process, nor another lock of this one, holds the same folder. It is
/// on the folder itself, so that nothing is left behind.
class FolderLock {
 public:
  /// Waits for its turn, but no longer than that: a process that was stopped while it held the folder would
  /// hold up all others for ever.
  FolderLock(const std::string& folder, std::chrono::milliseconds longest_wait);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

  /// False where there is no such folder, the system has no such lock, or its turn did not come in time.
  bool is_held() const { return is_held_; }

 private:
  int folder_ = -1;
  bool is_held_ = false;
};

/// What is wrong with a folder: it, or a link that leads to it, belongs to another user, or others than its
/// owner may write in it. Empty if it is ours alone or not there yet.
std::string trouble_with_folder(const std::filesystem::path& folder);

/// Makes the folder, which only its owner may enter, and those above it. Returns why it cannot be used: what
/// the system says, or as trouble_with_folder(); empty if it can.
std::string make_private_folder(const std::filesystem::path& folder);

}  // namespace offing::ocl
