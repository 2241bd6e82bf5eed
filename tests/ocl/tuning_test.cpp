#include "host/ocl/tuning.h"

#include <gtest/gtest.h>

#include "tests/ocl/expect_error.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::ocl {
namespace {

DeviceInfo device(DeviceType type, std::uint32_t native_float_width) {
  DeviceInfo info;
  info.type = type;
  info.native_float_width = native_float_width;
  return info;
}

void expect_tuning(const DeviceInfo& info, std::string_view family, KernelShape shape) {
  EXPECT_EQ(tuning_for(info, family).shape, shape);
}

class TuningTest : public ::testing::Test {
 protected:
  test::ScopedEnvironment no_override_{"OFFING_SHAPE", ""};
};

TEST_F(TuningTest, GivesSimdToVectorCpus) {
  for (std::uint32_t width : {4u, 8u, 16u}) {
    expect_tuning(device(DeviceType::cpu, width), "fft", KernelShape::strip);
  }
}

// Fails if a device without wide vectors gets kernels that its compiler takes minutes for.
TEST_F(TuningTest, GivesWorkgroupsToAllOthers) {
  expect_tuning(device(DeviceType::cpu, 1), "fft", KernelShape::group);
  expect_tuning(device(DeviceType::gpu, 1), "fft", KernelShape::group);
  expect_tuning(device(DeviceType::gpu, 4), "fft", KernelShape::group);
  expect_tuning(device(DeviceType::accelerator, 0), "fft", KernelShape::group);
}

TEST_F(TuningTest, GivesTheDefaultRowToAnUnlistedFamily) {
  expect_tuning(device(DeviceType::cpu, 16), "unheard-of", KernelShape::group);
}

TEST_F(TuningTest, ObeysTheOverride) {
  const test::ScopedEnvironment strip("OFFING_SHAPE", "strip");
  expect_tuning(device(DeviceType::gpu, 1), "fft", KernelShape::strip);
  const test::ScopedEnvironment group("OFFING_SHAPE", "group");
  expect_tuning(device(DeviceType::cpu, 16), "fft", KernelShape::group);
}

TEST_F(TuningTest, RejectsAnUnknownShape) {
  const test::ScopedEnvironment blob("OFFING_SHAPE", "blob");
  test::expect_error(ErrorKind::bad_usage, "OFFING_SHAPE: expected strip or group, got \"blob\"",
                     [] { tuning_for(device(DeviceType::cpu, 16), "fft"); });
}

}  // namespace
}  // namespace offing::ocl
