#include "host/clouds/field_albedo.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <glm/common.hpp>

namespace offing::clouds {
namespace {

constexpr int n = CloudVolume::brick_cells;

/// Where the value of a cell is; nothing where it has none.
std::optional<std::size_t> value_of(const CloudVolume& volume, const std::array<int, 3>& cell) {
  std::size_t brick = 0, inside = 0;
  for (std::size_t axis = 3; axis-- > 0;) {
    if (cell[axis] < 0 || cell[axis] >= volume.bricks[axis] * n) return std::nullopt;
    brick = brick * static_cast<std::size_t>(volume.bricks[axis]) + static_cast<std::size_t>(cell[axis] / n);
    inside = inside * n + static_cast<std::size_t>(cell[axis] % n);
  }
  const std::int32_t slot = volume.brick_of[brick];
  if (slot == CloudVolume::no_brick) return std::nullopt;
  return static_cast<std::size_t>(slot) * CloudVolume::cells_of_brick + inside;
}

std::array<float, 3> albedo_at(const CloudVolume& shape, const glm::dvec3& place_m) {
  const glm::dvec3 cells = (place_m - shape.origin_m) / shape.cell_m - 0.5, low = glm::floor(cells);
  const glm::dvec3 share = cells - low;
  glm::dvec3 sum(0.0);
  double total = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    std::array<int, 3> cell{};
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const int up = corner >> axis & 1;
      cell[static_cast<std::size_t>(axis)] = static_cast<int>(low[axis]) + up;
      weight *= up == 1 ? share[axis] : 1.0 - share[axis];
    }
    const std::optional<std::size_t> value = value_of(shape, cell);
    if (!value) continue;
    weight *= static_cast<double>(shape.density[*value]);
    const auto& [red, green, blue] = shape.albedo[*value];
    sum += weight * glm::dvec3(red, green, blue);
    total += weight;
  }
  if (!(total > 0.0)) return {1.0f, 1.0f, 1.0f};
  sum /= total;
  return {static_cast<float>(sum.x), static_cast<float>(sum.y), static_cast<float>(sum.z)};
}

}  // namespace

std::vector<std::array<float, 3>> field_albedo(const CloudVolume& shape, const CloudVolume& field) {
  std::vector<std::array<float, 3>> albedo(field.density.size(), {1.0f, 1.0f, 1.0f});
  std::size_t number = 0;
  for (int z = 0; z < field.bricks[2]; ++z) {
    for (int y = 0; y < field.bricks[1]; ++y) {
      for (int x = 0; x < field.bricks[0]; ++x) {
        const std::int32_t slot = field.brick_of[number++];
        if (slot == CloudVolume::no_brick) continue;
        for (int cell = 0; cell < n * n * n; ++cell) {
          const std::size_t value =
              static_cast<std::size_t>(slot) * CloudVolume::cells_of_brick + static_cast<std::size_t>(cell);
          if (field.density[value] <= 0.0f) continue;
          const glm::dvec3 place(x * n + cell % n, y * n + cell / n % n, z * n + cell / n / n);
          albedo[value] = albedo_at(shape, field.origin_m + (place + 0.5) * field.cell_m);
        }
      }
    }
  }
  return albedo;
}

}  // namespace offing::clouds
