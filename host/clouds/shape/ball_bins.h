#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "kernels/shared/clouds.h"

namespace offing::clouds {

/// A box of bricks of cells.
struct BrickGrid {
  glm::dvec3 corner_m{0.0};  ///< of least coordinates, in the axes of what lies in it; a whole brick from 0
  double cell_m = 1.0;
  std::array<int, 3> bricks{};

  std::size_t brick_count() const;
};

/// The grid around a box. Throws Error(bad_input) where it would have more bricks than can be counted.
BrickGrid grid_around(const glm::dvec3& low_m, const glm::dvec3& high_m, double cell_m);

/// Which balls have density in which bricks of a grid.
struct BallBins {
  std::vector<std::uint32_t> brick_index;  ///< of bricks with any ball, x fastest, ascending
  std::vector<std::uint32_t> begin;        ///< [bricks with any + 1], into balls
  std::vector<std::uint32_t> balls;        ///< by number, ascending in each brick
};

/// balls: places relative to the corner of the grid. Throws Error(bad_input) where bricks and balls meet too
/// often to be held.
BallBins ball_bins(const BrickGrid& grid, std::span<const CloudBall> balls);

/// Throws Error(bad_input) where this many bricks of density are more than can be held.
void require_holdable(std::size_t bricks, double cell_m);

}  // namespace offing::clouds
