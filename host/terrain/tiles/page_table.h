#pragma once

#include <vector>

#include "host/base/height_tile.h"

namespace offing::terrain {

/// Squares of tile_cells x tile_cells cells of a map, padded to whole nodes of the pyramid's top level.
struct PagesShape {
  int columns = 0, rows = 0;  ///< multiples of 2^(top_level - 8)
  int top_level = 0;

  static PagesShape of(const TileSetShape& shape);
  /// Floats of the maxima of nodes of whole squares, all levels.
  std::size_t maximum_count() const;
};

/// Which tile lies on each square, and the pyramid above (kernels/shared/terrain_tiles.h).
class PageTable {
 public:
  explicit PageTable(const TileSetShape& shape);

  /// Lays the part of a resident tile that `covered`, itself or one of those it covers, takes up.
  /// square_maxima_m as tile_image.h has them.
  void lay(const TileKey& covered, const TileKey& resident, int slot,
           const std::vector<float>& square_maxima_m);
  /// Once every square has been laid.
  void reduce_maxima();

  /// Level of the tile that lies on a square.
  int level_at(int column, int row) const;

  const PagesShape& shape() const { return pages_shape_; }
  const std::vector<float>& pages() const { return pages_; }        ///< [rows][columns]
  const std::vector<float>& maxima_m() const { return maxima_m_; }  ///< level 8 and up, one behind the other

 private:
  TileSetShape shape_;
  PagesShape pages_shape_;
  std::vector<float> pages_, maxima_m_;
};

}  // namespace offing::terrain
