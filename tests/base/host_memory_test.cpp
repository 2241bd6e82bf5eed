#include "host/base/host_memory.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <memory>
#include <regex>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "host/base/error.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

// Control groups of cgroup v2, made up in a folder.
class ControlGroup : public testing::Test {
 protected:
  void write(const char* name, const char* text) const { std::ofstream(group() / name) << text; }
  std::filesystem::path group() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

// Fails if file pages, which the kernel gives back before it refuses anything, count as used: a long bake's
// own files would then leave no memory for its next frame.
TEST_F(ControlGroup, FilePagesAreFree) {
  write("memory.max", "1000000\n");
  write("memory.current", "990000\n");
  write("memory.stat", "anon 90000\nfile 900000\ninactive_file 700000\nactive_file 150000\nslab 50000\n");
  EXPECT_EQ(available_in_group_bytes(group()), 860000u);
}

TEST_F(ControlGroup, WithoutStatisticsAllUseCounts) {
  write("memory.max", "1000\n");
  write("memory.current", "400\n");
  EXPECT_EQ(available_in_group_bytes(group()), 600u);
}

// Fails if numbers that were read at different times wrap around.
TEST_F(ControlGroup, NeverWrapsAround) {
  write("memory.max", "1000\n");
  write("memory.current", "1200\n");
  EXPECT_EQ(available_in_group_bytes(group()), 0u);
  write("memory.stat", "inactive_file 5000\n");
  EXPECT_EQ(available_in_group_bytes(group()), 1000u);
}

TEST_F(ControlGroup, MayHaveNoLimit) {
  EXPECT_EQ(available_in_group_bytes(group()), unlimited_bytes);
  write("memory.max", "max\n");
  write("memory.current", "400\n");
  EXPECT_EQ(available_in_group_bytes(group()), unlimited_bytes);
}

// Fails if this machine's own files are misread: some memory is left, and not more than there is.
TEST(HostMemory, IsSomeOfTheMachines) {
  EXPECT_GT(available_host_memory_bytes(), 0u);
  EXPECT_LE(available_host_memory_bytes(), total_host_memory_bytes());
}

// Fails if work begins that a limit of the process, as `ulimit` sets it, then stops in its middle.
TEST(HostMemory, IsWithinLimitsOfTheProcess) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers map more than the limits allow";
#endif
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit usual{};
    ASSERT_EQ(getrlimit(resource, &usual), 0);
    constexpr rlim_t gibibyte = rlim_t{1} << 30;
    const rlimit limited{.rlim_cur = gibibyte, .rlim_max = usual.rlim_max};
    ASSERT_EQ(setrlimit(resource, &limited), 0);
    const std::uint64_t left = available_host_memory_bytes();
    ASSERT_EQ(setrlimit(resource, &usual), 0);
    EXPECT_LT(left, gibibyte);
  }
}

// Fails if what no machine has is begun, what fits is refused, or the message lacks a figure.
TEST(HostMemory, IsRequiredWithBothFigures) {
  EXPECT_NO_THROW(require_host_memory(1.0, "one byte", ""));
  try {
    require_host_memory(3e18, "posts", "take fewer");
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::out_of_memory);
    EXPECT_TRUE(std::regex_match(
        error.what(), std::regex(R"(posts need 3000000000\.00 GB of memory, [0-9]+\.[0-9]{2} GB are free)")))
        << error.what();
    EXPECT_EQ(error.hint(), "take fewer");
  }
}

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
