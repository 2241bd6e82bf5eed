// Smallest clearances of lines of sight, against fine samples along the line.
#include "host/terrain/analysis/sight_clearance.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing::terrain {
namespace {

/// Bumps of 60 m, posts 25 and 40 m apart.
HeightMap bumpy_map() {
  HeightMap map{.columns = 61,
                .rows = 41,
                .spacing_x_m = 25.0,
                .spacing_z_m = 40.0,
                .heights_m = {},
                .is_void = {},
                .georeference = {}};
  std::mt19937 random(5);
  std::uniform_real_distribution<float> height_m(0.0f, 60.0f);
  for (int i = 0; i < map.columns * map.rows; ++i) map.heights_m.push_back(height_m(random));
  return map;
}

/// A place on a line, and the line's height above the ground there.
struct Sample {
  double along_m, clearance_m;
};

std::vector<Sample> samples_of(const HeightMap& map, const EarthCurve& curve, const SightEnd& from,
                               const SightEnd& to, int count) {
  const double plan_m = std::hypot(to.x_m - from.x_m, to.z_m - from.z_m);
  const double from_m = terrain_at(map, from.x_m, from.z_m)->height_m + from.height_m;
  // The target lies lower by the curve.
  const double to_m =
      terrain_at(map, to.x_m, to.z_m)->height_m + to.height_m - curve.bend_perm() * plan_m * plan_m;
  const double distance_m = std::hypot(plan_m, to_m - from_m);
  std::vector<Sample> samples;
  for (int i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) / count;
    const double x_m = std::lerp(from.x_m, to.x_m, t), z_m = std::lerp(from.z_m, to.z_m, t);
    const double fallen_m = terrain_at(map, x_m, z_m)->height_m - curve.bend_perm() * plan_m * plan_m * t * t;
    samples.push_back({t * distance_m, std::lerp(from_m, to_m, t) - fallen_m});
  }
  return samples;
}

// Fails if a sample is nearer to the ground than the smallest clearance, or no sample is as near: 20,000
// samples of 1.5 km on slopes of up to 2.4 + 1.5 miss it by at most 0.15 m.
TEST(SightClearance, IsTheSmallestOfSamples) {
  const HeightMap map = bumpy_map();
  const TerrainPosts posts = posts_of(map);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> x(0.0, 1500.0), z(0.0, 1600.0), height(0.0, 80.0);
  for (int i = 0; i < 60; ++i) {
    const EarthCurve curve{i % 2 == 0 ? 20000.0 : EarthCurve{}.radius_m, 0.0};
    const SightEnd from{"from", x(random), z(random), height(random)};
    // Some along an axis, and some to a post.
    const SightEnd to{"to",
                      i % 5 == 0   ? from.x_m
                      : i % 7 == 0 ? 250.0
                                   : x(random),
                      z(random), height(random)};
    const SightClearance found = sight_clearance(posts, curve, from, to);
    const std::vector<Sample> samples = samples_of(map, curve, from, to, 20000);
    const Sample lowest = *std::ranges::min_element(samples, {}, &Sample::clearance_m);
    EXPECT_LE(found.clearance_m, lowest.clearance_m + 1e-9) << i;
    EXPECT_GE(found.clearance_m, lowest.clearance_m - 0.15) << i;
    EXPECT_NEAR(terrain_at(map, found.x_m, found.z_m)->height_m, found.ground_m, 1e-9) << i;
    const std::vector<Sample> there = samples_of(map, curve, from, to, 1);
    const double t = found.at_m / there.back().along_m;
    EXPECT_NEAR(found.x_m, std::lerp(from.x_m, to.x_m, t), 1e-6) << i;
  }
}

// Level ground and two masts of 50 m, 10 km apart: the zone of 300 MHz is sqrt(0.99931 m 5 km 5 km / 10 km)
// = 49.98 m wide in the middle, where the clearance is 50 m. With a wall of 20 m there it is 30 m.
TEST(SightClearance, FresnelZoneOfLevelGround) {
  HeightMap map{.columns = 101,
                .rows = 3,
                .spacing_x_m = 100.0,
                .spacing_z_m = 100.0,
                .heights_m = {},
                .is_void = {},
                .georeference = {}};
  map.heights_m.assign(303, 0.0f);
  const SightEnd from{"from", 0.0, 100.0, 50.0}, to{"to", 10000.0, 100.0, 50.0};
  const double radius_m = std::sqrt(299792458.0 / 300e6 * 5000.0 * 5000.0 / 10000.0);
  const FresnelClearance level = fresnel_clearance(posts_of(map), {}, from, to, 300e6);
  EXPECT_NEAR(level.share, 50.0 / radius_m, 1e-6);
  EXPECT_NEAR(level.at_m, 5000.0, 1.0);
  EXPECT_NEAR(level.radius_m, radius_m, 1e-6);
  for (int row = 0; row < 3; ++row) map.heights_m[map.index(50, row)] = 20.0f;
  EXPECT_NEAR(fresnel_clearance(posts_of(map), {}, from, to, 300e6).share, 30.0 / radius_m, 1e-4);
  EXPECT_NEAR(sight_clearance(posts_of(map), {}, from, to).clearance_m, 30.0, 1e-9);
}

// Fails if a share is above that of a sample: over bumps, by more than the 1e-4 that is stated.
TEST(SightClearance, FresnelShareIsTheSmallestOfSamples) {
  const HeightMap map = bumpy_map();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(0.0, 1500.0), z(0.0, 1600.0), height(5.0, 80.0);
  for (int i = 0; i < 30; ++i) {
    const SightEnd from{"from", x(random), z(random), height(random)},
        to{"to", x(random), z(random), height(random)};
    const std::vector<Sample> samples = samples_of(map, {}, from, to, 20000);
    const double distance_m = samples.back().along_m;
    double lowest = 1e300;
    for (std::size_t s = 1; s + 1 < samples.size(); ++s) {
      const double near_m = samples[s].along_m;
      lowest = std::min(lowest, samples[s].clearance_m / std::sqrt(299792458.0 / 2e9 * near_m *
                                                                   (distance_m - near_m) / distance_m));
    }
    const FresnelClearance found = fresnel_clearance(posts_of(map), {}, from, to, 2e9);
    EXPECT_LE(found.share, lowest + 1e-4 * std::abs(lowest)) << i;
    EXPECT_GE(found.share, lowest - 0.1 * std::abs(lowest) - 0.1) << i;
  }
}

// Fails if an end off the map is no error.
TEST(SightClearance, NeedsEndsOnTheMap) {
  const HeightMap map = bumpy_map();
  EXPECT_THROW(sight_clearance(posts_of(map), {}, {"from", 0.0, 0.0, 1.0}, {"to", 9000.0, 0.0, 1.0}), Error);
}

}  // namespace
}  // namespace offing::terrain
