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
  // light: of 14,840 values three. Measured: none.
  static void expect_same(const std::vector<float>& found, const std::vector<float>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_FALSE(expected.empty());
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      unlike += std::abs(found[i] - expected[i]) <= 1e-3f + 1e-4f * std::abs(expected[i]) ? 0 : 1;
    }
    EXPECT_LE(unlike, 3u) << "of " << expected.size();
  }

  test::DeviceDump dump_{OFFING_TERRAIN_DUMP};
};

// Fails if a kernel relies on what one driver does, such as its mathematics, its rounding or its vectors.
TEST_F(TerrainCrossDeviceTest, AllDevicesFindTheSameGround) {
  dump_.compare_devices(expect_same);
}

// Fails if a work-item reads or writes outside a buffer, if two race for a place, or if results differ from
// those of a real device.
TEST_F(TerrainCrossDeviceTest, OclgrindReportsNothing) {
  dump_.compare_under_oclgrind(expect_same);
}

}  // namespace
}  // namespace offing::terrain
