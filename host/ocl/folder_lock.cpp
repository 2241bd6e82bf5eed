#include "host/ocl/folder_lock.h"

#include <algorithm>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
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

}  // namespace offing::ocl
