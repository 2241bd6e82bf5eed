// Rays over tiles against rays over the whole map.
#include "host/terrain/tiles/tiled_field.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/terrain/field/height_field.h"
#include "tests/ocl/expect_error.h"
#include "tests/terrain/example_tiles.h"
#include "tests/terrain/ray_comparison.h"

namespace offing {
namespace {

using terrain::HeightField;
using terrain::Ray;
using terrain::TiledField;

constexpr std::size_t mebibyte = 1 << 20;

/// A camera with so fine pixels that all tiles are wanted at level 0, or with such coarse ones that only
/// those around the eye are.
Camera fine_camera() {
  return {.eye_m = {3500.0, 300.0, 3200.0}, .width_px = 16000, .height_px = 16000};
}
Camera coarse_camera() {
  return {.eye_m = {500.0, 100.0, 700.0}, .pitch_rad = -0.2, .width_px = 64, .height_px = 48};
}

class TiledFieldTest : public ::testing::Test {
 protected:
  ocl::Device device_ = ocl::Device::open();
  test::ExampleTiles example_ = test::hilly_tiles();
  TiledField field_{device_, example_.tiled_map(), example_.reader(), 64 * mebibyte};
};

// Fails if tiles of level 0 are another ground than the map: every robust ray must have the kind of hit and
// the distance of the reference, to 1e-3 cells, as those of a HeightField (ray_comparison.h). Such rays start
// anywhere, go anywhere, and cross many tiles. Measured: 3e-5 cells.
TEST_F(TiledFieldTest, FineTilesAreTheMap) {
  field_.look_and_wait(fine_camera());
  EXPECT_EQ(field_.statistics().stood_in, 0u);
  EXPECT_EQ(field_.statistics().tiles, 9u);
  const std::vector<Ray> rays = test::example_rays(example_.map(), 6000, 5);
  const test::RayComparison found = test::compare(example_.map(), rays, field_.cast(rays));
  EXPECT_EQ(found.wrong, 0u);
  EXPECT_GT(found.hits, 2000u);
  EXPECT_LE(found.touching, 6u);
  EXPECT_LT(found.worst_cells, 1e-3);
}

// Hits name the map's own cells, whatever the level: the place in the plan is that of the ray.
TEST_F(TiledFieldTest, HitsAreInTheMapsCells) {
  field_.look_and_wait(coarse_camera());
  EXPECT_GT(field_.statistics().tiles, 1u);
  const std::vector<Ray> rays = test::example_rays(example_.map(), 3000, 6);
  const std::vector<terrain::RayHit> hits = field_.cast(rays);
  std::size_t checked = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].kind == TERRAIN_MISS) continue;
    const glm::dvec3 place = rays[i].origin_m + static_cast<double>(hits[i].distance_m) * rays[i].direction;
    const auto& grid = example_.map().grid;
    // A place at t = 1e5 m is 2^-23 t off as a float: 1e-3 cells of 10 m.
    if (hits[i].kind == TERRAIN_INSIDE && hits[i].distance_m == 0.0f) continue;
    EXPECT_NEAR(hits[i].cell_x + static_cast<double>(hits[i].u), place.x / grid.spacing_x_m, 2e-3) << i;
    EXPECT_NEAR(hits[i].cell_z + static_cast<double>(hits[i].v), place.z / grid.spacing_z_m, 2e-3) << i;
    const double length = std::hypot(hits[i].normal_x, hits[i].normal_y, hits[i].normal_z);
    EXPECT_NEAR(length, 1.0, 1e-5);
    ++checked;
  }
  EXPECT_GT(checked, 500u);
}

// Fails if coarse tiles show sky where ground is, or ground behind the map's: all rays that hit the map
// robustly hit its tiles, and no later. Cuts of all sizes, so that levels meet in many ways.
TEST_F(TiledFieldTest, CoarseTilesAreNowhereBelowTheMap) {
  HeightField whole(device_, example_.map().grid, example_.map().heights_m);
  std::vector<Ray> rays = test::example_rays(example_.map(), 8000, 7);
  const std::vector<terrain::RayHit> expected = whole.cast(rays);
  for (const int height_px : {2, 24, 100, 400}) {
    Camera camera = coarse_camera();
    camera.height_px = height_px;
    field_.look_and_wait(camera);
    const std::vector<terrain::RayHit> found = field_.cast(rays);
    std::size_t hits = 0, holes = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (expected[i].kind == TERRAIN_MISS) continue;
      ++hits;
      const double late_m = found[i].distance_m - expected[i].distance_m * (1.0 + 1e-5);
      if (found[i].kind != TERRAIN_MISS && late_m <= 0.01) continue;
      // Rays that touch the map to 1e-4 cells may pass it by rounding.
      const test::ReferenceHit reference = test::reference_hit(example_.map(), rays[i]);
      if (test::is_robust(example_.map(), rays[i], reference)) ++holes;
    }
    EXPECT_EQ(holes, 0u) << height_px;
    EXPECT_GT(hits, 3000u);
  }
}

