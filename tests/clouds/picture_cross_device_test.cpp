// The same picture of clouds on other OpenCL implementations, in processes of their own
// (cloud_picture_dump.cpp), and every kernel under Oclgrind's checks of memory and of data races.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/ocl/device_dump.h"

namespace offing::clouds {
namespace {

class PictureCrossDeviceTest : public testing::Test {
 protected:
  // Roots, exponentials and places of texels differ by ulps between implementations; rows of 16 pixels stop
  // together where each pixel stops by itself: up to 0.002 of the light. Measured 0.0012, 4e-6 in the mean;
  // gate 0.0025, below 1/255.
  static void expect_same(const std::vector<float>& found, const std::vector<float>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_EQ(expected.size(), 5u * 37u * 21u);
    float most_opaque = 0.0f;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_NEAR(found[i], expected[i], 2.5e-3f) << i;
      if (i % 5 == 3) most_opaque = std::fmax(most_opaque, expected[i]);
    }
    EXPECT_GT(most_opaque, 0.9f);
  }

  const test::DeviceDump dump_{OFFING_CLOUD_PICTURE_DUMP};
};

// Fails if a kernel relies on what one driver does, such as its mathematics, its rounding or its vectors.
TEST_F(PictureCrossDeviceTest, ShapesAndRusticlDrawTheSamePicture) {
  const std::vector<float> expected = dump_.values(test::DeviceDump::default_device);
  expect_same(dump_.values("OFFING_SHAPE=group OFFING_DEVICE=portable"), expected);
  if (!test::DeviceDump::has_rusticl()) {
    GTEST_SKIP() << "rusticl is not installed (mesa-opencl-icd libclc-15 libllvmspirvlib15)";
  }
  expect_same(dump_.values("RUSTICL_ENABLE=llvmpipe OFFING_DEVICE=rusticl OFFING_SHAPE=group"), expected);
}

// Fails if a work-item reads or writes outside a buffer, if two race for a place, or if results differ from
// those of a real device.
TEST_F(PictureCrossDeviceTest, OclgrindReportsNothing) {
  if (!test::DeviceDump::has_oclgrind()) GTEST_SKIP() << "oclgrind is not installed";
  const std::vector<float> expected = dump_.values(test::DeviceDump::default_device);
  for (const std::string shape : {"group", "strip"})
    expect_same(dump_.values_under_oclgrind(shape), expected);
}

}  // namespace
}  // namespace offing::clouds
