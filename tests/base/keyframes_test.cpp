// Values between keys against closed forms.
#include "host/base/keyframes.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing {
namespace {

constexpr double rounding = 1e-12;

// Fails if a value is extrapolated, or a single key is not a constant.
TEST(Keyframes, HoldTheFirstAndTheLast) {
  for (const Interpolation interpolation : {Interpolation::smooth, Interpolation::linear}) {
    const KeyframeTrack track{.keys = {{1.0, 5.0}, {2.0, 7.0}, {4.0, 6.0}}, .interpolation = interpolation};
    EXPECT_EQ(value_at(track, -100.0), 5.0);
    EXPECT_EQ(value_at(track, 1.0), 5.0);
    EXPECT_EQ(value_at(track, 2.0), 7.0);
    EXPECT_EQ(value_at(track, 4.0), 6.0);
    EXPECT_EQ(value_at(track, 1e8), 6.0);
    EXPECT_EQ(value_at({.keys = {{3.0, 2.5}}, .interpolation = interpolation}, 0.0), 2.5);
  }
  EXPECT_THROW(value_at({}, 0.0), Error);
}

// Fails if straight lines are weighted wrongly.
TEST(Keyframes, LinearIsAStraightLine) {
  const KeyframeTrack track{.keys = {{0.0, 1.0}, {4.0, 3.0}, {5.0, -1.0}},
                            .interpolation = Interpolation::linear};
  EXPECT_NEAR(value_at(track, 1.0), 1.5, rounding);
  EXPECT_NEAR(value_at(track, 4.25), 2.0, rounding);
}

// Fails if the smooth way bends where its keys lie on a line: uneven times included.
TEST(Keyframes, SmoothKeepsALine) {
  KeyframeTrack track;
  for (const double time_s : {0.0, 0.3, 2.0, 2.1, 7.0}) track.keys.push_back({time_s, 4.0 - 3.0 * time_s});
  for (double time_s = 0.0; time_s <= 7.0; time_s += 0.05) {
    EXPECT_NEAR(value_at(track, time_s), 4.0 - 3.0 * time_s, rounding);
  }
  EXPECT_NEAR(value_at({.keys = {{0.0, 1.0}, {2.0, 5.0}}}, 0.5), 2.0, rounding);
}

// Fails if a slope is wrong. Pieces of lengths 1, 2, 1 and secants 1, 1/2, 3: the inner slopes are 9 / (5 / 1
// + 4 / 0.5) and 9 / (4 / 0.5 + 5 / 3), the outer ones (4 - 0.5) / 3 and (12 - 0.5) / 3; in the middle of a
// piece the cubic is the mean of its ends and an eighth of its length times the difference of its slopes.
TEST(Keyframes, SmoothHasTheSlopesOfItsFormula) {
  const KeyframeTrack track{.keys = {{0.0, 0.0}, {1.0, 1.0}, {3.0, 2.0}, {4.0, 5.0}}};
  const double first = 3.5 / 3.0, second = 9.0 / 13.0, third = 27.0 / 29.0, fourth = 11.5 / 3.0;
  EXPECT_NEAR(value_at(track, 0.5), 0.5 + (first - second) / 8.0, rounding);
  EXPECT_NEAR(value_at(track, 2.0), 1.5 + 2.0 * (second - third) / 8.0, rounding);
  EXPECT_NEAR(value_at(track, 3.5), 3.5 + (third - fourth) / 8.0, rounding);
  // Turning values: level at the key between, and three times the secant of 1 at most before it, where the
  // parabola's slope is (2 * 1 + 0.1) * 1 - 1 * -50 over 1.1.
  const KeyframeTrack turning{.keys = {{0.0, 0.0}, {1.0, 1.0}, {1.1, -4.0}}};
  EXPECT_NEAR(value_at(turning, 0.5), 0.5 + 3.0 / 8.0, rounding);
}

// Fails if a value goes beyond its two keys, turns between them or jumps, or its speed jumps at a key, for
// 2000 random tracks. Speeds are differences over 1e-6 of the shortest piece; they are off by the second
// derivative (at most 8 secants a piece's length) times that.
TEST(Keyframes, SmoothNeverTurnsBetweenKeysNorJumps) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> length_s(0.1, 3.0), value(-10.0, 10.0);
  for (int trial = 0; trial < 2000; ++trial) {
    KeyframeTrack track;
    double time_s = -4.0;
    for (int i = 0; i < 5; ++i) track.keys.push_back({time_s += length_s(random), value(random)});
    for (std::size_t i = 0; i + 1 < track.keys.size(); ++i) {
      const Keyframe &from = track.keys[i], &to = track.keys[i + 1];
      const double sign = to.value < from.value ? -1.0 : 1.0;
      double previous = from.value;
      for (int step = 1; step <= 32; ++step) {
        const double now = value_at(track, std::lerp(from.time_s, to.time_s, step / 32.0));
        ASSERT_GE(sign * (now - previous), -rounding);
        previous = now;
      }
      ASSERT_NEAR(previous, to.value, rounding);
      if (i == 0) continue;
      constexpr double tiny_s = 1e-7;
      const double before = (from.value - value_at(track, from.time_s - tiny_s)) / tiny_s;
      const double after = (value_at(track, from.time_s + tiny_s) - from.value) / tiny_s;
      ASSERT_NEAR(before, after, 0.005);  // 2 * 8 * (20 / 0.1) / 0.1 * 1e-7 = 0.0032, and rounding
    }
  }
}

// Fails if an angle goes the long way round, or half a turn against its numbers.
TEST(Keyframes, AnglesGoTheShorterWay) {
  const auto angle = [](std::vector<Keyframe> keys, Interpolation interpolation, double time_s) {
    return value_at({.keys = std::move(keys), .interpolation = interpolation, .period = 360.0}, time_s);
  };
  for (const Interpolation interpolation : {Interpolation::smooth, Interpolation::linear}) {
    EXPECT_NEAR(angle({{0.0, 350.0}, {1.0, 10.0}}, interpolation, 0.25), 355.0, rounding);
    EXPECT_NEAR(angle({{0.0, 10.0}, {1.0, -10.0}}, interpolation, 0.5), 0.0, rounding);
    EXPECT_NEAR(angle({{0.0, -170.0}, {1.0, 170.0}}, interpolation, 0.5), -180.0, rounding);
    EXPECT_NEAR(angle({{0.0, 0.0}, {1.0, 180.0}}, interpolation, 0.5), 90.0, rounding);
    EXPECT_NEAR(angle({{0.0, 180.0}, {1.0, 0.0}}, interpolation, 0.5), 90.0, rounding);
    // A whole turn in thirds, at an even speed through the place where the numbers start again.
    EXPECT_NEAR(angle({{0.0, 0.0}, {1.0, 120.0}, {2.0, -120.0}, {3.0, 0.0}}, interpolation, 1.75), 210.0,
                rounding);
    EXPECT_NEAR(angle({{0.0, 0.0}, {1.0, 120.0}, {2.0, -120.0}, {3.0, 0.0}}, interpolation, 2.5) + 360.0,
                300.0, rounding);
  }
}

}  // namespace
}  // namespace offing
