#include "host/terrain/tiles/page_table.h"

#include <algorithm>
#include <bit>
#include <cfloat>

#include "kernels/shared/terrain_tiles.h"

namespace offing::terrain {
namespace {

int levels_above(int squares) {
  return static_cast<int>(std::bit_width(static_cast<unsigned>(squares - 1)));
}

int padded(int squares, int levels) {
  return (((squares - 1) >> levels) + 1) << levels;
}

}  // namespace

PagesShape PagesShape::of(const TileSetShape& shape) {
  const int columns = shape.tiles_x(0), rows = shape.tiles_z(0);
  // Of a long strip the top has several nodes, so that padding is at most three quarters.
  const int levels =
      std::min(levels_above(std::max(columns, rows)), levels_above(std::min(columns, rows)) + 2);
  return {padded(columns, levels), padded(rows, levels), TERRAIN_TILE_LOG2 + levels};
}

std::size_t PagesShape::maximum_count() const {
  std::size_t count = 0;
  for (int level = 0; level <= top_level - TERRAIN_TILE_LOG2; ++level) {
    count += static_cast<std::size_t>(columns >> level) * static_cast<std::size_t>(rows >> level);
  }
  return count;
}

PageTable::PageTable(const TileSetShape& shape)
    : shape_(shape),
      pages_shape_(PagesShape::of(shape)),
      pages_(static_cast<std::size_t>(pages_shape_.columns) * static_cast<std::size_t>(pages_shape_.rows)),
      maxima_m_(pages_shape_.maximum_count(), -FLT_MAX) {}

void PageTable::lay(const TileKey& covered, const TileKey& resident, int slot,
                    const std::vector<float>& square_maxima_m) {
  const int side = 1 << covered.level, maxima_side = 1 << resident.level;
  const int first_row = covered.row << covered.level, first_column = covered.column << covered.level;
  const auto page = static_cast<float>(slot * TERRAIN_PAGE_LEVELS + resident.level);
  for (int row = first_row; row < std::min(first_row + side, shape_.tiles_z(0)); ++row) {
    for (int column = first_column; column < std::min(first_column + side, shape_.tiles_x(0)); ++column) {
      const auto place = static_cast<std::size_t>(row * pages_shape_.columns + column);
      const int maximum_row = row - (resident.row << resident.level),
                maximum_column = column - (resident.column << resident.level);
      pages_[place] = page;
      maxima_m_[place] =
          square_maxima_m[static_cast<std::size_t>(maximum_row * maxima_side + maximum_column)];
    }
  }
}

int PageTable::level_at(int column, int row) const {
  return static_cast<int>(pages_[static_cast<std::size_t>(row * pages_shape_.columns + column)]) %
         TERRAIN_PAGE_LEVELS;
}

void PageTable::reduce_maxima() {
  auto below = static_cast<std::size_t>(0);
  for (int level = 1; level <= pages_shape_.top_level - TERRAIN_TILE_LOG2; ++level) {
    const auto columns = static_cast<std::size_t>(pages_shape_.columns >> level),
               rows = static_cast<std::size_t>(pages_shape_.rows >> level);
    const std::size_t target = below + 4 * columns * rows;
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        const float* north = maxima_m_.data() + below + 4 * row * columns + 2 * column;
        const float* south = north + 2 * columns;
        maxima_m_[target + row * columns + column] =
            std::max(std::max(north[0], north[1]), std::max(south[0], south[1]));
      }
    }
    below = target;
  }
}

}  // namespace offing::terrain
