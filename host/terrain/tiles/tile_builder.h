#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "host/base/height_tile.h"

namespace offing::terrain {

/// Cuts a map into tiles of all levels while its rows come in, from north to south. Keeps 260 rows of each
/// level: of a map of 32768 columns 0.1 GB.
class TileBuilder {
 public:
  /// `take` gets each tile once, in an order that depends on nothing but the shape.
  TileBuilder(const TileSetShape& shape, std::function<void(HeightTile)> take);

  /// Heights [columns] m of the next row, and 1 where nothing was measured; none where all was.
  void add_row(std::span<const float> heights_m, std::span<const std::uint8_t> is_void = {});

 private:
  /// Of cells of a level, or of posts.
  struct CellRow {
    std::vector<float> highest_m, means_m;
  };
  struct Level {
    int posts_x = 0, posts_z = 0;
    std::vector<std::vector<float>> highest_m,
        means_m;                             ///< the last rows of posts, by row modulo their number
    int rows = 0;                            ///< of posts that came in
    int next_tiles = 0;                      ///< row of tiles to be cut next
    CellRow before;                          ///< the row of cells before, joined to posts
    CellRow half;                            ///< the first of two rows of the level below
    int cell_rows = 0, cell_rows_below = 0;  ///< that came in
  };

  void add_posts(int level, std::span<const float> highest_m, std::span<const float> means_m);
  void add_cells_below(int level, const CellRow& cells);
  void add_cells(int level, const CellRow& cells);
  void cut_tiles(int level);
  void cut_voids(HeightTile& tile) const;

  TileSetShape shape_;
  std::function<void(HeightTile)> take_;
  std::vector<Level> levels_;
  std::vector<float> row_before_m_;
  std::vector<std::vector<std::uint8_t>> is_void_;  ///< as highest_m of level 0; empty rows have no voids
};

}  // namespace offing::terrain
