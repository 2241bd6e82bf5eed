// Phasor noise that runs downhill.
#include "host/terrain/generate/gullies.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "kernels/shared/random.h"

namespace offing::terrain {
namespace {

// Spots of gullies lie in the middle half of their cells and reach so far, in cells: every place is within
// one, and none reaches over a whole cell into the next.
constexpr double reach = 1.25;
// The slope at which a cut is half as deep as in a cliff.
constexpr double half_deep_slope = 0.35;

}  // namespace

Gullies::Gullies(double width_m, double depth, double side_m, std::uint64_t seed, int index)
    : width_m_(width_m),
      depth_(depth),
      columns_(static_cast<int>(side_m / width_m * cells_a_width) +
               4),  // of which rounding may need the last
      seed_(seed),
      index_(index),
      top_(std::numeric_limits<int>::min()) {}

std::vector<Gullies::Spot> Gullies::row_of_spots(int row) const {
  std::vector<Spot> spots;
  for (int column = -1; column < columns_ - 1; ++column) {
    const PhiloxBlock block =
        philox_block(static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32),
                     OFFING_STREAM_TERRAIN_GULLIES, column, row, static_cast<std::uint32_t>(index_));
    spots.push_back(
        {column + 0.25 + 0.5 * uniform_open01(block.v[0]), row + 0.25 + 0.5 * uniform_open01(block.v[1])});
  }
  return spots;
}

void Gullies::move_to(double z_m) {
  const int top = static_cast<int>(z_m / width_m_ * cells_a_width) - 1;
  if (top == top_) return;
  const bool is_next = top_ != std::numeric_limits<int>::min() && top == top_ + 1;
  if (is_next) {
    std::swap(rows_[0], rows_[1]);
    std::swap(rows_[1], rows_[2]);
    rows_[2] = row_of_spots(top + 2);
  } else {
    for (int i = 0; i < 3; ++i) rows_[static_cast<std::size_t>(i)] = row_of_spots(top + i);
  }
  top_ = top;
}

Gullies::Cut Gullies::at(double x_m, double z_m, double slope_x, double slope_z) const {
  const double slope = std::sqrt(slope_x * slope_x + slope_z * slope_z);
  if (slope == 0.0) return {};
  // Across the slope, radians a cell: two gullies' widths are a cell's side.
  const double turn = 2.0 * std::numbers::pi / cells_a_width;
  const double wave_x = -slope_z / slope * turn, wave_z = slope_x / slope * turn;
  const double x = x_m / width_m_ * cells_a_width, z = z_m / width_m_ * cells_a_width;
  const auto column = static_cast<std::size_t>(x);
  double real = 0.0, imaginary = 0.0;
  for (const std::vector<Spot>& row : rows_) {
    for (std::size_t i = column; i < column + 3; ++i) {
      const double from_x = x - row[i].x, from_z = z - row[i].z;
      const double near = 1.0 - (from_x * from_x + from_z * from_z) / (reach * reach);
      if (near <= 0.0) continue;
      const double weight = near * near, phase = wave_x * from_x + wave_z * from_z;
      real += weight * std::cos(phase);
      imaginary += weight * std::sin(phase);
    }
  }
  const double size = std::sqrt(real * real + imaginary * imaginary);
  if (size == 0.0) return {};
  const double half_depth_m =
      0.5 * depth_ * width_m_ * slope * slope / (slope * slope + half_deep_slope * half_deep_slope);
  // radians a metre
  const double steepness = -half_depth_m * imaginary / size * cells_a_width / width_m_;
  return {.height_m = half_depth_m * (real / size - 1.0),
          .slope_x = steepness * wave_x,
          .slope_z = steepness * wave_z};
}

}  // namespace offing::terrain
