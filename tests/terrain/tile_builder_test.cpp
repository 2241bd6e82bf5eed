// Tiles of all levels against the map that they were cut from.
#include "host/terrain/tiles/tile_builder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "tests/terrain/example_tiles.h"

namespace offing {
namespace {

float post(const HeightTile& tile, int column, int row) {
  return tile.highest_m[static_cast<std::size_t>(row * tile_posts + column)];
}

/// A post of the means, -1 ... tile_posts.
float mean_of(const HeightTile& tile, int column, int row) {
  return tile.means_m[static_cast<std::size_t>((row + 1) * ringed_tile_posts + column + 1)];
}

/// Highest post of the map within so many posts of a place.
float highest_around(const test::HeightMap& map, int column, int row, int reach) {
  float highest = -1e9f;
  for (int z = std::max(0, row - reach); z <= std::min(map.grid.rows - 1, row + reach); ++z) {
    for (int x = std::max(0, column - reach); x <= std::min(map.grid.columns - 1, column + reach); ++x) {
      highest = std::max(highest, map.at(x, z));
    }
  }
  return highest;
}

TEST(TileSetShape, CoversAMapByEveryLevel) {
  const TileSetShape shape = TileSetShape::of(32768, 32768);
  EXPECT_EQ(shape.levels, 8);
  EXPECT_EQ(shape.tiles_x(0), 128);
  EXPECT_EQ(shape.tiles_x(7), 1);
  EXPECT_EQ(shape.tile_count(), 21845);
  EXPECT_EQ(TileSetShape::of(257, 2).levels, 1);
  EXPECT_EQ(TileSetShape::of(258, 2).levels, 2);
  EXPECT_EQ(TileSetShape::of(1 << 18, 300).levels, 9)
      << "a cell of the coarsest level is a tile of the finest";
}

// Fails if a void is lost, or moved, on its way into the tiles; posts on the border of two tiles are in both.
TEST(TileBuilder, KeepsVoids) {
  const TileSetShape shape = TileSetShape::of(600, 530);
  std::map<TileKey, HeightTile> tiles;
  terrain::TileBuilder builder(shape, [&](HeightTile tile) { tiles.emplace(tile.key, tile); });
  const auto is_void = [](int column, int row) {
    return row >= 255 && row <= 300 && (column * 7 + row) % 90 == 0;
  };
  std::vector<float> heights_m(600);
  std::vector<std::uint8_t> voids(600);
  for (int row = 0; row < 530; ++row) {
    for (int column = 0; column < 600; ++column)
      voids[static_cast<std::size_t>(column)] = is_void(column, row) ? 1 : 0;
    builder.add_row(heights_m, voids);
  }
  ASSERT_EQ(static_cast<long long>(tiles.size()), shape.tile_count());
  int found = 0;
  for (const auto& [key, tile] : tiles) {
    if (key.level > 0 || key.row == 2) {
      EXPECT_TRUE(tile.is_void.empty()) << key.level << ", " << key.row;
      continue;
    }
    ASSERT_EQ(tile.is_void.size(), static_cast<std::size_t>(tile_posts * tile_posts));
    for (int row = 0; row < tile_posts; ++row) {
      for (int column = 0; column < tile_posts; ++column) {
        const int x = key.column * tile_cells + column, z = key.row * tile_cells + row;
        const bool expected = x < 600 && z < 530 && is_void(x, z);
        ASSERT_EQ(tile.is_void[static_cast<std::size_t>(row * tile_posts + column)] != 0, expected)
            << x << ", " << z;
        found += expected ? 1 : 0;
      }
    }
  }
  EXPECT_GT(found, 100);
}

// Fails if a tile is missing, comes twice, or level 0 is not the map to the last bit, held on beyond its
// edge.
TEST(TileBuilder, CutsTheMapItself) {
  const test::ExampleTiles example = test::hilly_tiles();
  EXPECT_EQ(static_cast<long long>(example.tiles().size()), example.shape().tile_count());
  for (const auto& [key, tile] : example.tiles()) {
    ASSERT_EQ(tile.highest_m.size(), static_cast<std::size_t>(tile_posts * tile_posts));
    if (key.level > 0) continue;
    for (int row = 0; row < tile_posts; row += 3) {
      for (int column = 0; column < tile_posts; ++column) {
        const int x = std::min(key.column * tile_cells + column, example.map().grid.columns - 1);
        const int z = std::min(key.row * tile_cells + row, example.map().grid.rows - 1);
        ASSERT_EQ(post(tile, column, row), example.map().at(x, z)) << x << ", " << z;
      }
    }
  }
}

// Fails if a coarse surface is below the map's anywhere, or higher than it must be: the posts of a level are
// just the highest of the map within one of its cells. What follows for the surfaces: between the posts of a
// coarse cell both are mixtures of their corners, and each coarse corner is at least as high as all of the
// map's in the cell.
TEST(TileBuilder, CoarsePostsAreTheHighestAround) {
  for (const test::ExampleTiles& example :
       {test::hilly_tiles(), test::ExampleTiles(test::valleys({.columns = 513, .rows = 300}))}) {
    for (const auto& [key, tile] : example.tiles()) {
      if (key.level == 0) continue;
      const int cell = 1 << key.level;
      for (int row = 0; row < tile_posts; row += 5) {
        for (int column = 0; column < tile_posts; column += 5) {
          const int x = (key.column * tile_cells + column) * cell, z = (key.row * tile_cells + row) * cell;
          if (x > example.map().grid.columns - 1 || z > example.map().grid.rows - 1) continue;
          ASSERT_EQ(post(tile, column, row), highest_around(example.map(), x, z, cell))
              << "level " << key.level << " at " << x << ", " << z;
        }
      }
    }
  }
}

// Fails if neighbours of a level differ on their common edge, which would be a step in the ground.
TEST(TileBuilder, NeighboursShareTheirEdges) {
  const test::ExampleTiles example = test::hilly_tiles();
  int edges = 0;
  for (const auto& [key, tile] : example.tiles()) {
    const auto east = example.tiles().find({key.level, key.column + 1, key.row});
    const auto south = example.tiles().find({key.level, key.column, key.row + 1});
    for (int i = 0; i < tile_posts; ++i) {
      if (east != example.tiles().end()) {
        ASSERT_EQ(post(tile, tile_cells, i), post(east->second, 0, i));
        ASSERT_EQ(mean_of(tile, tile_posts, i), mean_of(east->second, 1, i)) << "rings reach into neighbours";
        ++edges;
      }
      if (south != example.tiles().end()) {
        ASSERT_EQ(post(tile, i, tile_cells), post(south->second, i, 0));
        ASSERT_EQ(mean_of(tile, i, tile_posts), mean_of(south->second, i, 1));
        ++edges;
      }
    }
  }
  EXPECT_GT(edges, 10 * tile_posts);
}

// A ramp's means are the ramp, at every level, up to the edges of a map of whole coarse cells: light must not
// change with the level. Sums of floats below 1e3 m: 20 roundings of 6e-5 m, gate 2e-3 m.
TEST(TileBuilder, MeansKeepSlopes) {
  test::HeightMap map{"ramp", {.columns = 513, .rows = 513}, {}};
  for (int row = 0; row < 513; ++row) {
    for (int column = 0; column < 513; ++column)
      map.heights_m.push_back(static_cast<float>(0.75 * column - 0.5 * row));
  }
  const test::ExampleTiles example(map);
  for (const auto& [key, tile] : example.tiles()) {
    const int cell = 1 << key.level;
    for (int row = -1; row <= tile_posts; row += 6) {
      for (int column = -1; column <= tile_posts; ++column) {
        const int x = (key.column * tile_cells + column) * cell, z = (key.row * tile_cells + row) * cell;
        ASSERT_NEAR(mean_of(tile, column, row), 0.75 * x - 0.5 * z, 2e-3) << "level " << key.level;
      }
    }
  }
}

}  // namespace
}  // namespace offing
