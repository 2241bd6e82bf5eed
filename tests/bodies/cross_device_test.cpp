// The same bodies on other OpenCL implementations, in processes of their own (body_dump.cpp), and every
// kernel under Oclgrind's checks of memory and of data races.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/ocl/device_dump.h"

namespace offing::bodies {
namespace {

class BodyCrossDeviceTest : public testing::Test {
 protected:
  // Sums of 200 faces differ in their order and in ulps, 6e-8 each; over 16 sub-steps of a stable body they
  // grow by a few. Gate 1e-4 of metres, metres a second and radians. What is pressed aside is summed from
  // columns of a map: one of 16 samples that falls on another column where two devices round otherwise
  // changes a cell by a sixteenth of the step between columns, 0.1 m at the most; gate 1e-2.
  static void expect_same(const std::vector<float>& found, const std::vector<float>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_EQ(expected.size(), 52u + 32u * 32u);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const float gate = i < 52 ? 1e-4f : 1e-2f;
      EXPECT_NEAR(found[i], expected[i], gate * std::fmax(1.0f, std::abs(expected[i]))) << i;
    }
  }

  const test::DeviceDump dump_{OFFING_DUMP};
};

// Fails if a kernel relies on what one driver does.
TEST_F(BodyCrossDeviceTest, AllDevicesMoveThemAlike) {
  dump_.compare_devices(expect_same);
}

// Fails if a work-item reads or writes outside a buffer, or if two race for a place.
TEST_F(BodyCrossDeviceTest, OclgrindReportsNothing) {
  dump_.compare_under_oclgrind(expect_same);
}

}  // namespace
}  // namespace offing::bodies
