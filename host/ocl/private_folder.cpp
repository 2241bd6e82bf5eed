// Locks folders, and makes those that their owner alone may use.
#include "host/ocl/private_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace offing::ocl {

FolderLock::FolderLock(const std::string& folder, std::chrono::milliseconds longest_wait) {
  folder_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder_ < 0) return;
  const auto end = std::chrono::steady_clock::now() + longest_wait;
  std::chrono::milliseconds pause(1);
  while (!(is_held_ = flock(folder_, LOCK_EX | LOCK_NB) == 0)) {
    if (std::chrono::steady_clock::now() >= end) return;
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::milliseconds(50));
  }
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) close(folder_);
}

std::string trouble_with_folder(const std::filesystem::path& folder) {
  struct stat name {};
  struct stat status {};
  if (lstat(folder.c_str(), &name) != 0 || stat(folder.c_str(), &status) != 0) return {};
  if (!S_ISDIR(status.st_mode)) return "it is no folder";
  if (name.st_uid != geteuid() || status.st_uid != geteuid()) return "it belongs to another user";
  if ((status.st_mode & (S_IWGRP | S_IWOTH)) == 0) return {};
  return fmt::format("others may write in it; run chmod go-w {}", folder.string());
}

std::string make_private_folder(const std::filesystem::path& folder) {
  std::error_code error;
  if (folder.has_parent_path()) std::filesystem::create_directories(folder.parent_path(), error);
  if (error) return error.message();
  if (mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST) return std::strerror(errno);
  if (std::string trouble = trouble_with_folder(folder); !trouble.empty()) return trouble;
  return access(folder.c_str(), W_OK | X_OK) == 0 ? "" : std::strerror(errno);
}

}  // namespace offing::ocl
