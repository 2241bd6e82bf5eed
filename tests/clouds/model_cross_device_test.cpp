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

  const test::DeviceDump dump_{OFFING_CLOUD_MODEL_DUMP};
};

// Fails if a kernel relies on what one driver does, such as its mathematics, its rounding or its vectors.
TEST_F(CloudModelCrossDeviceTest, ShapesAndRusticlMakeTheSameClouds) {
  const std::vector<float> expected = dump_.values(test::DeviceDump::default_device);
  expect_same(dump_.values("OFFING_SHAPE=group OFFING_DEVICE=portable"), expected);
  if (!test::DeviceDump::has_rusticl()) {
    GTEST_SKIP() << "rusticl is not installed (mesa-opencl-icd libclc-15 libllvmspirvlib15)";
  }
  expect_same(dump_.values("RUSTICL_ENABLE=llvmpipe OFFING_DEVICE=rusticl OFFING_SHAPE=group"), expected);
}

// Fails if a work-item reads or writes outside a buffer, if two race for a place, or if results differ from
// those of a real device.
TEST_F(CloudModelCrossDeviceTest, OclgrindReportsNothing) {
  if (!test::DeviceDump::has_oclgrind()) GTEST_SKIP() << "oclgrind is not installed";
  const std::vector<float> expected = dump_.values(test::DeviceDump::default_device);
  for (const std::string shape : {"group", "strip"})
    expect_same(dump_.values_under_oclgrind(shape), expected);
}

}  // namespace
}  // namespace offing::clouds
