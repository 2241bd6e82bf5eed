// The sun's direct light under a clear sky, against pvlib's.
#include "host/sky/direct_sunlight.h"

#include <numbers>

#include <gtest/gtest.h>

namespace offing::sky {
namespace {

// pvlib 0.16.1: clearsky.ineichen() with dni_extra = 1361, the air mass "kastenyoung1989" and alt2pres(). The
// formulas are the same: printed to 0.01 W/m^2, half of which is the gate. Fails if a term is mistyped, or if
// the correction at low sun and clear air is left out.
TEST(DirectSunlightTest, IsThatOfPvlib) {
  struct Case {
    double elevation_deg, height_m, turbidity, expected_w_per_m2;
  };
  const Case cases[] = {
      {90, 0, 3, 940.18}, {90, 2500, 2, 1129.48}, {90, 4000, 4, 1077.22}, {90, 100, 6, 723.38},
      {60, 0, 3, 914.43}, {60, 2500, 2, 1117.98}, {60, 4000, 4, 1050.27}, {60, 100, 6, 675.42},
      {30, 0, 3, 786.07}, {30, 2500, 2, 1057.37}, {30, 4000, 4, 914.87},  {30, 100, 6, 464.82},
      {15, 0, 3, 566.63}, {15, 2500, 2, 916.60},  {15, 4000, 4, 678.62},  {15, 100, 6, 207.04},
      {5, 0, 3, 176.09},  {5, 2500, 2, 519.83},   {5, 4000, 4, 233.59},   {5, 100, 6, 11.54},
      {1, 0, 3, 9.88},    {1, 2500, 2, 128.44},   {1, 4000, 4, 16.86},    {1, 100, 6, 0.01}};
  for (const Case& at : cases) {
    const double elevation_rad = at.elevation_deg * std::numbers::pi / 180.0;
    EXPECT_NEAR(direct_sunlight_w_per_m2(elevation_rad, at.height_m, 1.0, at.turbidity), at.expected_w_per_m2,
                0.00501)
        << at.elevation_deg << " degrees, " << at.height_m << " m, turbidity " << at.turbidity;
  }
}

// Light falls off with the square of the distance, and there is none from below the horizon.
TEST(DirectSunlightTest, FallsWithTheDistanceAndEndsAtTheHorizon) {
  EXPECT_NEAR(direct_sunlight_w_per_m2(0.5, 0.0, 1.0167, 3.0) * 1.0167 * 1.0167,
              direct_sunlight_w_per_m2(0.5, 0.0, 1.0, 3.0), 1e-9);
  EXPECT_EQ(direct_sunlight_w_per_m2(0.0, 0.0, 1.0, 3.0), 0.0);
  EXPECT_EQ(direct_sunlight_w_per_m2(-0.1, 3000.0, 1.0, 3.0), 0.0);
}

}  // namespace
}  // namespace offing::sky
