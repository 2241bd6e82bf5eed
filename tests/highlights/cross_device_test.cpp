// The same highlights on other OpenCL implementations, in processes of their own (highlight_dump.cpp), and
// every kernel under Oclgrind's checks of memory and of data races.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/ocl/device_dump.h"

namespace offing::highlights {
namespace {

class HighlightCrossDeviceTest : public testing::Test {
 protected:
  // Roots and arc tangents of two implementations differ by ulps, 6e-8 each; the field between them is
  // divided by its change over a face, 0.1 or more, and curvatures turn by some 10 a face. Least squares lose
  // digits in a determinant. Measured 1.1e-4; gate 5e-4. Faces, lights and orientations are the same.
  static void expect_same(const std::vector<float>& found, const std::vector<float>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_GE(expected.size(), 500u);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(found[i], expected[i], 5e-4f * std::fmax(1.0f, std::abs(expected[i]))) << i;
    }
  }

  const test::DeviceDump dump_{OFFING_DUMP};
};

// Fails if a kernel relies on what one driver does, such as its mathematics, its rounding or its vectors.
TEST_F(HighlightCrossDeviceTest, AllDevicesFindTheSameHighlights) {
  dump_.compare_devices(expect_same);
}

// Fails if a work-item reads or writes outside a buffer, if two race for a place, or if results differ from
// those of a real device.
TEST_F(HighlightCrossDeviceTest, OclgrindReportsNothing) {
  dump_.compare_under_oclgrind(expect_same);
}

}  // namespace
}  // namespace offing::highlights
