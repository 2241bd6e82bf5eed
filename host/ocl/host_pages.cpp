#include "host/ocl/host_pages.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include <sys/mman.h>

#include "host/base/host_memory.h"

namespace offing::ocl {
namespace {

constexpr std::size_t page_bytes = 4096;
constexpr std::size_t huge_page_bytes = std::size_t{2} << 20;

}  // namespace

std::size_t HostPages::rounded(std::size_t bytes) {
  return (std::max<std::size_t>(bytes, 1) + page_bytes - 1) / page_bytes * page_bytes;
}

HostPages::HostPages(std::size_t bytes) {
  const std::size_t size = rounded(bytes);
  const bool is_large = size >= huge_page_bytes;
  // Untouched pages cost nothing until the first write, and then the kernel kills the process instead of
  // refusing.
  if (is_large && size > available_host_memory_bytes()) return;
  if (posix_memalign(&data_, is_large ? huge_page_bytes : page_bytes, size) != 0) {
    data_ = nullptr;
    return;
  }
  if (is_large) madvise(data_, size, MADV_HUGEPAGE);  // a wish: without huge pages all works, only slower
  std::memset(data_, 0, size);
}

HostPages::~HostPages() {
  std::free(data_);
}

}  // namespace offing::ocl
