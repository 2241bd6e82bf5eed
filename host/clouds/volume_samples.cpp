#include "host/clouds/volume_samples.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace offing::clouds {
namespace {

std::vector<VolumeSample> cells_of(const CloudVolume& volume) {
  constexpr int n = CloudVolume::brick_cells;
  const double cell_m3 = volume.cell_m * volume.cell_m * volume.cell_m;
  std::vector<VolumeSample> cells;
  std::size_t number = 0;
  for (int z = 0; z < volume.bricks[2]; ++z) {
    for (int y = 0; y < volume.bricks[1]; ++y) {
      for (int x = 0; x < volume.bricks[0]; ++x) {
        const std::int32_t brick = volume.brick_of[number++];
        if (brick == CloudVolume::no_brick) continue;
        const float* density =
            volume.density.data() + static_cast<std::size_t>(brick) * CloudVolume::cells_of_brick;
        for (int cell = 0; cell < n * n * n; ++cell) {
          if (density[cell] <= 0.0f) continue;
          const std::array<int, 3> place{x * n + cell % n, y * n + cell / n % n, z * n + cell / n / n};
          cells.push_back({place, (glm::dvec3(place[0], place[1], place[2]) + 0.5) * volume.cell_m,
                           static_cast<double>(density[cell]) * cell_m3,
                           0.25 * volume.cell_m * volume.cell_m});  // of a cube: edge^2 / 12 along each axis
        }
      }
    }
  }
  return cells;
}

auto order(const VolumeSample& sample) {
  return std::array{sample.block[2], sample.block[1], sample.block[0]};
}

/// Samples of the same block become one.
void join(std::vector<VolumeSample>& samples) {
  std::stable_sort(samples.begin(), samples.end(),
                   [](const VolumeSample& a, const VolumeSample& b) { return order(a) < order(b); });
  std::size_t kept = 0;
  for (std::size_t first = 0; first < samples.size(); ++kept) {
    VolumeSample sum = samples[first++];
    while (first < samples.size() && samples[first].block == sum.block) sum = merged(sum, samples[first++]);
    samples[kept] = sum;
  }
  samples.resize(kept);
}

}  // namespace

VolumeSample merged(const VolumeSample& a, const VolumeSample& b) {
  const double mass = a.mass + b.mass;
  const glm::dvec3 apart_m = a.place_m - b.place_m;
  const double share = b.mass / mass;
  return {
      a.block, a.place_m - share * apart_m, mass,
      (1.0 - share) * a.square_m2 + share * b.square_m2 + share * (1.0 - share) * glm::dot(apart_m, apart_m)};
}

VolumeSamples volume_samples(const CloudVolume& volume, std::size_t most) {
  VolumeSamples result{cells_of(volume), volume.cell_m};
  join(result.samples);
  for (int factor = 2; result.samples.size() > most; ++factor) {
    result = {cells_of(volume), factor * volume.cell_m};
    for (VolumeSample& sample : result.samples) {
      for (int& place : sample.block) place /= factor;
    }
    join(result.samples);
  }
  return result;
}

}  // namespace offing::clouds
