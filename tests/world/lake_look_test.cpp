// What lakes look like by their wind.
#include "host/world/lake_look.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

namespace offing::world {
namespace {

terrain::LakeLook look_at(double wind_mps) {
  const auto lake = std::make_shared<const terrain::Lake>(terrain::Lake{.area_m2 = 1e6});
  return look_of_lake({.lake = lake, .wind = {.wind_speed_mps = wind_mps}}, {0.0, 10.0, 0.0}, 0.0, {}, 0.5);
}

// Fails if a wind that scenes may give makes slopes that are no numbers, or if waves of hardly any wind are
// not near a mirror. Before: from 1e-153 m/s down all slopes were NaN.
TEST(LakeLookTest, HasSlopesInAnyWind) {
  for (const double wind_mps : {0.0, 1e-300, 1e-200, 1e-153, 1e-100, 1e-9, 0.9e-3, 1e-3, 0.1, 2.0, 30.0}) {
    const terrain::LakeLook look = look_at(wind_mps);
    EXPECT_GE(look.water.ripples_xx, 0.0f) << wind_mps;
    EXPECT_GE(look.water.ripples_zz, 0.0f) << wind_mps;
    EXPECT_TRUE(std::isfinite(look.water.ripples_xz)) << wind_mps;
    float mean_square = look.water.ripples_xx + look.water.ripples_zz;
    for (const LakeWave& wave : look.waves) {
      EXPECT_TRUE(std::isfinite(wave.kx_radpm + wave.kz_radpm + wave.phase_rad)) << wind_mps;
      mean_square += 0.5f * wave.slope * wave.slope;
    }
    EXPECT_TRUE(std::isfinite(mean_square)) << wind_mps;
    if (wind_mps <= 1e-3) {
      EXPECT_LT(mean_square, 1e-5f) << wind_mps;
    }
    if (wind_mps == 2.0) {
      EXPECT_GT(mean_square, 5e-3f);
    }
  }
}

}  // namespace
}  // namespace offing::world
