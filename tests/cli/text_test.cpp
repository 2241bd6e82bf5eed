#include <numbers>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/cli/common/direction_text.h"

namespace offing::cli {
namespace {

using std::numbers::pi;

// Fails if a nautical bearing has the wrong zero, sense or wrap: a sea that travels east comes from the west,
// 270.
TEST(DirectionText, ConvertsToBearings) {
  EXPECT_DOUBLE_EQ(direction_deg(0.0, DirectionStyle::from_bearing), 270.0);
  EXPECT_DOUBLE_EQ(direction_deg(pi / 2, DirectionStyle::from_bearing),
                   0.0);  // travels south, comes from the north
  EXPECT_DOUBLE_EQ(direction_deg(-pi / 2, DirectionStyle::from_bearing), 180.0);
  EXPECT_DOUBLE_EQ(direction_deg(-pi / 2, DirectionStyle::travel), 270.0);
  EXPECT_LT(direction_deg(-1e-18, DirectionStyle::travel), 360.0);
}

// Fails if a bearing that was asked for is not the one that is told: north comes as 0 and as 360.
TEST(DirectionText, ReadsBearings) {
  EXPECT_EQ(travel_deg(290.0), 20.0);
  EXPECT_EQ(travel_deg(0.0), 90.0);
  EXPECT_EQ(travel_deg(360.0), 90.0);
  for (double bearing_deg = 0.0; bearing_deg < 360.0; bearing_deg += 15.0) {
    EXPECT_NEAR(direction_deg(travel_deg(bearing_deg) * pi / 180.0, DirectionStyle::from_bearing),
                bearing_deg, 1e-9);
  }
}

// Fails if the difference of two directions jumps across north, or loses its sign.
TEST(DirectionText, DifferencesWrap) {
  EXPECT_NEAR(direction_difference_rad(0.1, 2 * pi - 0.1), 0.2, 1e-12);
  EXPECT_NEAR(direction_difference_rad(2 * pi - 0.1, 0.1), -0.2, 1e-12);
}

// Fails if a hostile name can break the two-line form of errors or reach the terminal.
TEST(ErrorReport, KeepsOneLine) {
  EXPECT_EQ(one_line("a\nb\x1b[2J\x7f"), "a\\x0ab\\x1b[2J\\x7f");
  EXPECT_EQ(one_line("\xc3\xa9t\xc3\xa9"), "\xc3\xa9t\xc3\xa9");
}

// Fails if durations lose or round up a unit.
TEST(Progress, WritesDurations) {
  EXPECT_EQ(duration_text(-1.0), "0 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(59.6), "1 min 00 s");
  EXPECT_EQ(duration_text(3599.9), "1 h 00 min");
}

}  // namespace
}  // namespace offing::cli
