// A million rays through woods on slopes against a march in double precision, over made and over real maps.
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "host/io/height_maps/read_height_map.h"
#include "host/terrain/field/terrain_posts.h"
#include "host/terrain/shading/canopy.h"
#include "tests/terrain/canopy/crown_reference.h"
#include "tests/terrain/example_maps.h"
#include "tests/terrain/terrain_painter.h"

namespace offing {
namespace {

/// 720 x 360 pixels from `eyes` places of a map: over the woods, and in a glade.
void check(const test::HeightMap& map, int eyes) {
  constexpr double height_m = 20.0;
  test::PaintedTerrain scene;
  scene.light.sea_level_m = scene.light.beach_line_m = scene.light.still_water_m = -1e6f;
  scene.light.tree_line_m = scene.light.snow_line_m = 1e6f;
  test::TerrainPainter painter(map, scene);
  const ColourMap white{.columns = 1,
                        .rows = 1,
                        .rgba = {255, 255, 255, 255},
                        .left = 0.0,
                        .top = 0.0,
                        .right = static_cast<double>(map.grid.columns - 1),
                        .bottom = static_cast<double>(map.grid.rows - 1)};
  const terrain::CanopyLayer wood(
      painter.device(), *terrain::wood_of({.height_m = height_m}, terrain::cover_map(white), 2000.0));
  const terrain::TerrainPosts posts = test::posts_of(map);
  for (int i = 0; i < eyes; ++i) {
    const double x_m = (0.13 + 0.17 * i) * posts.width_m(), z_m = (0.87 - 0.19 * i) * posts.depth_m();
    const double above_m = i == 1 ? 1.7 : 32.0 + 40.0 * i;
    const Camera camera{.eye_m = {x_m, terrain::terrain_at(posts, x_m, z_m)->height_m + above_m, z_m},
                        .yaw_rad = 1.3 * i,
                        .pitch_rad = -0.2,
                        .vertical_field_of_view_rad = 1.2,
                        .width_px = 720,
                        .height_px = 360};
    painter.draw(camera, {.sampling = {.rays = 1}, .canopy = &wood});
    const test::CrownComparison found = test::compare_crowns(map, height_m, camera, 800.0, painter.hits());
    std::printf("%s, %d: %zu rays, %zu crowns, %zu without leaves, %zu touching, worst %.2g cells\n",
                map.name.c_str(), i, found.rays, found.crowns, found.smooth, found.touching,
                found.worst_cells);
    EXPECT_EQ(found.wrong, 0u) << map.name << ", " << i;
    EXPECT_LE(found.touching, found.rays / 500) << map.name << ", " << i;
    EXPECT_LE(found.worst_cells, 1e-3) << map.name << ", " << i;
    EXPECT_GT(found.crowns, found.rays / 4) << map.name << ", " << i;
  }
}

// Fails if any of a million rays over made hills passes through a crown, hits one where there is none, or is
// off by more than 1e-3 cells of the map.
TEST(MillionCrownRaysTest, OverMadeTerrain) {
  check(test::valleys({.columns = 400, .rows = 380, .spacing_x_m = 20.0, .spacing_z_m = 20.0}), 4);
}

// The same over real ground, twice half a million rays.
TEST(MillionCrownRaysTest, OverRealTerrain) {
  const char* folder = std::getenv("OFFING_TEST_DATA");
  if (folder == nullptr) GTEST_SKIP() << "OFFING_TEST_DATA is not set";
  for (const char* name : {"S33W071.tif", "N48W125.hgt.zip"}) {
    const HeightMap map = read_height_map(std::filesystem::path(folder) / "terrain" / name).map;
    check({name, terrain::post_grid(map), map.heights_m}, 2);
  }
}

}  // namespace
}  // namespace offing
