#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Height maps, and the tiles of several levels that a large map is cut into.
namespace offing {

/// Where the posts of a height map lie in a coordinate system of the world's: post (column, row) at
/// (origin_x + column * step_x, origin_y + row * step_y), in the units of that system. step_y is negative
/// where rows go south.
struct Georeference {
  std::string coordinate_system;  ///< as WKT; empty where the file names none
  double origin_x = 0.0, origin_y = 0.0;
  double step_x = 0.0, step_y = 0.0;
};

/// Heights of the ground at the posts of a regular grid: each value is the height at its post, not of a cell
/// around it, and between posts the ground is bilinear. Row 0 is the north edge; x grows east with the
/// column, z south with the row.
struct HeightMap {
  int columns = 0, rows = 0;                    ///< at least 2
  double spacing_x_m = 1.0, spacing_z_m = 1.0;  ///< between neighbouring posts, above 0
  std::vector<float> heights_m;                 ///< [rows][columns], finite, also where nothing was measured
  /// [rows][columns], 1 where the source had no height and heights_m is filled in; empty if it had all.
  std::vector<std::uint8_t> is_void;
  Georeference georeference;  ///< step 0 where the source has none

  /// Place of a post in heights_m and is_void.
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
};

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
