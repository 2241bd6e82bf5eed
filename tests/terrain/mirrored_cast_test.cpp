// What level water mirrors of ground, against rays in double precision (tests/terrain/reference_walk.h).
#include "host/terrain/cast/mirrored_cast.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/terrain/ray_comparison.h"
#include "tests/terrain/terrain_painter.h"

namespace offing {
namespace {

using terrain::Ray;

constexpr double plane_m = 0.0;

/// A hill of 60 m in a sea of 30 m depth, 129 x 129 posts 10 m apart about the origin.
test::HeightMap island() {
  test::HeightMap map{.name = "island", .grid = {}, .heights_m = {}};
  map.grid.columns = map.grid.rows = 129;
  map.grid.spacing_x_m = map.grid.spacing_z_m = 10.0;
  map.grid.origin_x_m = map.grid.origin_z_m = -640.0;
  for (int row = 0; row < 129; ++row) {
    for (int column = 0; column < 129; ++column) {
      const double distance_m = std::hypot(column - 64, row - 64) * 10.0;
      map.heights_m.push_back(static_cast<float>(90.0 * std::exp(-distance_m * distance_m / 4e4) - 30.0));
    }
  }
  return map;
}

// The eye's mirror image is below the bed here, so that a ray from it meets ground at once. Gate 20 mm
// across the surface: hits are right to 1e-3 cells (10 mm), and rays begin where floats say that they come
// up, 1e-7 of some 100 cells off; rays that all but touch it are left out, as in ray_cast_test.cpp.
TEST(MirroredCastTest, SeesWhatIsAboveThePlane) {
  const ocl::Device device = ocl::Device::open();
  const test::HeightMap map = island();
  terrain::HeightField field(device, map.grid, map.heights_m);
  const Camera camera = mirrored({.eye_m = {300.0, 40.0, 250.0},
                                  .yaw_rad = -0.9,
                                  .pitch_rad = -0.1,
                                  .roll_rad = 0.1,
                                  .width_px = 64,
                                  .height_px = 48},
                                 plane_m);
  ocl::Buffer<TerrainHit> hits(device, 64 * 48, "hits");
  terrain::MirroredCast(device).at(field, camera, plane_m, hits);
  const std::vector<TerrainHit> found = hits.read();

  std::size_t seen = 0, missed = 0;
  for (int row = 0; row < 48; ++row) {
    for (int column = 0; column < 64; ++column) {
      const TerrainHit& hit = found[static_cast<std::size_t>(row * 64 + column)];
      const glm::dvec2 clip(2.0 * (column + 0.5) / 64.0 - 1.0, 1.0 - 2.0 * (row + 0.5) / 48.0);
      const glm::dvec3 direction = glm::normalize(ray_direction(camera, clip));
      if (direction.y <= 1e-3) {
        EXPECT_EQ(hit.kind, TERRAIN_MISS) << row << ", " << column;
        ++missed;
        continue;
      }
      const double begin_m = (plane_m - camera.eye_m.y) / direction.y;
      const Ray ray{.origin_m = camera.eye_m + begin_m * direction, .direction = direction};
      const test::ReferenceHit reference = test::reference_hits(map, {ray}).front();
      if (!test::is_robust(map, ray, reference)) continue;
      ASSERT_EQ(hit.kind, reference.kind) << row << ", " << column;
      if (reference.kind == TERRAIN_MISS) {
        ++missed;
        continue;
      }
      ++seen;
      const double off_m = (double{hit.distance_m} - begin_m - reference.distance_m) * reference.facing;
      EXPECT_NEAR(off_m, 0.0, 0.02) << row << ", " << column;
    }
  }
  EXPECT_GT(seen, 300u);
  EXPECT_GT(missed, 300u);
}

// Rays that start in the ground, 16 pixels from all others (every fourth is looked at), have the light of
// open ground, whose albedo in red is 0.11. Nearer ones have that of the ground there, here water. Fails if
// all hidden ground is worked out, or if what stands beside the mirror changes.
TEST(MirroredCastTest, GroundBeforeTheMirrorHasOneLight) {
  const test::PaintedTerrain scene;
  test::TerrainPainter painter(island(), scene);
  constexpr int wide_px = 96, high_px = 72;
  const Camera camera = mirrored(
      {.eye_m = {60.0, 60.0, 0.0}, .pitch_rad = -0.3, .width_px = wide_px, .height_px = high_px}, plane_m);
  const std::vector<terrain::Texel> image = painter.draw_mirrored(camera, plane_m);
  const std::vector<TerrainHit> hits = painter.hits();
  const auto begins_inside = [&](int column, int row) {
    const int x = std::clamp(column, 0, wide_px - 1), y = std::clamp(row, 0, high_px - 1);
    return hits[static_cast<std::size_t>(y * wide_px + x)].kind == TERRAIN_INSIDE;
  };
  const double open_kcdpm2 =
      0.11 / std::numbers::pi *
      (double{scene.light.sun_red_klx} * std::sin(scene.sun_elevation_rad) + double{scene.light.sky_red_klx});
  int amid = 0, beside = 0;
  for (int row = 0; row < high_px; ++row) {
    for (int column = 0; column < wide_px; ++column) {
      if (!begins_inside(column, row)) continue;
      bool is_amid = true;
      for (int away = 4; away <= 16; away += 4) {
        for (int side = 0; side < 9; ++side)
          is_amid = is_amid && begins_inside(column + away * (side % 3 - 1), row + away * (side / 3 - 1));
      }
      const terrain::Texel& texel = image[static_cast<std::size_t>(row * wide_px + column)];
      (is_amid ? amid : beside) += 1;
      EXPECT_EQ(texel[3], 1.0f) << row << ", " << column;
      EXPECT_EQ(std::abs(double{texel[0]} - open_kcdpm2) < 1e-4 * open_kcdpm2, is_amid)
          << row << ", " << column;
    }
  }
  EXPECT_GT(std::min(amid, beside), 99);
}

}  // namespace
}  // namespace offing
