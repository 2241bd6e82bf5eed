// Rays against a walk in double precision (tests/terrain/reference_walk.h).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/terrain/field/height_field.h"
#include "tests/terrain/example_maps.h"
#include "tests/terrain/ray_comparison.h"

namespace offing {
namespace {

using terrain::CastMethod;
using terrain::HeightField;
using terrain::Ray;

constexpr CastMethod all_methods[] = {CastMethod::parity, CastMethod::paper, CastMethod::pdm,
                                      CastMethod::linear};
constexpr std::size_t rays_a_map = 17'000;  // 1e5 over the six maps

// Fails if a walk skips a patch, takes the wrong root, stops at a border, or confuses how a ray ends. Gate
// 1e-3 cells across the surface; what touches it to less than 1e-4 cells is left out, and must be rare where
// the map is not flat.
TEST(RayCastTest, FindsWhatADoublePrecisionWalkFinds) {
  const ocl::Device device = ocl::Device::open();
  for (const test::HeightMap& map : test::example_maps()) {
    HeightField field(device, map.grid, map.heights_m);
    const std::vector<Ray> rays = test::example_rays(map, rays_a_map, 11);
    const test::RayComparison comparison = test::compare(map, rays, field.cast(rays));
    EXPECT_EQ(comparison.wrong, 0u) << map.name;
    EXPECT_GT(comparison.hits, rays.size() / 10) << map.name << ": the rays miss";
    if (map.name != "flat" && map.name != "ramp") {
      EXPECT_LE(comparison.touching, rays.size() / 1000) << map.name;
    }
    std::printf("%s: %zu rays, %zu hits, worst %.2g cells, %zu touch the surface\n", map.name.c_str(),
                rays.size(), comparison.hits, comparison.worst_cells, comparison.touching);
  }
}

// Fails if a variant of the walk finds other patches than the default does, or costs it more steps than the
// paper's.
TEST(RayCastTest, MethodsAgreeAndTheDefaultTakesFewestSteps) {
  const ocl::Device device = ocl::Device::open();
  for (const test::HeightMap& map : test::example_maps()) {
    HeightField field(device, map.grid, map.heights_m);
    const std::vector<Ray> rays = test::example_rays(map, 4000, 12);
    double steps[4] = {};
    for (std::size_t method = 0; method < 4; ++method) {
      const std::vector<terrain::RayHit> hits = field.cast(rays, all_methods[method]);
      EXPECT_EQ(test::compare(map, rays, hits).wrong, 0u) << map.name << ", method " << method;
      for (const terrain::RayHit& hit : hits) steps[method] += hit.steps / static_cast<double>(hits.size());
    }
    std::printf("%s: mean steps: parity %.2f, paper %.2f, pdm %.2f, linear %.2f\n", map.name.c_str(),
                steps[0], steps[1], steps[2], steps[3]);
    EXPECT_LT(steps[0], steps[1]) << map.name;
  }
}

// Fails if places are computed far from where they are needed: floats of 1e6 cells are whole sixteenths.
TEST(RayCastTest, AMapFarFromTheOriginIsAsExact) {
  const ocl::Device device = ocl::Device::open();
  test::HeightMap map = test::example_maps()[0];
  map.grid.origin_x_m = 1e6 * map.grid.spacing_x_m;
  map.grid.origin_z_m = -1e6 * map.grid.spacing_z_m;
  HeightField field(device, map.grid, map.heights_m);
  const std::vector<Ray> rays = test::example_rays(map, 4000, 13);
  EXPECT_EQ(test::compare(map, rays, field.cast(rays)).wrong, 0u);
}

// Across 65,536 cells floats of a whole map would err by 4e-3 cells, and t is rounded to as much: the place
// that a hit states is what is exact. Gate 1e-3 cells.
TEST(RayCastTest, HitsFarAwayAreStatedToAThousandthOfACell) {
  const test::HeightMap map = test::valleys({.columns = 65537, .rows = 5});
  HeightField field(ocl::Device::open(), map.grid, map.heights_m);
  std::vector<Ray> rays;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 from(0.3, 3000.0 + 4.0 * i, 1.0 + 0.004 * i), to(60000.5 + 7.31 * i, -40.0, 2.1);
    rays.push_back({.origin_m = from, .direction = glm::normalize(to - from)});
  }
  const std::vector<terrain::RayHit> hits = field.cast(rays);
  double worst_cells = 0.0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    // The kernel takes the rise as a float: the ray that it follows.
    Ray ray = rays[i];
    ray.direction.y = static_cast<float>(ray.direction.y);
    const test::ReferenceHit expected = test::reference_hit(map, ray);
    ASSERT_EQ(hits[i].kind, expected.kind) << i;
    if (expected.kind == TERRAIN_MISS || !test::is_robust(map, ray, expected)) continue;
    const double x = ray.origin_m.x + expected.distance_m * ray.direction.x;
    const double error_cells =
        std::abs(hits[i].cell_x + static_cast<double>(hits[i].u) - x) * expected.facing;
    worst_cells = std::max(worst_cells, error_cells);
  }
  std::printf("worst place %.2g cells\n", worst_cells);
  EXPECT_LT(worst_cells, 1e-3);
}

