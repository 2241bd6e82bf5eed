#include "host/io/height_maps/void_bands.h"

#include <algorithm>
#include <utility>

#include "host/io/height_maps/void_fill.h"

namespace offing::height_maps {
namespace {

constexpr std::size_t rows_a_band = 256;

}  // namespace

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
