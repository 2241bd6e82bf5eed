#pragma once

#include <vector>

#include "host/base/height_tile.h"

namespace offing::terrain {

/// A tile as it lies in a slot of the device's pool (kernels/shared/terrain_tiles.h).
struct TileImage {
  TileKey key;
  std::vector<float> words;  ///< [TERRAIN_SLOT_FLOATS]
  /// [2^level][2^level] m: of each square of 256 cells of the map that the tile covers, the highest that the
  /// tile's surface has there.
  std::vector<float> square_maxima_m;
  std::vector<float> highest_m;  ///< [tile_posts][tile_posts], those of the tile
};

/// Spacings are the map's.
TileImage tile_image(const HeightTile& tile, double spacing_x_m, double spacing_z_m);

}  // namespace offing::terrain
