#include "host/base/host_memory.h"

#include <fstream>
#include <regex>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "host/base/error.h"
#include "tests/io/temporary_folder.h"

// Control groups of cgroup v2, made up in a folder.

namespace offing {
namespace {

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

}  // namespace
}  // namespace offing