// Rays that begin 1,000 km before places in and beside a map, over maps of every kind. Fails if a ray's way
// to the map is among the floats of its distance: those of 1,000 km are 6 cm apart. Gate 1e-3 cells.
TEST(RayCastTest, DistancesFromFarAwayAreAsExact) {
  const ocl::Device device = ocl::Device::open();
  for (const test::HeightMap& map : test::example_maps()) {
    HeightField field(device, map.grid, map.heights_m);
    std::vector<Ray> rays = test::example_rays(map, 4000, 14);
    for (Ray& ray : rays) ray.origin_m -= 1e6 * ray.direction;
    const test::RayComparison comparison = test::compare(map, rays, field.cast(rays));
    EXPECT_EQ(comparison.wrong, 0u) << map.name;
    EXPECT_GT(comparison.hits, rays.size() / 10) << map.name << ": the rays miss";
    std::printf("%s: worst %.2g cells\n", map.name.c_str(), comparison.worst_cells);
  }
}

// Along the far edges of a map whose last post is no whole number of metres away: a place that differs from
// it by rounding is on it, and one beyond it has no ground. Fails if a ray beside the map comes into it
// somewhere.
TEST(RayCastTest, RaysBesideTheMapMissIt) {
  const terrain::PostGrid grid{.columns = 11, .rows = 14, .spacing_x_m = 30.9, .spacing_z_m = 92.7};
  HeightField field(ocl::Device::open(), grid, std::vector<float>(11 * 14, 7.0f));
  const double width_m = 10 * 30.9, depth_m = 13 * 92.7;
  const auto hit = [&](const glm::dvec3& from, const glm::dvec3& toward) {
    return field.cast(std::vector<Ray>{{.origin_m = from, .direction = glm::normalize(toward)}}).front();
  };
  for (const glm::dvec3& toward : {glm::dvec3(0, -1, 0), glm::dvec3(0, -1, 1), glm::dvec3(0, -1e-3, -1)}) {
    EXPECT_EQ(hit({width_m, 7.5, 600.0}, toward).kind, TERRAIN_SURFACE) << toward.y;
    for (const double beyond_m : {1e-12, 3e-11, 1e-9, 1e-6, 1e-3, 1.0}) {
      EXPECT_EQ(hit({-beyond_m, 7.5, 600.0}, toward).kind, TERRAIN_MISS) << toward.y << ", " << beyond_m;
      const terrain::RayHit found = hit({width_m + beyond_m, 7.5, 600.0}, toward);
      if (beyond_m > 1e-12) {
        EXPECT_EQ(found.kind, TERRAIN_MISS) << toward.y << ", " << beyond_m << ": " << found.distance_m;
      }
    }
  }
  EXPECT_EQ(hit({100.0, 7.5, std::nextafter(depth_m, 1e9)}, {0, -1, 0}).kind, TERRAIN_SURFACE);
  EXPECT_EQ(hit({100.0, 7.5, depth_m + 3e-11}, {1, -1e-3, 0}).kind, TERRAIN_MISS);
  EXPECT_EQ(hit({width_m + 3e-11, 7.5, depth_m + 3e-11}, {0, -1, 0}).kind, TERRAIN_MISS);
}

