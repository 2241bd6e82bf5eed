// The swash against the formulas of Stockdon et al. 2006 and its own statistics.
#include "host/ocean/surface/swash.h"

#include <cmath>

#include <gtest/gtest.h>

namespace offing::ocean {
namespace {

constexpr double slope = 0.1, height_m = 1.6, omega_radps = 0.8;

/// Waves of one length in deep water, 1.6 m high.
SeaBands sea() {
  SeaBands bands;
  bands.bands[0] = {.variance_m2 = height_m * height_m / 16.0,
                    .wavenumber_radpm = omega_radps * omega_radps / 9.81};
  return bands;
}

// Fails if the swash reaches another height than equation 19 has for this sea, whose peak period is 1.1 times
// the period of its waves: set-up and swash of 1.6 m over 89 m of deep water on a slope of 0.1.
TEST(SwashTest, ReachesWhatStockdonMeasured) {
  const Swash swash({}, sea(), slope, 0.3, 1);
  const double period_s = 1.1 * two_pi / omega_radps, length_m = 9.81 * period_s * period_s / two_pi;
  const double root_m = std::sqrt(height_m * length_m);
  EXPECT_NEAR(swash.setup_m(), 0.35 * slope * root_m, 1e-9);
  const double expected_m =
      1.1 * (0.35 * slope * root_m + 0.5 * root_m * std::sqrt(0.563 * slope * slope + 0.004));
  // 0.75^2 and 0.06^2 are 0.563 and 0.004 but for rounding: 1 %.
  EXPECT_NEAR(swash.reach_m(), expected_m, 0.02 * expected_m);
  EXPECT_DOUBLE_EQ(Swash({}, SeaBands{}, slope, 0.3, 1).reach_m(), 0.0);
}

// Fails if the edge moves more or less than its significant height says, or about another mean: over 4 hours
// of 8 waves, whose beats of two leave some 2 % of the deviation.
TEST(SwashTest, MovesByItsSignificantHeight) {
  const Swash swash({}, sea(), slope, 0.3, 1);
  double sum_m = 0.0, squares_m2 = 0.0, highest_m = 0.0;
  constexpr int count = 30000;
  for (int i = 0; i < count; ++i) {
    const double level_m = swash.level_m(12.0, -70.0, 0.48 * i) - swash.setup_m();
    sum_m += level_m / count;
    squares_m2 += level_m * level_m / count;
    highest_m = std::max(highest_m, std::abs(level_m));
  }
  const double expected_m = 0.25 * 2.0 * (swash.reach_m() / 1.1 - swash.setup_m());
  EXPECT_NEAR(sum_m, 0.0, 0.03 * expected_m);
  EXPECT_NEAR(std::sqrt(squares_m2), expected_m, 0.06 * expected_m);
  EXPECT_LT(highest_m + swash.setup_m(), swash.farthest_m());
}

// Fails if the parameters that kernels and shaders take are those of another place or moment: their sum in
// single precision, from 500 km off the origin and after a day, within 1e-4 of the reach.
TEST(SwashTest, ParametersAreThoseOfThePlaceAndTime) {
  const Swash swash({}, sea(), slope, 0.3, 1);
  const double x_m = 5e5, z_m = -4e5, time_s = 86400.0, earlier_s = 2.5;
  const SwashParams params = swash.at(x_m, z_m, time_s);
  const float east_m = 31.0f, south_m = -12.0f;
  float level_m = params.setup_m;
  for (int i = 0; i < SWASH_WAVES; ++i) {
    const float turn = params.phase_rad[i] - params.kx_radpm[i] * east_m - params.kz_radpm[i] * south_m -
                       params.omega_radps[i] * static_cast<float>(earlier_s);
    level_m += params.amplitude_m[i] * std::cos(turn + SWASH_SKEW * std::cos(turn));
  }
  EXPECT_NEAR(static_cast<double>(level_m), swash.level_m(x_m + 31.0, z_m - 12.0, time_s - earlier_s),
              1e-4 * swash.reach_m());
}

}  // namespace
}  // namespace offing::ocean
