#include "host/ocl/tuning.h"

#include <array>
#include <cstddef>

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

void expect_shape(const DeviceInfo& info, std::string_view kernels, KernelShape shape) {
  EXPECT_EQ(tuning_for(info, kernels).shape, shape);
}

class TuningTest : public ::testing::Test {
 protected:
  test::ScopedEnvironment no_override_{"OFFING_SHAPE", ""};
};

TEST_F(TuningTest, GivesSimdToVectorCpus) {
  for (std::uint32_t width : {4u, 8u, 16u}) {
    expect_shape(device(DeviceType::cpu, width), "fft_columns", KernelShape::simd);
  }
}

// Fails if a device without wide vectors gets kernels that its compiler takes minutes for.
TEST_F(TuningTest, GivesWorkgroupsToAllOthers) {
  expect_shape(device(DeviceType::cpu, 1), "fft_columns", KernelShape::workgroup);
  expect_shape(device(DeviceType::gpu, 1), "fft_columns", KernelShape::workgroup);
  expect_shape(device(DeviceType::gpu, 4), "fft_columns", KernelShape::workgroup);
  expect_shape(device(DeviceType::accelerator, 0), "fft_columns", KernelShape::workgroup);
}

// Fails if a misspelt name gets sizes that suit nothing.
TEST_F(TuningTest, RejectsUnlistedKernels) {
  test::expect_error(ErrorKind::bad_usage, "tuning: expected rows for kernels \"unheard-of\", found none",
                     [] { tuning_for(device(DeviceType::cpu, 16), "unheard-of"); });
}

// Fails if a forced shape is launched with the sizes of the other one.
TEST_F(TuningTest, SizesBelongToTheShape) {
  const DeviceInfo cpu = device(DeviceType::cpu, 16), gpu = device(DeviceType::gpu, 1);
  const KernelTuning simd = tuning_for(cpu, "light_groups"), workgroup = tuning_for(gpu, "light_groups");
  EXPECT_EQ(simd.lanes, widest_lanes);
  EXPECT_EQ(simd.group, 1u);
  EXPECT_EQ(workgroup.lanes, 1);
  EXPECT_EQ(workgroup.group, 256u);
  EXPECT_EQ(tuning_for(cpu, "light_groups", KernelShape::workgroup).group, workgroup.group);
  const test::ScopedEnvironment forced("OFFING_SHAPE", "workgroup");
  EXPECT_EQ(tuning_for(cpu, "light_groups").group, workgroup.group);
  EXPECT_EQ(tuning_for(cpu, "light_groups", KernelShape::simd).group, simd.group);
}

TEST_F(TuningTest, KernelsOfOneShapeKeepIt) {
  const test::ScopedEnvironment forced("OFFING_SHAPE", "simd");
  expect_shape(device(DeviceType::cpu, 16), "body_advance", KernelShape::workgroup);
}

// Fails if a device that allows few work-items in a group refuses kernels.
TEST_F(TuningTest, GroupsStayWithinWhatTheDeviceAllows) {
  DeviceInfo small = device(DeviceType::gpu, 1);
  small.max_work_group_size = 128;
  EXPECT_EQ(tuning_for(small, "light_groups").group, 128u);
  EXPECT_EQ(tuning_for(small, "radix_sort").group, 64u);
}

// Fails if a last, incomplete share of the work is left out, or a group is not whole.
TEST_F(TuningTest, LaunchesCoverAllValuesWithWholeGroups) {
  using Sizes = std::array<std::size_t, 3>;
  const KernelTuning tuning{.lanes = 16, .group = 4, .per_item = 8};
  EXPECT_EQ(launch_shape(tuning, 128 * 4).global, (Sizes{4, 1, 0}));
  EXPECT_EQ(launch_shape(tuning, 128 * 4 + 1, 3).global, (Sizes{8, 3, 0}));
  EXPECT_EQ(launch_shape(tuning, 1).local, (Sizes{4, 0, 0}));
  EXPECT_EQ(launch_shape(KernelTuning{}, 7).global, (Sizes{7, 1, 0}));
  EXPECT_EQ(launch_shape(KernelTuning{}, 7).local, Sizes{});
}

TEST_F(TuningTest, ObeysTheOverride) {
  const test::ScopedEnvironment simd("OFFING_SHAPE", "simd");
  expect_shape(device(DeviceType::gpu, 1), "fft_columns", KernelShape::simd);
  const test::ScopedEnvironment workgroup("OFFING_SHAPE", "workgroup");
  expect_shape(device(DeviceType::cpu, 16), "fft_columns", KernelShape::workgroup);
}

// Fails if scripts with the earlier values stop working, or are not told of the new ones.
TEST_F(TuningTest, TakesTheEarlierValuesWithOneWarning) {
  const test::LogCapture log;
  const test::ScopedEnvironment strip("OFFING_SHAPE", "strip");
  expect_shape(device(DeviceType::gpu, 1), "fft_columns", KernelShape::simd);
  expect_shape(device(DeviceType::gpu, 1), "terrain_rays", KernelShape::simd);
  const test::ScopedEnvironment group("OFFING_SHAPE", "group");
  expect_shape(device(DeviceType::cpu, 16), "fft_columns", KernelShape::workgroup);
  EXPECT_EQ(log.lines(), 1u) << log.text();
  EXPECT_NE(log.text().find("OFFING_SHAPE=strip is now OFFING_SHAPE=simd"), std::string::npos) << log.text();
}

TEST_F(TuningTest, RejectsAnUnknownShape) {
  const test::ScopedEnvironment blob("OFFING_SHAPE", "blob");
  test::expect_error(ErrorKind::bad_usage, "OFFING_SHAPE: expected simd or workgroup, got \"blob\"",
                     [] { tuning_for(device(DeviceType::cpu, 16), "fft_columns"); });
}

}  // namespace
}  // namespace offing::ocl
