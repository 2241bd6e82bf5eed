#include "host/clouds/light/field_albedo.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <glm/common.hpp>

#include "host/clouds/shape/cloud_density.h"

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

bool has_one_grey(std::span<const CloudParticle> particles) {
  return std::all_of(particles.begin(), particles.end(), [&](const CloudParticle& particle) {
    const float grey = particles.front().red;
    return particle.red == grey && particle.green == grey && particle.blue == grey;
  });
}

/// The value of a cell of a brick at a place of `brick_of`, 0 where there is none.
float value_in(const CloudVolume& volume, std::size_t place, std::size_t cell) {
  const std::int32_t slot = volume.brick_of[place];
  if (slot == CloudVolume::no_brick) return 0.0f;
  return volume.density[static_cast<std::size_t>(slot) * CloudVolume::cells_of_brick + cell];
}

}  // namespace

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

std::vector<std::array<float, 3>> rasterised_albedo(const ocl::Device& device,
                                                    std::span<const CloudParticle> particles,
                                                    const CloudVolume& volume) {
  if (has_one_grey(particles)) return {};
  std::vector<std::array<float, 3>> albedo(volume.density.size());
  constexpr std::array<float CloudParticle::*, 3> channels{&CloudParticle::red, &CloudParticle::green,
                                                           &CloudParticle::blue};
  for (std::size_t channel = 0; channel < channels.size(); ++channel) {
    std::vector<CloudParticle> weighted(particles.begin(), particles.end());
    for (CloudParticle& particle : weighted) particle.optical_mass *= particle.*channels[channel];
    const CloudVolume scattered = rasterised(device, weighted, volume.cell_m, volume.extinction_per_m);
    for (std::size_t place = 0; place < volume.brick_of.size(); ++place) {
      const std::int32_t slot = volume.brick_of[place];
      if (slot == CloudVolume::no_brick) continue;
      for (std::size_t cell = 0; cell < CloudVolume::cells_of_brick; ++cell) {
        const std::size_t here = static_cast<std::size_t>(slot) * CloudVolume::cells_of_brick + cell;
        const float density = volume.density[here];
        albedo[here][channel] =
            density > 0.0f ? std::min(value_in(scattered, place, cell) / density, 1.0f) : 0.0f;
      }
    }
  }
  return albedo;
}

}  // namespace offing::clouds