/// One patch with the given corners, and a ray over it in cells.
terrain::RayHit cast_one(const std::vector<float>& corners_m, const Ray& ray) {
  HeightField field(ocl::Device::open(), {.columns = 2, .rows = 2}, corners_m);
  return field.cast(std::vector<Ray>{ray})[0];
}

// One case a branch of T7. Fails if a branch takes the other root or none.
TEST(RayCastTest, TakesTheFirstRootOfEachBranch) {
  const double half = std::numbers::sqrt2 / 2.0;
  const std::vector<float> flat{1, 1, 1, 1}, saddle{0, 1, 1, 0}, valley{1, 0, 0, 1};
  // a = 0, b != 0: one root.
  EXPECT_NEAR(cast_one(flat, {.origin_m = {0.5, 3.0, 0.5}}).distance_m, 2.0, 1e-6);
  EXPECT_NEAR(cast_one(saddle, {.origin_m = {0.5, 3.0, 0.25}}).distance_m, 2.5, 1e-6);
  // a = b = 0: level above a level patch there is none; within it the ray starts on the surface.
  EXPECT_EQ(cast_one(flat, {.origin_m = {0.0, 2.0, 0.5}, .direction = {1, 0, 0}}).kind, TERRAIN_MISS);
  EXPECT_EQ(cast_one(flat, {.origin_m = {0.5, 1.0, 0.5}, .direction = {1, 0, 0}}).kind, TERRAIN_INSIDE);
  // Level along the diagonal of h = u + v - 2 u v, from 1 to 0 and back, at 3/4: u = 3/4 of both roots 1/4,
  // 3/4.
  const terrain::RayHit second =
      cast_one(valley, {.origin_m = {0.5, 0.625, 0.5}, .direction = {half, 0, half}});
  EXPECT_EQ(second.kind, TERRAIN_SURFACE);
  EXPECT_NEAR(second.u, 0.75, 1e-6);
  EXPECT_NEAR(second.v, 0.75, 1e-6);
  // Two roots, both ahead: over the ridge between (0, 1) and (1, 0) the first is taken.
  const terrain::RayHit first =
      cast_one(saddle, {.origin_m = {-0.25, 0.375, -0.25}, .direction = {half, 0, half}});
  EXPECT_EQ(first.kind, TERRAIN_SURFACE);
  EXPECT_NEAR(first.u, 0.25, 1e-6);
  // No root: over the ridge, above its height of 1/2.
  EXPECT_EQ(cast_one(saddle, {.origin_m = {-0.25, 0.51, -0.25}, .direction = {half, 0, half}}).kind,
            TERRAIN_MISS);
  // Roots behind the origin and behind the patch are none.
  EXPECT_EQ(cast_one(flat, {.origin_m = {0.5, 1.5, 0.5}, .direction = {0, 1, 0}}).kind, TERRAIN_MISS);
  EXPECT_EQ(cast_one(flat, {.origin_m = {0.5, 1.5, 0.5}, .direction = {0.8, -0.6, 0}}).kind, TERRAIN_MISS);
}

TEST(RayCastTest, StatesHowARayEnds) {
  const std::vector<float> slope{0, 1, 0, 1};
  const terrain::RayHit inside = cast_one(slope, {.origin_m = {0.75, 0.5, 0.5}, .direction = {0, 1, 0}});
  EXPECT_EQ(inside.kind, TERRAIN_INSIDE);
  EXPECT_EQ(inside.distance_m, 0.0f);
  const terrain::RayHit side = cast_one(slope, {.origin_m = {3.0, 0.5, 0.5}, .direction = {-1, 0, 0}});
  EXPECT_EQ(side.kind, TERRAIN_SIDE);
  EXPECT_EQ(side.distance_m, 2.0f);
  EXPECT_EQ(side.normal_x, 1.0f);
  const terrain::RayHit surface = cast_one(slope, {.origin_m = {0.25, 1.0, 0.5}});
  EXPECT_EQ(surface.kind, TERRAIN_SURFACE);
  EXPECT_NEAR(surface.distance_m, 0.75, 1e-6);
  EXPECT_NEAR(surface.normal_x, -std::numbers::sqrt2 / 2.0, 1e-6);
  EXPECT_NEAR(surface.normal_y, std::numbers::sqrt2 / 2.0, 1e-6);
  EXPECT_EQ(cast_one(slope, {.origin_m = {0.25, 1.0, 0.5}, .limit_m = 0.7}).kind, TERRAIN_MISS);
}

