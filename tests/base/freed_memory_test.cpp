#include "host/base/host_memory.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace offing {
namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20;

/// Of this process, as the system counts it.
std::size_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::size_t all_pages = 0, resident_pages = 0;
  file >> all_pages >> resident_pages;
  return resident_pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

// Fails if memory that was freed stays with the process where small blocks that are still needed lie behind
// it. 64 MiB in blocks that are too small for pages of their own, each with a small one behind it: all but
// the pages of the small ones, which is one in 16, has to go. Measured: 60 MiB of 64; gate: three quarters.
TEST(FreedMemoryTest, GoesBackFromBetweenWhatIsKept) {
#if !defined(__GLIBC__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "memory is not allocated by glibc here";
#endif
  constexpr std::size_t blocks = 1024, block_bytes = mebibyte / 16, kept_bytes = 64;
  std::vector<std::unique_ptr<std::byte[]>> freed, kept;
  for (std::size_t i = 0; i < blocks; ++i) {
    freed.push_back(std::make_unique<std::byte[]>(block_bytes));
    std::memset(freed.back().get(), 1, block_bytes);
    kept.push_back(std::make_unique<std::byte[]>(kept_bytes));
  }
  freed.clear();
  const std::size_t before = resident_bytes();
  give_back_freed_memory();
  EXPECT_GT(before, resident_bytes() + blocks * block_bytes / 4 * 3);
}

// Fails if arrays of 2 MiB stay with the process once they are freed, after a larger one was freed before
// them and with small blocks between them: by itself glibc keeps them in its heap then.
TEST(FreedMemoryTest, LargeArraysGoBackByThemselves) {
#if !defined(__GLIBC__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "memory is not allocated by glibc here";
#endif
  keep_large_arrays_apart();
  constexpr std::size_t arrays = 32, array_bytes = 2 * mebibyte, kept_bytes = 64;
  auto larger = std::make_unique<std::byte[]>(16 * mebibyte);
  std::memset(larger.get(), 1, 16 * mebibyte);
  EXPECT_EQ(std::count(larger.get(), larger.get() + mebibyte, std::byte{1}),
            static_cast<std::ptrdiff_t>(mebibyte));  // or compilers leave it out
  larger.reset();
  std::vector<std::unique_ptr<std::byte[]>> freed, kept;
  for (std::size_t i = 0; i < arrays; ++i) {
    freed.push_back(std::make_unique<std::byte[]>(array_bytes));
    std::memset(freed.back().get(), 1, array_bytes);
    kept.push_back(std::make_unique<std::byte[]>(kept_bytes));
  }
  const std::size_t before = resident_bytes();
  freed.clear();
  EXPECT_GT(before, resident_bytes() + arrays * array_bytes / 10 * 9);
}

}  // namespace
}  // namespace offing
