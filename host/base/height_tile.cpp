// How many tiles a height map is cut into.
#include "host/base/height_tile.h"

namespace offing {

TileSetShape TileSetShape::of(int columns, int rows) {
  constexpr int most_levels = 9;
  TileSetShape shape{columns, rows, 1};
  while (shape.levels < most_levels &&
         (shape.tiles_x(shape.coarsest()) > 1 || shape.tiles_z(shape.coarsest()) > 1)) {
    ++shape.levels;
  }
  return shape;
}

long long TileSetShape::tile_count() const {
  long long count = 0;
  for (int level = 0; level < levels; ++level) count += 1LL * tiles_x(level) * tiles_z(level);
  return count;
}

}  // namespace offing
