// Swells and raindrops of a scene, as a simulation gets them.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/surface/ocean.h"
#include "host/ocl/device.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_hash.h"
#include "host/scene/prepare/sea.h"
#include "host/scene/prepare/world_scene.h"

namespace offing::scene {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

Scene scene_with(const std::string& more) {
  return parse_scene("version = 1\n[ocean]\nsize = 32\n" + more, "a.toml", "");
}

std::string hash_with(const std::string& more) {
  const Scene scene = scene_with(more);
  return scene_hash(scene, prepare_sea(scene), "");
}

// Fails if a period is turned into a wavelength by another relation than the water's: g T^2 / 2 pi where it
// is deep, T sqrt(g D) where it is shallow (k D = 0.02: less than 1e-4 of it), or if direction, phase and the
// default of 100 m get lost.
TEST(ExtraWaves, SwellsHaveThePeriodThatWasAsked) {
  const Sea deep =
      prepare_sea(scene_with("[[ocean.swell]]\nperiod_s = 10\nphase_deg = 90\n"
                             "[[ocean.swell]]\namplitude_m = 2\ndirection_deg = 45\n"));
  ASSERT_EQ(deep.swells.size(), 2u);
  EXPECT_NEAR(deep.swells[0].wavenumber_radpm, two_pi * two_pi / 100.0 / 9.81, 1e-9);
  EXPECT_NEAR(deep.swells[0].omega_radps, two_pi / 10.0, 1e-9);
  EXPECT_NEAR(deep.swells[0].phase_rad, two_pi / 4.0, 1e-12);
  EXPECT_EQ(deep.swells[0].amplitude_m, 0.5);
  EXPECT_NEAR(deep.swells[1].wavenumber_radpm, two_pi / 100.0, 1e-12);
  EXPECT_NEAR(deep.swells[1].direction_rad, two_pi / 8.0, 1e-12);
  EXPECT_EQ(deep.swells[1].amplitude_m, 2.0);

  const Sea shallow = prepare_sea(scene_with("depth_m = 0.1\n[[ocean.swell]]\nperiod_s = 32\n"));
  EXPECT_NEAR(two_pi / shallow.swells[0].wavenumber_radpm / (32.0 * std::sqrt(9.81 * 0.1)), 1.0, 1e-4);
}

// Fails if swells replace the spectrum's Gerstner waves, change with the seed, or if they or raindrops do not
// reach the world.
TEST(ExtraWaves, ComeBesideTheSpectrumsGerstnerWaves) {
  const Scene scene = scene_with(
      "[ocean.gerstner]\ncount = 4\n[[ocean.swell]]\namplitude_m = 0.25\n[[ocean.raindrop]]\nx_m = 7\n");
  const Sea sea = prepare_sea(scene);
  EXPECT_TRUE(sea.has_gerstner_waves());
  const ocean::GerstnerSea first = gerstner_waves_of(sea, 1), second = gerstner_waves_of(sea, 2);
  ASSERT_EQ(first.waves.size(), 5u);
  EXPECT_NE(first.waves.front().phase_rad, second.waves.front().phase_rad);
  for (const ocean::GerstnerSea& gerstner_waves :
       {first, second, prepare_world(scene).ocean.gerstner_waves}) {
    EXPECT_EQ(gerstner_waves.waves.back().amplitude_m, 0.25);
    EXPECT_EQ(gerstner_waves.waves.back().phase_rad, 0.0);
    ASSERT_EQ(gerstner_waves.raindrops.size(), 1u);
    EXPECT_EQ(gerstner_waves.raindrops[0].x_m, 7.0);
  }
  EXPECT_TRUE(prepare_sea(scene_with("[[ocean.swell]]\n")).has_gerstner_waves());
  EXPECT_TRUE(prepare_sea(scene_with("[[ocean.raindrop]]\n")).has_gerstner_waves());
  EXPECT_FALSE(prepare_sea(scene_with("")).has_gerstner_waves());
}

// Fails if the sea of a scene is sampled or composed without its long waves: without choppiness labels are
// points, and what Gerstner waves and swells add is their sum. Rounding of heights below 10 m, 1e-6 m, and of
// phases, 2e-6 of each height: gate 1e-4 m.
TEST(ExtraWaves, AreInTheSeaOfTheScene) {
  const Sea sea = prepare_sea(
      scene_with("choppiness = 0\ngerstner.count = 4\n[[ocean.swell]]\namplitude_m = 2\nphase_deg = 20\n"));
  const double time_s = 4.0;
  ocean::Ocean ocean(ocl::Device::open(), sea.spectrum, sea.parameters);
  ocean.at(time_s);
  const std::vector<ocean::WaterPoint> points{{0.0, 0.0}, {31.0, -12.5}, {-400.0, 77.0}};
  const auto composed_m = [&](const ocean::WaterPoint& point) {
    return ocean.read_composed({.origin_x_m = point.x_m, .origin_z_m = point.z_m, .columns = 1, .rows = 1})
        .displacement_y[0];
  };
  const std::vector<ocean::WaterSample> all = ocean.sample(points);
  std::vector<float> all_composed_m;
  for (const ocean::WaterPoint& point : points) all_composed_m.push_back(composed_m(point));
  ocean.set_gerstner_waves({});
  const std::vector<ocean::WaterSample> cascades = ocean.sample(points);
  const std::vector<ocean::GerstnerWave> waves = gerstner_waves_of(sea, sea.parameters.seed).waves;
  ASSERT_EQ(waves.size(), 5u);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double sum_m = 0.0;
    for (const ocean::GerstnerWave& wave : waves) {
      const double along_m =
          std::cos(wave.direction_rad) * points[i].x_m + std::sin(wave.direction_rad) * points[i].z_m;
      sum_m += wave.amplitude_m *
               std::cos(wave.wavenumber_radpm * along_m - wave.omega_radps * time_s + wave.phase_rad);
    }
    EXPECT_GT(std::abs(sum_m), 0.1) << "nothing to miss";
    EXPECT_NEAR(all[i].height_m - cascades[i].height_m, sum_m, 1e-4);
    EXPECT_NEAR(all_composed_m[i] - composed_m(points[i]), sum_m, 1e-4);
  }
}

