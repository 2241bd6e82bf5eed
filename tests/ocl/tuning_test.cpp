#include "host/ocl/tuning.h"

#include <gtest/gtest.h>

#include "tests/ocl/expect_error.h"
#include "tests/ocl/log_capture.h"
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
    expect_tuning(device(DeviceType::cpu, width), "fft", KernelShape::simd);
  }
}

// Fails if a device without wide vectors gets kernels that its compiler takes minutes for.
TEST_F(TuningTest, GivesWorkgroupsToAllOthers) {
  expect_tuning(device(DeviceType::cpu, 1), "fft", KernelShape::workgroup);
  expect_tuning(device(DeviceType::gpu, 1), "fft", KernelShape::workgroup);
  expect_tuning(device(DeviceType::gpu, 4), "fft", KernelShape::workgroup);
  expect_tuning(device(DeviceType::accelerator, 0), "fft", KernelShape::workgroup);
}

TEST_F(TuningTest, GivesTheDefaultRowToAnUnlistedFamily) {
  expect_tuning(device(DeviceType::cpu, 16), "unheard-of", KernelShape::workgroup);
}

TEST_F(TuningTest, ObeysTheOverride) {
  const test::ScopedEnvironment simd("OFFING_SHAPE", "simd");
  expect_tuning(device(DeviceType::gpu, 1), "fft", KernelShape::simd);
  const test::ScopedEnvironment workgroup("OFFING_SHAPE", "workgroup");
  expect_tuning(device(DeviceType::cpu, 16), "fft", KernelShape::workgroup);
}

// Fails if scripts with the earlier values stop working, or are not told of the new ones.
TEST_F(TuningTest, TakesTheEarlierValuesWithOneWarning) {
  const test::LogCapture log;
  const test::ScopedEnvironment strip("OFFING_SHAPE", "strip");
  expect_tuning(device(DeviceType::gpu, 1), "fft", KernelShape::simd);
  expect_tuning(device(DeviceType::gpu, 1), "terrain", KernelShape::simd);
  const test::ScopedEnvironment group("OFFING_SHAPE", "group");
  expect_tuning(device(DeviceType::cpu, 16), "fft", KernelShape::workgroup);
  EXPECT_EQ(log.lines(), 1u) << log.text();
  EXPECT_NE(log.text().find("OFFING_SHAPE=strip is now OFFING_SHAPE=simd"), std::string::npos) << log.text();
}

TEST_F(TuningTest, RejectsAnUnknownShape) {
  const test::ScopedEnvironment blob("OFFING_SHAPE", "blob");
  test::expect_error(ErrorKind::bad_usage, "OFFING_SHAPE: expected simd or workgroup, got \"blob\"",
                     [] { tuning_for(device(DeviceType::cpu, 16), "fft"); });
}

}  // namespace
}  // namespace offing::ocl
