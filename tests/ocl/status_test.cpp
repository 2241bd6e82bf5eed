#include "host/ocl/status.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ocl/expect_error.h"

namespace offing::ocl {
namespace {

// Values of the OpenCL specification, written out: the test fails if a name is paired with another's number.
TEST(StatusTest, NamesStatuses) {
  EXPECT_EQ(status_name(0), "CL_SUCCESS");
  EXPECT_EQ(status_name(-5), "CL_OUT_OF_RESOURCES");
  EXPECT_EQ(status_name(-52), "CL_INVALID_KERNEL_ARGS");
  EXPECT_EQ(status_name(-1001), "CL_PLATFORM_NOT_FOUND_KHR");
  EXPECT_EQ(status_name(-9999), "OpenCL status -9999");
}

// Drivers that reserve memory late report it at a launch or a transfer: it must still count as memory.
TEST(StatusTest, TellsMemoryFromOtherFailures) {
  for (int status : {-4, -6}) {  // CL_MEM_OBJECT_ALLOCATION_FAILURE, CL_OUT_OF_HOST_MEMORY
    const std::string hint =
        test::expect_error(ErrorKind::out_of_memory, "clFinish failed with CL_",
                           [status] { check(status, "clFinish", "kernel f on a device"); });
    EXPECT_THAT(hint, ::testing::HasSubstr("smaller --size"));
  }
  const std::string hint = test::expect_error(
      ErrorKind::device,
      "clEnqueueNDRangeKernel failed with CL_INVALID_WORK_GROUP_SIZE: kernel f on a device",
      [] { check(-54, "clEnqueueNDRangeKernel", "kernel f on a device"); });
  EXPECT_THAT(hint, ::testing::HasSubstr("--device"));
}

TEST(StatusTest, AcceptsSuccess) {
  EXPECT_NO_THROW(check(0, "clFinish", "a device"));
}

}  // namespace
}  // namespace offing::ocl