// A picture is the rays of its pixels, also across borders of levels. Directions of pixels are floats: 3e-7
// of 7e3 m across slopes, gate 0.05 m; a ray that grazes a ridge may differ.
TEST_F(TiledFieldTest, AImageIsTheRaysOfItsPixels) {
  const Camera camera = coarse_camera();
  field_.look_and_wait(camera);
  ocl::Buffer<TerrainHit> hits(device_, 64 * 48, "hits");
  ocl::Buffer<float> distances(device_, 64 * 48, "distances");
  field_.cast(camera, hits);
  field_.cast(camera, distances);
  std::vector<Ray> rays;
  for (int row = 0; row < 48; ++row) {
    for (int column = 0; column < 64; ++column) {
      const glm::dvec2 clip((column + 0.5) / 32.0 - 1.0, 1.0 - (row + 0.5) / 24.0);
      rays.push_back({.origin_m = camera.eye_m, .direction = glm::normalize(ray_direction(camera, clip))});
    }
  }
  const std::vector<terrain::RayHit> expected = field_.cast(rays);
  const std::vector<TerrainHit> found = hits.read();
  const std::vector<float> found_m = distances.read();
  std::size_t differing = 0, terrain = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(found_m[i], found[i].distance_m);
    const bool is_same = found[i].kind == expected[i].kind &&
                         (found[i].kind == TERRAIN_MISS ||
                          std::abs(static_cast<double>(found_m[i]) - expected[i].distance_m) < 0.05);
    differing += is_same ? 0 : 1;
    terrain += found[i].kind == TERRAIN_SURFACE ? 1 : 0;
  }
  EXPECT_GT(terrain, rays.size() / 3);
  EXPECT_LE(differing, 3u);
}

// Fails if a tile that cannot be read leaves a hole, stops the flight, or is asked for again and again.
TEST_F(TiledFieldTest, CoarseGroundStandsInForBrokenTiles) {
  std::atomic<int> asked = 0;
  const terrain::TileReader whole = example_.reader();
  TiledField field(
      device_, example_.tiled_map(),
      [&](const TileKey& key) {
        if (key == TileKey{0, 1, 1}) {
          ++asked;
          throw Error(ErrorKind::bad_input, "0/0001/0001.tile: expected checksum 1, found 2");
        }
        return whole(key);
      },
      64 * mebibyte);
  ::testing::internal::CaptureStdout();
  for (int frame = 0; frame < 5; ++frame) field.look_and_wait(fine_camera());
  ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(field.statistics().failed, 1u);
  EXPECT_EQ(field.statistics().stood_in, 1u);
  std::vector<Ray> rays;
  for (int i = 0; i < 400; ++i) rays.push_back({.origin_m = {2600.0 + 6.0 * i, 500.0, 3300.0 + 7.0 * i}});
  for (const terrain::RayHit& hit : field.cast(rays)) EXPECT_EQ(hit.kind, TERRAIN_SURFACE);
}

// Fails if look() waits for tiles, or never gets them: the first look has the coarsest level only, and a few
// later all are there.
TEST_F(TiledFieldTest, TilesComeWhileItLooks) {
  field_.look(fine_camera());
  EXPECT_GT(field_.statistics().stood_in, 0u);
  std::vector<Ray> down{{.origin_m = {3500.0, 500.0, 3200.0}}};
  EXPECT_EQ(field_.cast(down).front().kind, TERRAIN_SURFACE);
  for (int i = 0; i < 2000 && field_.statistics().stood_in > 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    field_.look(fine_camera());
  }
  EXPECT_EQ(field_.statistics().stood_in, 0u);
}

