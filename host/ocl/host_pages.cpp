#include "host/ocl/host_pages.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include <sys/mman.h>

namespace offing::ocl {
namespace {

constexpr std::size_t page_bytes = 4096;
constexpr std::size_t huge_page_bytes = std::size_t{2} << 20;

std::uint64_t number_in(const char* path) {
  std::uint64_t value = 0;
  std::ifstream(path) >> value;  // "max" and a missing file leave 0
  return value;
}

// A line "label   1234 kB" of /proc/meminfo.
std::optional<std::uint64_t> meminfo_bytes(std::string_view label) {
  std::ifstream meminfo("/proc/meminfo");
  for (std::string line; std::getline(meminfo, line);) {
    if (line.starts_with(label)) return std::strtoull(line.c_str() + label.size(), nullptr, 10) * 1024;
  }
  return std::nullopt;
}

}  // namespace

std::size_t HostPages::rounded(std::size_t bytes) {
  return (std::max<std::size_t>(bytes, 1) + page_bytes - 1) / page_bytes * page_bytes;
}

HostPages::HostPages(std::size_t bytes) : bytes_(rounded(bytes)) {
  const bool is_large = bytes_ >= huge_page_bytes;
  // Untouched pages cost nothing until the first write, and then the kernel kills the process instead of
  // refusing.
  if (is_large && bytes_ > available_host_memory_bytes()) return;
  if (posix_memalign(&data_, is_large ? huge_page_bytes : page_bytes, bytes_) != 0) {
    data_ = nullptr;
    return;
  }
  if (is_large) madvise(data_, bytes_, MADV_HUGEPAGE);  // a wish: without huge pages all works, only slower
  std::memset(data_, 0, bytes_);
}

HostPages::~HostPages() {
  std::free(data_);
}

std::uint64_t total_host_memory_bytes() {
  return meminfo_bytes("MemTotal:").value_or(0);
}

std::uint64_t available_host_memory_bytes() {
  std::uint64_t available =
      meminfo_bytes("MemAvailable:").value_or(std::numeric_limits<std::uint64_t>::max());
  const std::uint64_t limit = number_in("/sys/fs/cgroup/memory.max");
  const std::uint64_t used = number_in("/sys/fs/cgroup/memory.current");
  if (limit != 0) available = std::min(available, limit - std::min(limit, used));
  return available;
}

}  // namespace offing::ocl
