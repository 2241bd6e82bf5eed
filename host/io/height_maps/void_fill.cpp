#include "host/io/height_maps/void_fill.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace offing::height_maps {
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

constexpr std::size_t rows_a_band = 256;

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

VoidBands::VoidBands(int columns, std::optional<double> void_height_m,
                     std::function<void(std::span<const float>, std::span<const std::uint8_t>)> take)
    : columns_(static_cast<std::size_t>(columns)), void_height_m_(void_height_m), take_(std::move(take)) {}

void VoidBands::note(float height_m) {
  const bool is_first = posts_ == void_posts_ + 1;
  lowest_m_ = is_first ? height_m : std::min(lowest_m_, height_m);
  highest_m_ = is_first ? height_m : std::max(highest_m_, height_m);
}

void VoidBands::add(std::span<const float> heights_m, std::span<const std::uint8_t> is_void) {
  for (std::size_t row = 0; row < heights_m.size(); row += columns_) {
    for (std::size_t i = row; i < row + columns_; ++i) {
      ++posts_;
      if (is_void[i] == 0) {
        note(heights_m[i]);
      } else {
        ++void_posts_;
        ++band_voids_;
      }
    }
    const auto at = static_cast<std::ptrdiff_t>(row), end = static_cast<std::ptrdiff_t>(row + columns_);
    heights_m_.insert(heights_m_.end(), heights_m.begin() + at, heights_m.begin() + end);
    is_void_.insert(is_void_.end(), is_void.begin() + at, is_void.begin() + end);
    if (heights_m_.size() == (first_ + rows_a_band) * columns_) pass_on();
  }
}

void VoidBands::pass_on() {
  const std::size_t rows = heights_m_.size() / columns_;
  if (band_voids_ > 0) {
    const bool is_known = band_voids_ < (rows - first_) * columns_ || first_ == 1;
    if (is_known && !void_height_m_) {
      fill_voids(static_cast<int>(columns_), static_cast<int>(rows), heights_m_, is_void_);
    } else {
      const auto height_m = static_cast<float>(void_height_m_.value_or(0.0));
      for (std::size_t i = 0; i < heights_m_.size(); ++i) {
        if (is_void_[i] != 0) heights_m_[i] = height_m;
      }
    }
  }
  for (std::size_t row = first_; row < rows; ++row) {
    take_(std::span(heights_m_).subspan(row * columns_, columns_),
          std::span(is_void_).subspan(row * columns_, columns_));
  }
  heights_m_.erase(heights_m_.begin(), heights_m_.end() - static_cast<std::ptrdiff_t>(columns_));
  is_void_.assign(columns_, 0);
  first_ = 1;
  band_voids_ = 0;
}

void VoidBands::finish() {
  if (heights_m_.size() > first_ * columns_) pass_on();
}

}  // namespace offing::height_maps
