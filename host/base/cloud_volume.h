#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "kernels/shared/clouds.h"

namespace offing {

/// The density of a cloud on a grid of cells, of which only bricks with any density are kept. Cells are
/// cubes; a value is that of the middle of its cell, between middles it is trilinear, and beyond the grid
/// zero. Extinction is density times extinction_per_m (C3 of docs/sources.md).
struct CloudVolume {
  static constexpr int brick_cells = CLOUD_BRICK_CELLS;
  static constexpr std::size_t cells_of_brick = std::size_t{brick_cells} * brick_cells * brick_cells;
  static constexpr std::int32_t no_brick = -1;

  glm::dvec3 origin_m{0.0};       ///< the corner of least coordinates, in the world
  double cell_m = 1.0;            ///< above 0
  std::array<int, 3> bricks{};    ///< along x, y, z
  double extinction_per_m = 1.0;  ///< of density 1
  /// [bricks z][bricks y][bricks x]: place in `density` in bricks, or no_brick where there is none.
  std::vector<std::int32_t> brick_of;
  /// [kept bricks][z][y][x], dimensionless, 0 or more, finite.
  std::vector<float> density;
  /// One a value of `density`: single-scattering albedo, linear Rec.709, 0 ... 1. Empty: not told.
  std::vector<std::array<float, 3>> albedo = {};
};

/// Throws Error(bad_input) for a volume whose sizes or places of bricks do not fit each other, or with a
/// density that is negative, infinite or not a number.
void require_valid(const CloudVolume& volume);

}  // namespace offing
