#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include "host/base/cloud_volume.h"

namespace offing::clouds {

/// Calls visit(middle of the cell in the world, density) for each cell of the kept bricks.
template <typename Visit>
void for_cells(const CloudVolume& volume, const Visit& visit) {
  constexpr int n = CloudVolume::brick_cells;
  std::size_t number = 0;
  for (int k = 0; k < volume.bricks[2]; ++k) {
    for (int j = 0; j < volume.bricks[1]; ++j) {
      for (int i = 0; i < volume.bricks[0]; ++i) {
        const std::int32_t brick = volume.brick_of[number++];
        if (brick == CloudVolume::no_brick) continue;
        for (int cell = 0; cell < n * n * n; ++cell) {
          const glm::dvec3 place(i * n + cell % n, j * n + cell / n % n, k * n + cell / n / n);
          visit(volume.origin_m + (place + 0.5) * volume.cell_m,
                volume.density[static_cast<std::size_t>(brick) * CloudVolume::cells_of_brick +
                               static_cast<std::size_t>(cell)]);
        }
      }
    }
  }
}

/// The density of the cell that a place of the world lies in.
inline double density_at(const CloudVolume& volume, const glm::dvec3& place_m) {
  constexpr int n = CloudVolume::brick_cells;
  const glm::dvec3 cell = (place_m - volume.origin_m) / volume.cell_m;
  const int x = static_cast<int>(cell.x), y = static_cast<int>(cell.y), z = static_cast<int>(cell.z);
  if (cell.x < 0.0 || cell.y < 0.0 || cell.z < 0.0) return 0.0;
  if (x / n >= volume.bricks[0] || y / n >= volume.bricks[1] || z / n >= volume.bricks[2]) return 0.0;
  const std::int32_t brick =
      volume
          .brick_of[static_cast<std::size_t>((z / n * volume.bricks[1] + y / n) * volume.bricks[0] + x / n)];
  if (brick == CloudVolume::no_brick) return 0.0;
  return static_cast<double>(volume.density[static_cast<std::size_t>(brick) * CloudVolume::cells_of_brick +
                                            static_cast<std::size_t>(((z % n) * n + y % n) * n + x % n)]);
}

}  // namespace offing::clouds