// Fails if a ring that water cannot form is passed over in silence, or one that it can is not: 0.0706 of
// its length is the largest amplitude of a wave; or if rings hide that swells are too steep.
TEST(ExtraWaves, TooSteepRingsAreTold) {
  const auto warning = [](const std::string& more) {
    const Scene scene = scene_with(more);
    return steepness_warning(scene, gerstner_waves_of(prepare_sea(scene, Warnings::left_out), 1));
  };
  const std::string gentle = "[[ocean.raindrop]]\namplitude_m = -0.07\nwavelength_m = 1\n";
  const std::string steep = "[[ocean.raindrop]]\namplitude_m = -0.0708\nwavelength_m = 1\n";
  EXPECT_EQ(warning(gentle), "");
  EXPECT_EQ(warning(gentle + steep),
            "1 of 2 raindrops start steeper than real waves can be: a ring of wavelength_m = 1 has "
            "amplitude_m = -0.0708, and such waves break at 0.0706");
  const std::string both = warning(steep + "[[ocean.swell]]\namplitude_m = 20\n");
  EXPECT_NE(both.find("the swells have a choppiness"), std::string::npos) << both;
  EXPECT_NE(both.find("; 1 of 1 raindrops"), std::string::npos) << both;
}

// Fails if 64 swells beside 64 Gerstner waves do not fit the sea.
TEST(ExtraWaves, TheMostOfBothFit) {
  std::string text = "[ocean.gerstner]\ncount = 64\n";
  for (int i = 0; i < 64; ++i) text += "[[ocean.swell]]\namplitude_m = 0.01\n";
  const Sea sea = prepare_sea(scene_with(text));
  EXPECT_NO_THROW(ocean::require_valid_gerstner_waves(gerstner_waves_of(sea, 1)));
}

// Fails if a bake goes on with the frames of other swells or raindrops: any value, their number, and which
// element a value belongs to.
TEST(ExtraWaves, ChangeTheSceneHash) {
  const std::string drops = "[[ocean.raindrop]]\n[[ocean.raindrop]]\nx_m = 1\n";
  const std::string hash = hash_with("[[ocean.swell]]\n[[ocean.swell]]\nphase_deg = 10\n" + drops);
  EXPECT_EQ(hash, hash_with("[[ocean.swell]]\n[[ocean.swell]]\nphase_deg = 10\n" + drops));
  for (const std::string& other :
       {std::string(""), "[[ocean.swell]]\n" + drops, "[[ocean.swell]]\n[[ocean.swell]]\n" + drops,
        "[[ocean.swell]]\nphase_deg = 10\n[[ocean.swell]]\n" + drops,
        "[[ocean.swell]]\nperiod_s = 9\n[[ocean.swell]]\nphase_deg = 10\n" + drops,
        "[[ocean.swell]]\nwavelength_m = 9\n[[ocean.swell]]\nphase_deg = 10\n" + drops,
        std::string("[[ocean.swell]]\n[[ocean.swell]]\nphase_deg = 10\n[[ocean.raindrop]]\n")}) {
    EXPECT_NE(hash, hash_with(other)) << other;
  }
}

// Fails if a swell that this gravity makes shorter than waves can be is let through to the device.
TEST(ExtraWaves, RefusesAPeriodWithoutAWave) {
  EXPECT_THROW(prepare_sea(scene_with("gravity_mps2 = 0.1\n[[ocean.swell]]\nperiod_s = 0.3\n")), Error);
}

}  // namespace
}  // namespace offing::scene