// From 20 m above a level sea of radius R, a ray that dips by a slope of p reaches the water where
// 20 - p x + x^2 / 2R = 0, or never. Fails if nodes are passed over that the falling ground leaves below the
// ray, or if the curve is taken along one axis alone. Gate 1e-3 cells across the surface, at least p / 4
// steep.
TEST(RayCastTest, CurvedGroundFallsAway) {
  const terrain::PostGrid grid{.columns = 301, .rows = 301, .spacing_x_m = 10.0, .spacing_z_m = 15.0};
  HeightField field(ocl::Device::open(), grid, std::vector<float>(301 * 301, 5.0f));
  const double radius_m = 50'000.0;
  std::vector<Ray> rays;
  for (int i = 0; i < 200; ++i) {
    const double heading = 0.1 + 0.007 * i, slope = 0.02 + 0.0004 * i;
    rays.push_back({.origin_m = {3.0, 25.0, 7.0},
                    .direction = glm::normalize(glm::dvec3(std::cos(heading), -slope, std::sin(heading)))});
  }
  const std::vector<terrain::RayHit> hits = field.cast(rays, terrain::EarthCurve{.radius_m = radius_m});
  int misses = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double slope = -rays[i].direction.y / std::hypot(rays[i].direction.x, rays[i].direction.z);
    const double root = slope * slope - 40.0 / radius_m;
    if (root < 0.0) {
      EXPECT_EQ(hits[i].kind, TERRAIN_MISS) << slope;
      ++misses;
      continue;
    }
    const double plan_m = radius_m * (slope - std::sqrt(root));
    ASSERT_EQ(hits[i].kind, TERRAIN_SURFACE) << slope;
    EXPECT_NEAR(hits[i].distance_m, plan_m * std::sqrt(1.0 + slope * slope), 1e-2 * 4.0 / slope) << slope;
  }
  EXPECT_GT(misses, 10);
}

// The same from 100 km before a map, over the Earth: 20 - p x + x^2 / 2R = 0 again, from 2 km up. Fails if
// the ground does not fall away on the way to the map, or the distance is from the map's edge. Gate 1e-3
// cells, as above.
TEST(RayCastTest, CurvedGroundFallsAwayBeforeTheMap) {
  const terrain::PostGrid grid{
      .columns = 301, .rows = 301, .spacing_x_m = 10.0, .spacing_z_m = 15.0, .origin_x_m = 1e5};
  HeightField field(ocl::Device::open(), grid, std::vector<float>(301 * 301, 5.0f));
  const double radius_m = 6.4e6, height_m = 2000.0;
  std::vector<Ray> rays;
  std::vector<double> expected_m;
  for (int i = 0; i < 100; ++i) {
    const double plan_m = 100'400.0 + 25.0 * i, slope = height_m / plan_m + plan_m / (2.0 * radius_m);
    rays.push_back({.origin_m = {3.0, 5.0 + height_m, 2000.0},
                    .direction = glm::normalize(glm::dvec3(1.0, -slope, 1e-3))});
    const double across = std::hypot(rays.back().direction.x, rays.back().direction.z);
    // Of the direction as it is: its plan is longer than 1 by 5e-7.
    const double p = -rays.back().direction.y / across;
    expected_m.push_back(radius_m * (p - std::sqrt(p * p - 2.0 * height_m / radius_m)) / across);
  }
  const std::vector<terrain::RayHit> hits = field.cast(rays, terrain::EarthCurve{.radius_m = radius_m});
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(hits[i].kind, TERRAIN_SURFACE) << i;
    EXPECT_NEAR(hits[i].distance_m, expected_m[i], 1.0) << i;
  }
}

}  // namespace
}  // namespace offing
