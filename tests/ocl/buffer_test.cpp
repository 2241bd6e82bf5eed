#include "host/ocl/buffer.h"

#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/ocl/program.h"
#include "tests/ocl/expect_error.h"
#include "tests/ocl/scoped_environment.h"
#include "tests/ocl/test_kernels.h"

namespace offing::ocl {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<int> counted(std::size_t count) {
  std::vector<int> values(count);
  std::iota(values.begin(), values.end(), 1);
  return values;
}

// Each case runs with buffers over host memory where the device allows them, and with the driver's own.
class BufferTest : public ::testing::TestWithParam<const char*> {
 protected:
  test::ScopedEnvironment host_pointers_{"OFFING_HOST_POINTERS", GetParam()};
  Device device_ = Device::open();
};

INSTANTIATE_TEST_SUITE_P(HostPointers, BufferTest, ::testing::Values("1", "0"),
                         [](const auto& test) { return test.param[0] == '1' ? "Allowed" : "Forbidden"; });

// Sizes around a page, a huge page and an odd count: fails if rounding loses or adds elements.
TEST_P(BufferTest, ReturnsWhatWasWritten) {
  for (std::size_t count : {1u, 3u, 1023u, 1024u, 1025u, 524288u, 524291u}) {
    const std::vector<int> values = counted(count);
    const Buffer<int> buffer(device_, values, "values");
    EXPECT_EQ(buffer.size(), count);
    EXPECT_EQ(buffer.read(), values) << count;
  }
}

TEST_P(BufferTest, WritesAndReadsAPart) {
  Buffer<int> buffer(device_, counted(6), "values");
  const std::vector<int> part{-1, -2};
  buffer.write(part, 3);
  EXPECT_THAT(buffer.read(), ElementsAre(1, 2, 3, -1, -2, 6));
  std::vector<int> tail(2);
  buffer.read(tail, 4);
  EXPECT_THAT(tail, ElementsAre(-2, 6));
}

TEST_P(BufferTest, FillsEachElement) {
  struct Pair {
    float a, b;
  };
  Buffer<float> floats(device_, 1000, "floats");
  floats.fill(2.5f);
  EXPECT_THAT(floats.read(), Each(2.5f));
  Buffer<Pair> pairs(device_, 5, "pairs");
  pairs.fill({1.0f, 2.0f});
  EXPECT_EQ(pairs.read()[4].a, 1.0f);
  EXPECT_EQ(pairs.read()[4].b, 2.0f);
}

TEST_P(BufferTest, MapsItsContent) {
  Buffer<int> buffer(device_, counted(5000), "values");
  {
    const MappedSpan<int> view = buffer.map();
    EXPECT_EQ(view.span().size(), 5000u);
    EXPECT_EQ(view[0], 1);
    EXPECT_EQ(view[4999], 5000);
  }
  buffer.fill(7);  // fails if the view left the buffer mapped or a stale copy behind
  EXPECT_EQ(buffer.map()[4999], 7);
}

// Fails if a kernel's result is not visible in a view taken later, or vice versa.
TEST_P(BufferTest, ShowsKernelsResults) {
  const test::TestKernels kernels;
  kernels.write("double.cl", "kernel void twice(global int* v) { v[get_global_id(0)] *= 2; }");
  const Kernel twice = Program::build(device_, "double.cl").kernel("twice");
  const Buffer<int> buffer(device_, counted(600000), "values");
  for (int round = 1; round <= 3; ++round) {
    twice.launch({{1024}}, buffer);
    EXPECT_EQ(buffer.map()[1023], 1024 << round);
    EXPECT_EQ(buffer.map()[1024], 1025);
  }
}

// Fails (under a sanitizer, or by a crash) if memory goes while the device still writes to it.
TEST_P(BufferTest, OutlivesTheKernelsThatUseIt) {
  const test::TestKernels kernels;
  kernels.write("slow.cl",
                "kernel void slow(global int* v) {"
                "  for (int k = 0; k < 100; ++k) v[get_global_id(0)] = v[get_global_id(0)] * 3 + k; }");
  const Kernel slow = Program::build(device_, "slow.cl").kernel("slow");
  for (int i = 0; i < 4; ++i) slow.launch({{256}}, Buffer<int>(device_, 4096, "short-lived"));
  EXPECT_NO_THROW(device_.finish());
}

TEST_P(BufferTest, MovesWithItsContent) {
  Buffer<int> first(device_, counted(4), "first");
  Buffer<int> second = std::move(first);
  EXPECT_THAT(second.read(), ElementsAre(1, 2, 3, 4));
  second = Buffer<int>(device_, counted(2), "third");
  EXPECT_THAT(second.read(), ElementsAre(1, 2));
}

TEST_P(BufferTest, CanBeEmpty) {
  Buffer<int> buffer(device_, 0, "nothing");
  EXPECT_TRUE(buffer.empty());
  EXPECT_TRUE(buffer.read().empty());
  EXPECT_NO_THROW(buffer.fill(1));
  EXPECT_NE(buffer.handle(), nullptr);  // a kernel takes it like any other
}

TEST_P(BufferTest, RejectsTransfersOutsideIt) {
  Buffer<int> buffer(device_, 4, "small");
  std::vector<int> five(5);
  test::expect_error(ErrorKind::bad_usage, "write of bytes [0, 20) is outside buffer \"small\" of 16 bytes",
                     [&] { buffer.write(five); });
  test::expect_error(ErrorKind::bad_usage, "read of bytes [4, 24) is outside buffer \"small\"",
                     [&] { buffer.read(five, 1); });
  std::vector<int> none;
  test::expect_error(ErrorKind::bad_usage, "is outside buffer", [&] { buffer.write(none, 5); });
}

// Fails if the error loses what the user needs: which buffer, how large, on which device, and the fix.
TEST_P(BufferTest, NamesWhatDoesNotFit) {
  const std::size_t count = device_.info().max_allocation_bytes / sizeof(float) + 2048;
  const std::string hint =
      test::expect_error(ErrorKind::out_of_memory,
                         fmt::format("buffer \"displacement\" of {} bytes on {} does not fit",
                                     count * sizeof(float), device_.info().name),
                         [&] { Buffer<float>(device_, count, "displacement"); });
  EXPECT_THAT(hint, HasSubstr("smaller --size"));
}

TEST_P(BufferTest, RejectsASizeThatOverflows) {
  test::expect_error(ErrorKind::out_of_memory, "exceeds the address space",
                     [&] { Buffer<double>(device_, std::numeric_limits<std::size_t>::max() / 4, "huge"); });
}

}  // namespace
}  // namespace offing::ocl
