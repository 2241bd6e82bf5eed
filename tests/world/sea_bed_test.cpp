// The bed that a world's waves feel, and the worlds that have one.
#include "host/world/sea_bed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/terrain/field/terrain_posts.h"
#include "host/world/world.h"
#include "kernels/shared/shoal_params.h"

namespace offing::world {
namespace {

/// Heights by a function of the place from the first post.
template <class Height>
TerrainParameters terrain_of(int posts, double spacing_m, Height height_m) {
  HeightMap map;
  map.columns = map.rows = posts;
  map.spacing_x_m = map.spacing_z_m = spacing_m;
  for (int row = 0; row < posts; ++row) {
    for (int column = 0; column < posts; ++column) {
      map.heights_m.push_back(static_cast<float>(height_m(spacing_m * column, spacing_m * row)));
    }
  }
  TerrainParameters terrain;
  terrain.map = std::make_shared<const HeightMap>(std::move(map));
  terrain.origin_x_m = -300.0;
  terrain.origin_z_m = 50.0;
  return terrain;
}

/// Hills and troughs between 25 m above and 35 m below the water, nowhere steeper than 1 : 3.
double hills_m(double x_m, double z_m) {
  return -5.0 + 20.0 * std::sin(x_m / 130.0) * std::cos(z_m / 170.0) + 4.0 * std::sin((x_m + z_m) / 60.0);
}

// Fails if a gentle bed is felt at another depth or place than it has: all posts are kept.
TEST(SeaBed, IsTheGroundWhereItIsGentle) {
  const TerrainParameters terrain = terrain_of(200, 5.0, hills_m);
  const ocean::DepthMap bed = sea_bed(terrain, 0.0), raised = sea_bed(terrain, 3.0);
  EXPECT_EQ(bed.columns, 200);
  int compared = 0;
  for (double x_m = -299.0; x_m < 600.0; x_m += 7.3) {
    const auto below = terrain::terrain_at(*terrain.map, x_m + 300.0, 201.7);
    if (below->height_m > -4.0) continue;
    EXPECT_NEAR(bed.depth_m(x_m, 251.7), -below->height_m, 1e-4);
    EXPECT_NEAR(raised.depth_m(x_m, 251.7), 3.0 - below->height_m, 1e-4);
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

// Fails if a bed that had to be made coarser, or was too steep, is deeper anywhere than the ground is, so
// that waves would run through it.
TEST(SeaBed, IsNowhereDeeperThanTheGround) {
  const auto steep_m = [](double x_m, double z_m) { return 3.0 * hills_m(7.0 * x_m, 5.0 * z_m); };
  const TerrainParameters terrain = terrain_of(2100, 1.0, steep_m);
  const ocean::DepthMap bed = sea_bed(terrain, 0.0);
  EXPECT_EQ(bed.columns, 701);
  EXPECT_DOUBLE_EQ(bed.spacing_x_m, 3.0);
  std::mt19937_64 generator(4);
  for (int i = 0; i < 20000; ++i) {
    const double x_m = static_cast<double>(generator() >> 11) * 0x1p-53 * 2098.0;
    const double z_m = static_cast<double>(generator() >> 11) * 0x1p-53 * 2098.0;
    const double depth_m = bed.depth_m(x_m - 300.0, z_m + 50.0);
    const double height_m = terrain::terrain_at(*terrain.map, x_m, z_m)->height_m;
    ASSERT_LE(depth_m, std::max(-height_m, 0.0) + 1e-4) << x_m << " " << z_m;
  }
}

// Fails if a mountain keeps the sea calm for as far as it is high.
TEST(SeaBed, MindsNoHeightOfLand) {
  const ocean::DepthMap bed =
      sea_bed(terrain_of(50, 10.0, [](double x_m, double) { return x_m < 100.0 ? 900.0 : -80.0; }), 0.0);
  EXPECT_NEAR(bed.depth_m(-300.0 + 105.0, 100.0), 2.5, 1e-4);
  EXPECT_NEAR(bed.depth_m(-300.0 + 200.0, 100.0), SHOAL_STEEPEST * 100.0, 5.1);
  EXPECT_LE(bed.depth_m(-300.0 + 89.0, 100.0), 0.0);
}

WorldParameters sea() {
  ocean::SpectrumParameters spectrum;
  spectrum.wind_speed_mps = 9.0;
  spectrum.fetch_m = 30e3;
  WorldParameters result;
  result.spectrum = ocean::make_sea_spectrum(spectrum);
  result.ocean.size = 32;
  const std::array lengths{120.0};
  result.ocean.cascades = ocean::cascades_from_patches(lengths, result.ocean.size);
  result.ocean.gerstner_waves.waves = {
      ocean::make_swell({.amplitude_m = 0.4, .wavelength_m = 70.0}, result.spectrum.dispersion)};
  return result;
}

std::vector<float> heights_of(World& world) {
  world.at(6.0, 10.0);
  std::vector<ocean::WaterPoint> points;
  for (int i = 0; i < 60; ++i) points.push_back({-290.0 + 16.0 * i, 300.0 + 3.0 * i});
  std::vector<float> heights_m;
  for (const ocean::WaterSample& sample : world.sample(points)) heights_m.push_back(sample.height_m);
  return heights_m;
}

// Fails if a world's water runs through its ground, or a world that was changed while it ran shoals otherwise
// than one that was made so: ground, sea, swells.
TEST(SeaBed, WavesOfAWorldFeelIt) {
  const ocl::Device device = ocl::Device::open();
  WorldParameters parameters = sea();
  World world(device, parameters);
  const std::vector<float> open = heights_of(world);
  EXPECT_EQ(world.shoals(), nullptr);
  const auto expect_as_new = [&](const char* what) {
    World fresh(device, parameters);
    EXPECT_EQ(heights_of(world), heights_of(fresh)) << what;
  };

  parameters.terrain = terrain_of(200, 5.0, hills_m);
  world.set_terrain(parameters.terrain);
  const std::vector<float> shoaled = heights_of(world);
  EXPECT_NE(shoaled, open);
  int dry = 0;
  for (std::size_t i = 0; i < shoaled.size(); ++i) {
    const auto below = world.terrain()->terrain_at(-290.0 + 16.0 * static_cast<double>(i),
                                                   300.0 + 3.0 * static_cast<double>(i));
    if (below && below->height_m > 0.0) {
      EXPECT_EQ(shoaled[i], 0.0f);
      ++dry;
    }
  }
  EXPECT_GT(dry, 10);
  expect_as_new("ground");
  parameters.ocean.gerstner_waves.waves[0].amplitude_m = 1.5;
  world.set_gerstner_waves(parameters.ocean.gerstner_waves);
  expect_as_new("swell");
  parameters.ocean.choppiness = 0.3;
  world.set_sea(parameters);
  expect_as_new("sea");
  parameters.terrain->origin_x_m += 40.0;
  world.set_terrain(parameters.terrain);
  expect_as_new("place of the ground");
  parameters.has_shoals = false;
  world.set_sea(parameters);
  EXPECT_EQ(world.shoals(), nullptr);
  expect_as_new("no shoals");
  parameters.has_shoals = true;
  world.set_sea(parameters);
  EXPECT_NE(world.shoals(), nullptr);
  parameters.terrain = std::nullopt;
  world.set_terrain({});
  EXPECT_EQ(world.shoals(), nullptr);
  expect_as_new("no ground");
}

// Fails if a swell that grows over shoals grows out of the slab that pictures look for water in: that of 10
// cm is up to 1.4 times as high before it breaks.
TEST(SeaBed, ReachGrowsWithSwell) {
  const ocl::Device device = ocl::Device::open();
  WorldParameters parameters = sea();
  parameters.ocean.cascades = {{.patch_length_m = 10.0, .k_min_radpm = 8.0, .k_max_radpm = 9.0}};
  parameters.ocean.gerstner_waves.waves = {
      ocean::make_swell({.amplitude_m = 0.1, .wavelength_m = 150.0}, parameters.spectrum.dispersion)};
  World world(device, parameters);
  const double open_m = world.reach().vertical_m;
  parameters.terrain = terrain_of(200, 5.0, hills_m);
  world.set_terrain(parameters.terrain);
  const double reach_m = world.reach().vertical_m;
  EXPECT_GT(reach_m, 1.3 * open_m);
  double highest_m = 0.0;
  for (int i = 0; i < 12; ++i) {
    world.at(i, 10.0);
    std::vector<ocean::WaterPoint> points;
    for (int j = 0; j < 500; ++j) points.push_back({-290.0 + 1.9 * j, 50.0 + 1.7 * j});
    for (const ocean::WaterSample& sample : world.sample(points)) {
      highest_m = std::max(highest_m, std::abs(1.0 * sample.height_m));
    }
  }
  EXPECT_GT(highest_m, open_m);
  EXPECT_LT(highest_m, reach_m);
}

// Fails if ground that no wave feels costs anything.
TEST(SeaBed, OfTheDeepSeaIsNone) {
  WorldParameters parameters = sea();
  parameters.terrain = terrain_of(20, 50.0, [](double, double) { return -500.0; });
  EXPECT_EQ(World(ocl::Device::open(), parameters).shoals(), nullptr);
}

}  // namespace
}  // namespace offing::world
