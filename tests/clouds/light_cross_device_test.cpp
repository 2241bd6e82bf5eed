// The same light on other OpenCL implementations, in processes of their own (cloud_light_dump.cpp), and every
// kernel of it under Oclgrind's checks of memory and of data races.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/ocl/device_dump.h"

namespace offing::clouds {
namespace {

class LightCrossDeviceTest : public testing::Test {
 protected:
  // Exponentials and roots differ by ulps, and sums over particles and cells add them up. Paths through the
  // recurrence's map and places in the shadow may take another texel at its rounding. Measured: 1.5e-3, where
  // a thin texel's clouds are; 3e-7 in the mean. Gates: 0.02 for one value, 1e-4 in the mean.
  static void expect_same(const std::vector<float>& found, const std::vector<float>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_GE(expected.size(), 2u * 4u * (30u + 70u) + 16000u);
    double sum = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_NEAR(found[i], expected[i], 0.02f * std::fmax(1.0f, std::abs(expected[i]))) << i;
      sum += std::abs(found[i] - expected[i]);
    }
    EXPECT_LT(sum / static_cast<double>(expected.size()), 1e-4);
  }

  const test::DeviceDump dump_{OFFING_DUMP};
};

// Fails if a kernel relies on what one driver does, such as its mathematics, its rounding or its vectors.
TEST_F(LightCrossDeviceTest, AllDevicesLightAlike) {
  dump_.compare_devices(expect_same);
}

// Fails if a work-item reads or writes outside a buffer, if two race for a place, or if results differ from
// those of a real device.
TEST_F(LightCrossDeviceTest, OclgrindReportsNothing) {
  dump_.compare_under_oclgrind(expect_same);
}

}  // namespace
}  // namespace offing::clouds
