// The same ground on other OpenCL implementations, in processes of their own (ground_dump.cpp), and every
// kernel under Oclgrind's checks of memory and of data races.
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "tests/ocl/device_dump.h"

namespace offing::terrain {
namespace {

class TerrainCrossDeviceTest : public testing::Test {
 protected:
  // Roots and exponentials of two implementations differ by ulps, and distances are up to 500 m: 1e-4 of each
  // value, and 1e-3 beside it. A ray that grazes a ridge may differ by all there is, its distance or its
  // light: of 7,469 values three. Measured: none.
  static void expect_same(const std::vector<float>& found, const std::vector<float>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_FALSE(expected.empty());
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      unlike += std::abs(found[i] - expected[i]) <= 1e-3f + 1e-4f * std::abs(expected[i]) ? 0 : 1;
    }
    EXPECT_LE(unlike, 3u) << "of " << expected.size();
  }

  test::DeviceDump dump_{OFFING_GROUND_DUMP};
};

// Fails if a kernel relies on what one driver does, such as its mathematics, its rounding or its vectors.
TEST_F(TerrainCrossDeviceTest, ShapesAndRusticlFindTheSameGround) {
  const std::vector<float> expected = dump_.values(test::DeviceDump::default_device);
  expect_same(dump_.values("OFFING_SHAPE=group OFFING_DEVICE=portable"), expected);
  if (!test::DeviceDump::has_rusticl()) {
    GTEST_SKIP() << "rusticl is not installed (mesa-opencl-icd libclc-15 libllvmspirvlib15)";
  }
  expect_same(dump_.values("RUSTICL_ENABLE=llvmpipe OFFING_DEVICE=rusticl OFFING_SHAPE=group"), expected);
}

// Fails if a work-item reads or writes outside a buffer, if two race for a place, or if results differ from
// those of a real device.
TEST_F(TerrainCrossDeviceTest, OclgrindReportsNothing) {
  if (!test::DeviceDump::has_oclgrind()) GTEST_SKIP() << "oclgrind is not installed";
  const std::vector<float> expected = dump_.values(test::DeviceDump::default_device);
  for (const char* const shape : {"group", "strip"}) {
    expect_same(dump_.values_under_oclgrind(shape), expected);
  }
}

}  // namespace
}  // namespace offing::terrain
