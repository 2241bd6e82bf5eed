#pragma once

#include <compare>
#include <cstdint>
#include <vector>

/// Tiles of several levels that a large height map is cut into.
namespace offing {

/// A tile has this many cells a side, and a post more.
inline constexpr int tile_cells = 256;
inline constexpr int tile_posts = tile_cells + 1;
/// With one post more on each side.
inline constexpr int ringed_tile_posts = tile_posts + 2;

/// A tile of a map: level L has posts 2^L posts of the map apart, columns and rows of tiles count from the
/// north-west.
struct TileKey {
  int level = 0, column = 0, row = 0;
  friend auto operator<=>(const TileKey&, const TileKey&) = default;
};

/// The tile of the next level that covers this one.
inline TileKey parent_of(const TileKey& key) {
  return {key.level + 1, key.column / 2, key.row / 2};
}

/// How a map is cut into tiles of all levels.
struct TileSetShape {
  int columns = 0, rows = 0;  ///< posts of the map, at least 2
  int levels = 1;

  /// As many levels as it takes until one tile covers the map, at most 9: a cell of level 8 is as wide as a
  /// tile of level 0.
  static TileSetShape of(int columns, int rows);

  /// Cells of a level, the last ones beyond the map's edge in part.
  int cells_x(int level) const { return ((columns - 2) >> level) + 1; }
  int cells_z(int level) const { return ((rows - 2) >> level) + 1; }
  int tiles_x(int level) const { return (cells_x(level) - 1) / tile_cells + 1; }
  int tiles_z(int level) const { return (cells_z(level) - 1) / tile_cells + 1; }
  int coarsest() const { return levels - 1; }
  long long tile_count() const;
};

/// The ground of a tile. Beyond the map's edge heights are those of the edge, and means go on straight.
struct HeightTile {
  TileKey key;
  /// [tile_posts][tile_posts] m. At level 0 the map's heights; else of each post the highest of the map
  /// within a cell of this level around it, so that the bilinear surface between is nowhere below the map's.
  std::vector<float> highest_m;
  /// [ringed_tile_posts][ringed_tile_posts] m, from the post before the tile's first one on: means over the
  /// four cells of this level around, for slopes. At level 0 the map's heights.
  std::vector<float> means_m;
  /// [tile_posts][tile_posts], at level 0: 1 where nothing was measured; empty if all was, and above.
  std::vector<std::uint8_t> is_void = {};
};

}  // namespace offing
