#include "host/clouds/particles/volume_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

namespace offing::clouds {
namespace {

constexpr int n = CloudVolume::brick_cells;

/// Calls visit(block, sample) for every cell with density, brick by brick along x, then y, then z, until one
/// returns false; whether none did. Blocks have `factor` cells along an edge.
template <typename Visit>
bool for_cells(const CloudVolume& volume, int factor, const Work& work, const Visit& visit) {
  const double cell_m3 = volume.cell_m * volume.cell_m * volume.cell_m;
  std::size_t number = 0;
  for (int z = 0; z < volume.bricks[2]; ++z) {
    for (int y = 0; y < volume.bricks[1]; ++y) {
      work.poll();
      for (int x = 0; x < volume.bricks[0]; ++x) {
        const std::int32_t brick = volume.brick_of[number++];
        if (brick == CloudVolume::no_brick) continue;
        const float* density =
            volume.density.data() + static_cast<std::size_t>(brick) * CloudVolume::cells_of_brick;
        for (int cell = 0; cell < n * n * n; ++cell) {
          if (density[cell] <= 0.0f) continue;
          const std::array<int, 3> place{x * n + cell % n, y * n + cell / n % n, z * n + cell / n / n};
          VolumeSample sample{{place[0] / factor, place[1] / factor, place[2] / factor},
                              (glm::dvec3(place[0], place[1], place[2]) + 0.5) * volume.cell_m,
                              static_cast<double>(density[cell]) * cell_m3,
                              0.25 * volume.cell_m * volume.cell_m};  // of a cube: edge^2 / 12 an axis
          if (!volume.albedo.empty()) {
            const auto& [red, green, blue] =
                volume.albedo[static_cast<std::size_t>(density + cell - volume.density.data())];
            sample.albedo = {red, green, blue};
          }
          if (!visit(sample)) return false;
        }
      }
    }
  }
  return true;
}

/// Blocks of a volume in the order in which they are met; nothing where they are more than `most`.
std::optional<std::vector<VolumeSample>> blocks_of(const CloudVolume& volume, int factor, std::size_t most,
                                                   const Work& work) {
  std::vector<VolumeSample> blocks;
  std::unordered_map<std::uint64_t, std::size_t> place_of;
  const auto along = [&](std::size_t axis) {
    return static_cast<std::uint64_t>(volume.bricks[axis] * n / factor + 1);
  };
  const bool fits = for_cells(volume, factor, work, [&](const VolumeSample& cell) {
    // Cells of a row come one after another.
    if (!blocks.empty() && blocks.back().block == cell.block) {
      blocks.back() = merged(blocks.back(), cell);
      return true;
    }
    const auto at = [&](std::size_t axis) { return static_cast<std::uint64_t>(cell.block[axis]); };
    const std::uint64_t key = (at(2) * along(1) + at(1)) * along(0) + at(0);
    const auto [place, is_new] = place_of.try_emplace(key, blocks.size());
    if (is_new) {
      blocks.push_back(cell);
    } else {
      blocks[place->second] = merged(blocks[place->second], cell);
    }
    return blocks.size() <= most;
  });
  if (!fits) return std::nullopt;
  return blocks;
}

}  // namespace

VolumeSample merged(const VolumeSample& a, const VolumeSample& b) {
  const double mass = a.mass + b.mass;
  const glm::dvec3 apart_m = a.place_m - b.place_m;
  const double share = b.mass / mass;
  return {
      a.block, a.place_m - share * apart_m, mass,
      (1.0 - share) * a.square_m2 + share * b.square_m2 + share * (1.0 - share) * glm::dot(apart_m, apart_m),
      a.albedo + static_cast<float>(share) * (b.albedo - a.albedo)};
}

VolumeBlocks volume_samples(const CloudVolume& volume, std::size_t most, const Work& work) {
  const auto count = static_cast<double>(std::count_if(volume.density.begin(), volume.density.end(),
                                                       [](float density) { return density > 0.0f; }));
  // So many cells are never in fewer blocks than this factor cubed holds.
  int factor =
      std::max(1, static_cast<int>(std::cbrt(count / static_cast<double>(std::max<std::size_t>(most, 1)))));
  std::optional<std::vector<VolumeSample>> blocks;
  while (!(blocks = blocks_of(volume, factor, most, work))) ++factor;
  std::sort(blocks->begin(), blocks->end(), [](const VolumeSample& a, const VolumeSample& b) {
    return std::array{a.block[2], a.block[1], a.block[0]} < std::array{b.block[2], b.block[1], b.block[0]};
  });
  return {std::move(*blocks), factor * volume.cell_m};
}

}  // namespace offing::clouds
