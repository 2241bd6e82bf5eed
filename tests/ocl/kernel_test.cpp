#include "host/ocl/kernel.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocl/program.h"
#include "tests/ocl/expect_error.h"
#include "tests/ocl/test_kernels.h"

namespace offing::ocl {
namespace {

using ::testing::HasSubstr;

constexpr const char* axpy_source = R"(
kernel void axpy(float factor, global const float* restrict x, global float* restrict y) {
  const size_t i = get_global_id(0);
  y[i] += factor * x[i];
}
kernel void count_up(int columns, global int* counts) {
  counts[get_global_id(1) * columns + get_global_id(0)] += 1;
}
kernel void reversed(global int* values, local int* scratch, uint4 unused) {
  const size_t i = get_local_id(0);
  scratch[i] = values[i];
  barrier(CLK_LOCAL_MEM_FENCE);
  values[i] = scratch[get_local_size(0) - 1 - i];
}
)";

class KernelTest : public ::testing::Test {
 protected:
  KernelTest() { kernels_.write("axpy.cl", axpy_source); }

  test::TestKernels kernels_;
  Device device_ = Device::open();
};

// Fails if arguments reach the kernel in another order or a launch misses work-items.
TEST_F(KernelTest, ComputesWithBuffersAndValues) {
  const Kernel axpy = Program::build(device_, "axpy.cl").kernel("axpy");
  const Buffer<float> x(device_, std::vector<float>{1, 2, 3, 4}, "x");
  const Buffer<float> y(device_, std::vector<float>{10, 20, 30, 40}, "y");
  axpy.launch({{4}}, 2.0f, x, y);
  EXPECT_THAT(y.read(), ::testing::ElementsAre(12, 24, 36, 48));
}

// Fails if a launch without a local size leaves work-items out or runs some twice, where it runs in parts.
TEST_F(KernelTest, RunsEachWorkItemOnce) {
  const Kernel count_up = Program::build(device_, "axpy.cl").kernel("count_up");
  for (const int columns : {1, 63, 64, 65, 1000}) {
    for (const int rows : {1, 3}) {
      const auto width = static_cast<std::size_t>(columns), height = static_cast<std::size_t>(rows);
      const Buffer<int> counts(device_, std::vector<int>(width * height), "counts");
      count_up.launch({{width, height}}, columns, counts);
      EXPECT_THAT(counts.read(), ::testing::Each(1)) << columns << " x " << rows;
    }
  }
}

// Fails if __local arguments are not sized, or the launch ignores the work-group size.
TEST_F(KernelTest, GivesLocalMemory) {
  const Kernel reversed = Program::build(device_, "axpy.cl").kernel("reversed");
  const Buffer<int> values(device_, std::vector<int>{1, 2, 3, 4}, "values");
  const std::array<std::uint32_t, 4> unused{};
  reversed.launch({{4}, {4}}, values, LocalMemory{4 * sizeof(int)}, unused);
  EXPECT_THAT(values.read(), ::testing::ElementsAre(4, 3, 2, 1));
}

// Each wrong call must be named, whether the program was compiled or came from the cache.
TEST_F(KernelTest, RejectsWrongArguments) {
  for (int start = 0; start < 2; ++start) {
    const Program program = Program::build(device_, "axpy.cl");
    const Kernel axpy = program.kernel("axpy");
    const Buffer<float> x(device_, 4, "x");
    const auto expect_rejected = [](auto call, const char* part) {
      test::expect_error(ErrorKind::bad_usage, part, call);
    };
    expect_rejected([&] { axpy.launch({{4}}, 2.0f, x); }, "kernel axpy: expected 3 arguments, got 2");
    expect_rejected([&] { axpy.launch({{4}}, x, x, x); },
                    "kernel axpy, argument 0 (float factor): expected a value");
    expect_rejected([&] { axpy.launch({{4}}, 2.0, x, x); }, "expected 4 bytes, got 8 bytes");
    expect_rejected([&] { axpy.launch({{4}}, 2, x, x); }, "of the other kind of number");
    expect_rejected([&] { axpy.launch({{4}}, 2.0f, LocalMemory{16}, x); },
                    "expected a Buffer, got LocalMemory");
    expect_rejected([&] { axpy.launch({{4}}, 2.0f, x, 3); }, "expected a Buffer, got a value");
    expect_rejected([&] { axpy.launch({{4}}, 2.0f, x, Buffer<float>()); }, "was never allocated");
    const Kernel reversed = program.kernel("reversed");
    const Buffer<int> values(device_, 4, "values");
    expect_rejected(
        [&] {
          reversed.launch({{4}, {4}}, values, LocalMemory{std::size_t{1} << 40}, 0);
        },
        "bytes of local memory");
    expect_rejected(
        [&] {
          reversed.launch({{4}, {4}}, values, LocalMemory{16}, 0);
        },
        "expected 16 bytes, got 4 bytes");
  }
}

// Fails if the driver's refusal loses the call, the kernel or the device on its way to the user.
TEST_F(KernelTest, NamesTheRefusedLaunch) {
  const Kernel axpy = Program::build(device_, "axpy.cl").kernel("axpy");
  const Buffer<float> x(device_, 4, "x");
  try {
    axpy.launch({{std::size_t{1} << 20}, {std::size_t{1} << 20}}, 2.0f, x, x);
    FAIL() << "a work-group of a million items was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::device);
    EXPECT_THAT(error.what(), HasSubstr("clEnqueueNDRangeKernel failed with CL_INVALID_WORK"));
    EXPECT_THAT(error.what(), HasSubstr("kernel axpy"));
    EXPECT_THAT(error.what(), HasSubstr(device_.info().name));
    EXPECT_THAT(error.hint(), HasSubstr("--device"));
  }
}

TEST_F(KernelTest, TimesLaunchesOnAProfilingDevice) {
  const Device profiling = Device::open("", Profiling::on);
  const Kernel axpy = Program::build(profiling, "axpy.cl").kernel("axpy");
  constexpr std::size_t items =
      (1 << 16) + 1;  // one more than whole groups: two parts where launches have them
  const Buffer<float> x(profiling, items, "x");
  x.map();
  const Event event = axpy.launch({{items}}, 2.0f, x, x);
  const double duration_s = event.duration_s();
  EXPECT_GT(duration_s, 0.0);
  EXPECT_LT(duration_s, 10.0);
}

TEST_F(KernelTest, RefusesTimesWithoutProfiling) {
  const Kernel axpy = Program::build(device_, "axpy.cl").kernel("axpy");
  const Buffer<float> x(device_, 4, "x");
  const Event event = axpy.launch({{4}}, 2.0f, x, x);
  test::expect_error(ErrorKind::bad_usage, "not profiled", [&] { event.duration_s(); });
}

}  // namespace
}  // namespace offing::ocl
