#include "host/ocean/surface/water_optics.h"

#include <cmath>

#include <gtest/gtest.h>

namespace offing::ocean {
namespace {

constexpr WaterType all_types[] = {WaterType::oceanic_1, WaterType::oceanic_1a, WaterType::oceanic_1b,
                                   WaterType::oceanic_2, WaterType::oceanic_3,  WaterType::coastal_1,
                                   WaterType::coastal_3, WaterType::coastal_5,  WaterType::coastal_7,
                                   WaterType::coastal_9};

// Jerlov's order: each type takes away more blue than the one before. (Green and red do so but for one step:
// the clearest coasts are as clear there as the murkiest ocean.)
TEST(WaterOpticsTest, TypesGoFromClearToMurky) {
  double before_perm = 0.0;
  for (const WaterType type : all_types) {
    const WaterOptics optics = water_optics(type);
    EXPECT_GT(optics.attenuation_perm[2], before_perm);
    before_perm = optics.attenuation_perm[2];
    for (const double share : optics.reflectance) {
      EXPECT_GT(share, 0.0);
      EXPECT_LT(share, 0.2);  // the brightest waters that are known
    }
  }
}

// Deep water is blue in the open sea, green at clear coasts, and yellow to brown at murky ones.
TEST(WaterOpticsTest, WatersHaveTheirColours) {
  const auto [red, green, blue] = water_optics(WaterType::oceanic_1).reflectance;
  EXPECT_GT(blue, 4.0 * green);
  EXPECT_GT(green, 4.0 * red);
  const auto coast = water_optics(WaterType::coastal_1).reflectance;
  EXPECT_GT(coast[1], coast[2]);
  EXPECT_GT(coast[1], coast[0]);
  const auto murky = water_optics(WaterType::coastal_9).reflectance;
  EXPECT_GT(murky[0], 1.5 * murky[2]);
}

// By its definition: what comes back from twice the depth is half a step of 8 bits of white.
TEST(WaterOpticsTest, BedsVanishBelowTheVisibleDepth) {
  const WaterOptics optics = water_optics(WaterType::oceanic_1b);
  EXPECT_NEAR(std::exp(-2.0 * optics.attenuation_perm[2] * visible_depth_m(optics)), 0.5 / 255.0, 1e-9);
  EXPECT_LT(visible_depth_m(water_optics(WaterType::coastal_9)), 6.0);
}

}  // namespace
}  // namespace offing::ocean
