#include "host/io/height_maps/void_fill.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace offing {

namespace {

struct Level {
  int columns = 0, rows = 0;
  std::vector<float> heights_m;
  std::vector<std::uint8_t> is_unknown;

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  bool has_gaps() const { return std::find(is_unknown.begin(), is_unknown.end(), 1) != is_unknown.end(); }
};

/// Means of the known among two by two; unknown where all are.
Level coarser(const Level& fine) {
  Level coarse{(fine.columns + 1) / 2, (fine.rows + 1) / 2, {}, {}};
  for (int row = 0; row < coarse.rows; ++row) {
    for (int column = 0; column < coarse.columns; ++column) {
      float sum_m = 0.0f;
      int known = 0;
      for (int r = 2 * row; r < std::min(2 * row + 2, fine.rows); ++r) {
        for (int c = 2 * column; c < std::min(2 * column + 2, fine.columns); ++c) {
          if (fine.is_unknown[fine.index(c, r)] == 0) {
            sum_m += fine.heights_m[fine.index(c, r)];
            ++known;
          }
        }
      }
      coarse.heights_m.push_back(known > 0 ? sum_m / static_cast<float>(known) : 0.0f);
      coarse.is_unknown.push_back(known > 0 ? 0 : 1);
    }
  }
  return coarse;
}

/// Height of the coarse level at the centre of a fine post: the two nearest along each side, 3 to 1.
float interpolate(const Level& coarse, int column, int row) {
  const int c0 = column / 2, r0 = row / 2;
  const int c1 = std::clamp(column % 2 == 0 ? c0 - 1 : c0 + 1, 0, coarse.columns - 1);
  const int r1 = std::clamp(row % 2 == 0 ? r0 - 1 : r0 + 1, 0, coarse.rows - 1);
  const auto& h = coarse.heights_m;
  return 0.5625f * h[coarse.index(c0, r0)] + 0.1875f * (h[coarse.index(c1, r0)] + h[coarse.index(c0, r1)]) +
         0.0625f * h[coarse.index(c1, r1)];
}

}  // namespace

void fill_voids(int columns, int rows, std::span<float> heights_m, std::span<const std::uint8_t> is_void) {
  std::vector<Level> levels;
  levels.push_back({columns, rows, {heights_m.begin(), heights_m.end()}, {is_void.begin(), is_void.end()}});
  while (levels.back().has_gaps() && (levels.back().columns > 1 || levels.back().rows > 1)) {
    levels.push_back(coarser(levels.back()));
  }
  // From the coarsest level, which has no gaps, down: each fills those of the next.
  for (std::size_t finer = levels.size() - 1; finer-- > 0;) {
    Level& level = levels[finer];
    for (int row = 0; row < level.rows; ++row) {
      for (int column = 0; column < level.columns; ++column) {
        if (level.is_unknown[level.index(column, row)] != 0) {
          level.heights_m[level.index(column, row)] = interpolate(levels[finer + 1], column, row);
        }
      }
    }
  }
  std::copy(levels[0].heights_m.begin(), levels[0].heights_m.end(), heights_m.begin());
}

}  // namespace offing
