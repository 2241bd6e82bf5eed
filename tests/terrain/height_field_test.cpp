// What a HeightField refuses, and pictures of it.
#include "host/terrain/field/height_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/ocl/expect_error.h"
#include "tests/terrain/example_maps.h"

namespace offing {
namespace {

using terrain::HeightField;
using terrain::Ray;

TEST(HeightFieldTest, RefusesBadMaps) {
  const ocl::Device device = ocl::Device::open();
  const auto make = [&](const terrain::PostGrid& grid, std::vector<float> heights_m) {
    return [=] { HeightField(device, grid, heights_m); };
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  test::expect_error(ErrorKind::bad_input, "rows: expected 2", make({.columns = 4, .rows = 1}, {1, 2, 3, 4}));
  test::expect_error(ErrorKind::bad_input, "expected 2 x 2 heights, found 3",
                     make({.columns = 2, .rows = 2}, {1, 2, 3}));
  test::expect_error(ErrorKind::bad_input, "row 1, column 0",
                     make({.columns = 2, .rows = 2}, {1, 2, nan, 4}));
  test::expect_error(ErrorKind::bad_input, "spacing_z_m",
                     make({.columns = 2, .rows = 2, .spacing_z_m = 0.0}, {1, 2, 3, 4}));
  test::expect_error(ErrorKind::bad_input, "posts", make({.columns = 100'000, .rows = 100'000}, {}));
}

TEST(HeightFieldTest, RefusesBadRays) {
  HeightField field(ocl::Device::open(), {.columns = 2, .rows = 2}, std::vector<float>{1, 2, 3, 4});
  const auto cast = [&](const Ray& ray) { return [&field, ray] { field.cast(std::vector<Ray>{ray}); }; };
  test::expect_error(ErrorKind::bad_input, "finite", cast({.origin_m = {std::nan(""), 0, 0}}));
  test::expect_error(ErrorKind::bad_input, "length 1", cast({.direction = {0, 2, 0}}));
  test::expect_error(ErrorKind::bad_input, "limit_m", cast({.limit_m = -1.0}));
  test::expect_error(ErrorKind::bad_input, "cells of the map", cast({.origin_m = {1e9, 0, 0}}));
  ocl::Buffer<float> small(ocl::Device::open(), 10, "small");
  test::expect_error(ErrorKind::bad_usage, "expected a buffer of", [&] { field.cast(Camera{}, small); });
}

// A picture of an odd size, so that blocks are cut, against its pixels' rays one by one. Directions of a
// camera's pixels are floats: at most 2e3 m away, 3e-7 of that across steep patches; gate 1e-2 m.
TEST(HeightFieldTest, AImageIsTheRaysOfItsPixels) {
  const ocl::Device device = ocl::Device::open();
  const test::HeightMap map = test::example_maps().back();
  HeightField field(device, map.grid, map.heights_m);
  const Camera camera{
      .eye_m = {300.0, 110.0, 2300.0}, .yaw_rad = 0.7, .pitch_rad = -0.2, .width_px = 53, .height_px = 37};
  ocl::Buffer<float> distances(device, 53 * 37, "distances");
  ocl::Buffer<TerrainHit> hits(device, 53 * 37, "hits");
  field.cast(camera, distances);
  field.cast(camera, hits);
  std::vector<Ray> rays;
  for (int row = 0; row < 37; ++row) {
    for (int column = 0; column < 53; ++column) {
      const glm::dvec2 clip((column + 0.5) * 2.0 / 53.0 - 1.0, 1.0 - (row + 0.5) * 2.0 / 37.0);
      rays.push_back({.origin_m = camera.eye_m, .direction = glm::normalize(ray_direction(camera, clip))});
    }
  }
  const std::vector<terrain::RayHit> expected = field.cast(rays);
  const std::vector<TerrainHit> found = hits.read();
  const std::vector<float> found_m = distances.read();
  std::size_t differing = 0, terrain = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(found_m[i], found[i].distance_m) << i;
    const bool is_same = found[i].kind == expected[i].kind &&
                         (found[i].kind == TERRAIN_MISS ||
                          std::abs(static_cast<double>(found_m[i]) - expected[i].distance_m) < 1e-2);
    differing += is_same ? 0 : 1;
    terrain += found[i].kind == TERRAIN_SURFACE ? 1 : 0;
  }
  EXPECT_GT(terrain, rays.size() / 2);
  EXPECT_LE(differing, 2u) << "more than rays that graze a ridge";
}

// Pictures visit nodes for many rays at a time, single rays each its own: by eyes within, above, below and
// beside each map, in all directions, both must hit the same. Both solve the same patches from nearly the
// same start: gate 1e-5 of the distance, and of 10,000 rays one that grazes a ridge.
TEST(HeightFieldTest, PicturesFindWhatSingleRaysFind) {
  const ocl::Device device = ocl::Device::open();
  for (const test::HeightMap& map : test::example_maps()) {
    HeightField field(device, map.grid, map.heights_m);
    ocl::Buffer<TerrainHit> together(device, 75 * 45, "together"), alone(device, 75 * 45, "alone");
    std::size_t differing = 0, terrain = 0;
    for (const Ray& ray : test::example_rays(map, 48, 41)) {
      const Camera camera{.eye_m = ray.origin_m,
                          .yaw_rad = std::atan2(ray.direction.x, -ray.direction.z),
                          .pitch_rad = std::asin(ray.direction.y),
                          .roll_rad = 0.3,
                          .width_px = 75,
                          .height_px = 45};
      field.cast(camera, together);
      field.cast(camera, alone, terrain::CastMethod::paper);
      const std::vector<TerrainHit> found = together.read(), expected = alone.read();
      for (std::size_t i = 0; i < found.size(); ++i) {
        const bool is_near =
            found[i].kind == TERRAIN_MISS || std::abs(found[i].distance_m - expected[i].distance_m) <=
                                                 1e-5 * std::max(1.0f, expected[i].distance_m);
        differing += found[i].kind == expected[i].kind && is_near ? 0 : 1;
        terrain += found[i].kind == TERRAIN_SURFACE ? 1 : 0;
      }
    }
    EXPECT_GT(terrain, 10'000u) << map.name;
    EXPECT_LE(differing, 48u * 75u * 45u / 10'000u) << map.name;
  }
}

// Fails if packets that are wide beside the map leave the pyramid, whose top level is below its root here.
TEST(HeightFieldTest, FarPicturesFindWhatSingleRaysFind) {
  const ocl::Device device = ocl::Device::open();
  const test::HeightMap map =
      test::valleys({.columns = 531, .rows = 531, .spacing_x_m = 10.0, .spacing_z_m = 10.0});
  HeightField field(device, map.grid, map.heights_m);
  ASSERT_LT(field.pyramid().layout().top_level, 7);
  ocl::Buffer<TerrainHit> together(device, 64 * 36, "together"), alone(device, 64 * 36, "alone");
  std::size_t terrain = 0, differing = 0;
  for (const double away_m : {3e3, 1e4, 3e4, 1e5}) {
    const Camera camera{.eye_m = {-away_m, 0.8 * away_m, -away_m},
                        .yaw_rad = 0.75 * std::numbers::pi,
                        .pitch_rad = -0.5,
                        .vertical_field_of_view_rad = 1.0,
                        .width_px = 64,
                        .height_px = 36};
    field.cast(camera, together);
    field.cast(camera, alone, terrain::CastMethod::paper);
    const std::vector<TerrainHit> found = together.read(), expected = alone.read();
    for (std::size_t i = 0; i < found.size(); ++i) {
      differing += found[i].kind == expected[i].kind ? 0 : 1;
      terrain += found[i].kind == TERRAIN_SURFACE ? 1 : 0;
    }
  }
  EXPECT_GT(terrain, 100u);
  EXPECT_EQ(differing, 0u);
}

}  // namespace
}  // namespace offing