// A flight over more tiles than there are slots: memory stays within the budget, and what lies under the eye
// is the map itself all the way, though slots have changed hands.
TEST(TiledFieldFlight, KeepsItsBudget) {
  const ocl::Device device = ocl::Device::open();
  const test::ExampleTiles example(test::valleys({.columns = 2300, .rows = 1800}));
  constexpr std::size_t budget = 34 * mebibyte;
  TiledField field(device, example.tiled_map(), example.reader(), budget);
  EXPECT_LE(field.statistics().slots, 45u);
  HeightField whole(device, example.map().grid, example.map().heights_m);
  for (int step = 0; step < 24; ++step) {
    const glm::dvec3 eye_m(60.0 + 90.0 * step, 90.0, 1700.0 - 70.0 * step);
    field.look_and_wait({.eye_m = eye_m, .width_px = 320, .height_px = 180});
    EXPECT_LE(field.statistics().bytes, budget);
    EXPECT_EQ(field.statistics().stood_in, 0u);
    const std::vector<Ray> down{{.origin_m = eye_m}};
    EXPECT_EQ(field.cast(down).front().distance_m, whole.cast(down).front().distance_m) << step;
  }
  EXPECT_GT(field.statistics().loaded, 2 * field.statistics().slots);
}

// Maps of more than 65536 posts a side have several tiles of the coarsest level, whose cells are as wide as a
// tile of level 0. A ramp of 1 mm a post, made tile by tile: all the way to its far end rays must hit within
// a coarse cell's rise of it, 0.512 m, and long level rays where they meet it, not before by more than that
// rise.
TEST(TiledFieldFlight, SeesAcrossHugeMaps) {
  constexpr double rise = 1e-3;
  const TileSetShape shape = TileSetShape::of(150'001, 1200);
  ASSERT_EQ(shape.tiles_x(shape.coarsest()), 3);
  const auto ramp = [&](const TileKey& key) {
    HeightTile tile{key, {}, {}};
    for (int row = -1; row <= tile_posts; ++row) {
      for (int column = -1; column <= tile_posts; ++column) {
        const double x = std::ldexp(key.column * tile_cells + column, key.level);
        const double reach = key.level > 0 ? std::ldexp(1.0, key.level) : 0.0;
        tile.means_m.push_back(static_cast<float>(rise * x));
        if (row >= 0 && row < tile_posts && column >= 0 && column < tile_posts) {
          tile.highest_m.push_back(static_cast<float>(rise * std::min(x + reach, 150'000.0)));
        }
      }
    }
    return tile;
  };
  const ocl::Device device = ocl::Device::open();
  TiledField field(device, {shape, 1.0, 1.0, 0.0f, 150.0f}, ramp, 64 * mebibyte);
  field.look_and_wait({.eye_m = {1000.0, 40.0, 600.0}, .width_px = 640, .height_px = 360});
  EXPECT_GT(field.statistics().tiles, 20u);
  std::vector<Ray> rays;
  for (int i = 0; i < 300; ++i) rays.push_back({.origin_m = {500.0 * i + 3.3, 300.0, 600.2}});
  for (int i = 1; i < 140; ++i) {
    rays.push_back({.origin_m = {1000.0, 1.0 * i + 0.5, 3.0 * i}, .direction = {1.0, 0.0, 0.0}});
  }
  const std::vector<terrain::RayHit> hits = field.cast(rays);
  for (std::size_t i = 0; i < 300; ++i) {
    const double raised_m = 300.0 - hits[i].distance_m - rise * rays[i].origin_m.x;
    EXPECT_GE(raised_m, -1e-4) << i;
    EXPECT_LE(raised_m, 0.513) << i;
  }
  for (std::size_t i = 300; i < rays.size(); ++i) {
    const double met_m = rays[i].origin_m.y / rise - 1000.0;
    EXPECT_LE(hits[i].distance_m, met_m + 0.1) << i;
    EXPECT_GE(hits[i].distance_m, met_m - 513.0) << i;
  }
}

// Fails if a map of few tiles takes all the memory that it may.
TEST(TiledFieldFlight, TakesNoMoreThanTheMapNeeds) {
  const ocl::Device device = ocl::Device::open();
  const test::ExampleTiles example = test::hilly_tiles();
  const TiledField field(device, example.tiled_map(), example.reader(), 2048 * mebibyte);
  EXPECT_LE(field.statistics().slots,
            2u * static_cast<std::size_t>(example.tiled_map().shape.tile_count()) + 33u);
  EXPECT_LT(field.statistics().bytes, 256u * mebibyte);
}

TEST(TiledFieldFlight, RefusesWhatCannotBe) {
  const ocl::Device device = ocl::Device::open();
  const test::ExampleTiles example = test::hilly_tiles();
  test::expect_error(ErrorKind::bad_input, "tile cache",
                     [&] { TiledField(device, example.tiled_map(), example.reader(), 4 * mebibyte); });
  TiledField field(device, example.tiled_map(), example.reader(), 64 * mebibyte);
  test::expect_error(ErrorKind::bad_usage, "tiles to be chosen", [&] { field.cast(std::vector<Ray>(1)); });
}

// A map beyond whose edge is more of it: rays from and into its copies must hit what a map of 3 x 3 such
// copies has there, built by hand, of which the middle one is the map. Copies that repeat have cliffs at
// their borders, those that mirror have none. Rays end within the 3 x 3 copies.
class TiledFieldEdges : public ::testing::TestWithParam<terrain::MapEdge> {};

TEST_P(TiledFieldEdges, CopiesGoOnBeyondTheMap) {
  const bool mirrors = GetParam() == terrain::MapEdge::mirrors;
  constexpr int cells_x = 299, cells_z = 260;
  const test::HeightMap map =
      test::valleys({.columns = cells_x + 1, .rows = cells_z + 1, .spacing_z_m = 1.5});
  const auto folded = [&](int place, int cells) {
    const int copy = place / cells, rest = place % cells;
    return mirrors && copy % 2 == 0 ? cells - rest : rest;
  };
  // The outer copies of 3 x 3 are odd ones, at 0 and 2; posts on a border are those of the copy that begins
  // there.
  test::HeightMap many{"copies",
                       {.columns = 3 * cells_x + 1,
                        .rows = 3 * cells_z + 1,
                        .spacing_z_m = 1.5,
                        .origin_x_m = -1.0 * cells_x,
                        .origin_z_m = -1.5 * cells_z},
                       {}};
  for (int row = 0; row < many.grid.rows; ++row) {
    for (int column = 0; column < many.grid.columns; ++column) {
      many.heights_m.push_back(map.at(folded(column, cells_x), folded(row, cells_z)));
    }
  }
  const ocl::Device device = ocl::Device::open();
  const test::ExampleTiles example(map);
  TiledField field(device, example.tiled_map(GetParam()), example.reader(), 64 * mebibyte);
  field.look_and_wait({.eye_m = {150.0, 20.0, 200.0}, .width_px = 16000, .height_px = 16000});
  ASSERT_EQ(field.statistics().stood_in, 0u);
  std::vector<Ray> rays = test::example_rays(many, 4000, 12);
  std::size_t compared = 0, wrong = 0;
  const std::vector<terrain::RayHit> found = field.cast(rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const glm::dvec3& from = rays[i].origin_m;
    const bool is_over =
        from.x > -cells_x && from.x < 2 * cells_x && from.z > -1.5 * cells_z && from.z < 3.0 * cells_z;
    const test::ReferenceHit expected = test::reference_hit(many, rays[i]);
    // What leaves the copies that were built hits one that was not; at a repeated border a cliff stands in
    // the tiles, and a steep patch in the map of copies.
    if (!is_over || expected.kind == TERRAIN_MISS || expected.kind == TERRAIN_SIDE) continue;
    const auto is_at_border = [&](double distance_m) {
      const glm::dvec3 at = from + distance_m * rays[i].direction;
      const glm::dvec2 copies(at.x / cells_x, at.z / (1.5 * cells_z));
      const glm::dvec2 off = glm::abs(copies - glm::round(copies));
      return off.x < 1.5 / cells_x || off.y < 1.5 / cells_z;
    };
    if (!mirrors && (is_at_border(expected.distance_m) || is_at_border(found[i].distance_m))) continue;
    if (!test::is_robust(many, rays[i], expected)) continue;
    ++compared;
    const double error_cells = std::abs(found[i].distance_m - expected.distance_m) * expected.facing;
    if (found[i].kind != expected.kind || !(error_cells <= 1e-3)) ++wrong;
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_GT(compared, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Edges, TiledFieldEdges,
                         ::testing::Values(terrain::MapEdge::repeats, terrain::MapEdge::mirrors));

}  // namespace
}  // namespace offing
