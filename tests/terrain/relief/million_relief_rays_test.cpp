// A million rays against a walk in double precision over the ground that is drawn near the eye, over made and
// over real maps.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "host/io/height_maps/read_height_map.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/field/terrain_posts.h"
#include "tests/terrain/relief/relief_reference.h"

namespace offing {
namespace {

/// 720 x 360 pixels from `eyes` places of a map, 1.7 m to 40 m above it.
void check(const ocl::Device& device, const test::HeightMap& map, int eyes) {
  terrain::HeightField field(device, map.grid, map.heights_m);
  terrain::ReliefSurface relief(device);
  const terrain::TerrainPosts posts = test::posts_of(map);
  for (int i = 0; i < eyes; ++i) {
    const double x_m = (0.13 + 0.17 * i) * posts.width_m(), z_m = (0.87 - 0.19 * i) * posts.depth_m();
    const double above_m = i == 2 ? 40.0 : 1.7 + i;
    const Camera camera{.eye_m = {x_m, terrain::terrain_at(posts, x_m, z_m)->height_m + above_m, z_m},
                        .yaw_rad = 1.3 * i,
                        .pitch_rad = -0.15,
                        .vertical_field_of_view_rad = 1.2,
                        .width_px = 720,
                        .height_px = 360};
    relief.at(field, camera, above_m, {.tree_line_m = 800.0, .snow_line_m = 9000.0});
    ASSERT_TRUE(relief.is_laid()) << map.name;
    ocl::Buffer<TerrainHit> hits(device, std::size_t{720} * 360, "hits");
    field.cast(camera, relief, hits);
    const test::ReliefComparison comparison =
        test::compare(test::sheets_of(map, relief), camera, hits.read());
    std::printf("%s, %d: %zu rays, %zu hits, %zu touching, worst %.2g cells\n", map.name.c_str(), i,
                comparison.rays, comparison.hits, comparison.touching, comparison.worst_cells);
    EXPECT_EQ(comparison.wrong, 0u) << map.name << ", " << i;
    EXPECT_LE(comparison.touching, comparison.rays / 1000) << map.name << ", " << i;
  }
}

// Fails if any of a million rays over made hills passes through the drawn ground, or is off by more than
// 1e-3 cells of the map.
TEST(MillionReliefRaysTest, OverMadeTerrain) {
  check(ocl::Device::open(),
        test::valleys({.columns = 400, .rows = 380, .spacing_x_m = 20.0, .spacing_z_m = 20.0}), 4);
}

// The same over real ground, twice half a million rays.
TEST(MillionReliefRaysTest, OverRealTerrain) {
  const char* folder = std::getenv("OFFING_TEST_DATA");
  if (folder == nullptr) GTEST_SKIP() << "OFFING_TEST_DATA is not set";
  const ocl::Device device = ocl::Device::open();
  for (const char* name : {"S33W071.tif", "N48W125.hgt.zip"}) {
    const HeightMap map = read_height_map(std::filesystem::path(folder) / "terrain" / name).map;
    check(device, {name, terrain::post_grid(map), map.heights_m}, 2);
  }
}

}  // namespace
}  // namespace offing
