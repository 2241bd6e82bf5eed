#include "host/terrain/tiles/tile_cut.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace offing {
namespace {

using terrain::CutView;
using terrain::MapEdge;
using terrain::TiledMap;

TiledMap wide_map(MapEdge edge = MapEdge::ends) {
  return {TileSetShape::of(8001, 6001), 2.0, 2.0, 0.0f, 100.0f, edge};
}

/// How often each square of the finest level is covered.
std::vector<int> covered(const TiledMap& map, const std::vector<TileKey>& keys) {
  const int columns = map.shape.tiles_x(0), rows = map.shape.tiles_z(0);
  std::vector<int> count(static_cast<std::size_t>(columns * rows));
  for (const TileKey& key : keys) {
    for (int z = key.row << key.level; z < std::min((key.row + 1) << key.level, rows); ++z) {
      for (int x = key.column << key.level; x < std::min((key.column + 1) << key.level, columns); ++x) {
        ++count[static_cast<std::size_t>(z * columns + x)];
      }
    }
  }
  return count;
}

int level_at(const std::vector<TileKey>& keys, int cell_x, int cell_z) {
  for (const TileKey& key : keys) {
    const int log2 = 8 + key.level;
    if (cell_x >> log2 == key.column && cell_z >> log2 == key.row) return key.level;
  }
  return -1;
}

// Fails if a cut leaves a hole or covers ground twice, takes more tiles than it may, or leaves tiles out of
// which it had room for.
TEST(TileCut, CoversTheMapOnceWithinItsNumber) {
  const TiledMap map = wide_map();
  for (const std::size_t most : {1u, 5u, 40u, 150u, 5000u}) {
    const auto keys = choose_cut(map, {.eye_x_m = 3000.0, .eye_z_m = 9000.0, .pixel_rad = 2e-3}, most);
    EXPECT_LE(keys.size(), most);
    const std::vector<int> count = covered(map, keys);
    EXPECT_EQ(std::set<int>(count.begin(), count.end()), std::set<int>{1}) << most;
  }
  EXPECT_GT(choose_cut(map, {.eye_x_m = 3000.0, .eye_z_m = 9000.0, .pixel_rad = 2e-3}, 150).size(), 140u);
}

// Where there is room for all, a tile is as fine as a pixel asks, and no tile of the next level would do.
TEST(TileCut, CellsAreAboutAPixel) {
  const TiledMap map = wide_map();
  const double eye_x_m = 5000.0, eye_z_m = 100.0, pixel_rad = 4e-3;
  const auto keys = choose_cut(map, {.eye_x_m = eye_x_m, .eye_z_m = eye_z_m, .pixel_rad = pixel_rad}, 5000);
  std::set<int> levels;
  for (const TileKey& key : keys) {
    levels.insert(key.level);
    const auto nearest_m = [&](const TileKey& of) {
      const double side_m = 512.0 * std::ldexp(1.0, of.level);
      const double x = std::max({of.column * side_m - eye_x_m, eye_x_m - (of.column + 1) * side_m, 0.0});
      const double z = std::max({of.row * side_m - eye_z_m, eye_z_m - (of.row + 1) * side_m, 0.0});
      return std::hypot(x, z);
    };
    const double cell_m = std::ldexp(2.0, key.level);
    if (key.level > 0) {
      EXPECT_LE(cell_m, nearest_m(key) * pixel_rad);
    }
    if (key.level < map.shape.coarsest()) {
      EXPECT_GT(2.0 * cell_m, nearest_m(parent_of(key)) * pixel_rad);
    }
  }
  EXPECT_GE(levels.size(), 4u);
}

TEST(TileCut, HeightMakesItCoarser) {
  const TiledMap map = wide_map();
  const CutView low{.eye_x_m = 8000.0, .eye_z_m = 6000.0, .pixel_rad = 4e-3};
  CutView high = low;
  high.above_m = 5000.0;
  EXPECT_EQ(level_at(choose_cut(map, low, 5000), 4000, 3000), 0);
  EXPECT_GE(level_at(choose_cut(map, high, 5000), 4000, 3000), 3);
}

// At the western edge of a map that repeats the eastern edge is near, of one that mirrors it is not; far away
// all is as within the first copy.
TEST(TileCut, KnowsWhatIsBeyondTheEdge) {
  const CutView view{.eye_x_m = 10.0, .eye_z_m = 6000.0, .pixel_rad = 4e-3};
  EXPECT_GE(level_at(choose_cut(wide_map(), view, 5000), 7990, 3000), 2);
  EXPECT_EQ(level_at(choose_cut(wide_map(MapEdge::repeats), view, 5000), 7990, 3000), 0);
  EXPECT_GE(level_at(choose_cut(wide_map(MapEdge::mirrors), view, 5000), 7990, 3000), 2);
  CutView far = view;
  far.eye_x_m += 2.0 * 16'000.0 * 7.0;
  for (const MapEdge edge : {MapEdge::repeats, MapEdge::mirrors}) {
    EXPECT_EQ(choose_cut(wide_map(edge), view, 300), choose_cut(wide_map(edge), far, 300));
  }
}

}  // namespace
}  // namespace offing
