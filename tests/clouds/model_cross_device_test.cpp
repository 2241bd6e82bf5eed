// The same clouds on other OpenCL implementations, in processes of their own (cloud_model_dump.cpp), and
// every kernel of their modelling under Oclgrind's checks of memory and of data races.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/ocl/device_dump.h"

namespace offing::clouds {
namespace {

class CloudModelCrossDeviceTest : public testing::Test {
 protected:
  // Products that one implementation fuses and another does not differ by 6e-8; of places of some 300 m that
  // is 2e-5 m, of densities a few 1e-6, and masses of 1e3 m^2 follow their places by 1 % a metre. Gate 2e-5
  // of what is above 1.
  static void expect_same(const std::vector<float>& found, const std::vector<float>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_GE(expected.size(), 1000u);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_NEAR(found[i], expected[i], 2e-5f * std::fmax(1.0f, std::abs(expected[i]))) << i;
    }
  }

  const test::DeviceDump dump_{OFFING_DUMP};
};

// Fails if a kernel relies on what one driver does, such as its mathematics, its rounding or its vectors.
TEST_F(CloudModelCrossDeviceTest, AllDevicesMakeTheSameClouds) {
  dump_.compare_devices(expect_same);
}

// Fails if a work-item reads or writes outside a buffer, if two race for a place, or if results differ from
// those of a real device.
TEST_F(CloudModelCrossDeviceTest, OclgrindReportsNothing) {
  dump_.compare_under_oclgrind(expect_same);
}

}  // namespace
}  // namespace offing::clouds
