#pragma once

#include <chrono>
#include <string>

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

}  // namespace offing::ocl
