#include "host/clouds/particles/sample_merging.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

#include "kernels/shared/random.h"

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

// Weight of closeness beside that of alike densities: parts of even density are merged until they are ten
// times as far apart as such whose density falls from the largest to nothing.
constexpr double even_weight = 0.01;
// Costs of alike pairs differ by up to this factor.
constexpr double most_unwilling = 4.0;

struct Cluster {
  VolumeSample sum;
  double volume = 0.0;                    // blocks
  double unwilling = 1.0;                 // factor of its costs
  std::vector<std::uint32_t> neighbours;  // ascending; some may have been merged meanwhile
  std::uint32_t into = 0;                 // what it was merged into, itself while it is there
};

struct Pair {
  double cost;
  std::uint32_t a, b;
  double volume_a, volume_b;  // when the cost was found: another volume now means another cost

  // The cheapest first; of equals those that come first in space, so that the order is always the same.
  bool operator<(const Pair& other) const {
    if (cost != other.cost) return cost > other.cost;
    return a != other.a ? a > other.a : b > other.b;
  }
};

class Merging {
 public:
  Merging(const VolumeBlocks& samples, std::uint64_t seed, const Work& work) : work_(work) {
    clusters_.reserve(samples.samples.size());
    std::array<int, 3> lowest{};
    if (!samples.samples.empty()) lowest = samples.samples.front().block;
    for (const VolumeSample& sample : samples.samples) {
      for (std::size_t axis = 0; axis < 3; ++axis) lowest[axis] = std::min(lowest[axis], sample.block[axis]);
    }
    for (const VolumeSample& sample : samples.samples) {
      work_.poll();
      const auto number = static_cast<std::uint32_t>(clusters_.size());
      clusters_.push_back({sample, 1.0, unwillingness(sample.block, lowest, seed), {}, number});
      largest_mass_ = std::max(largest_mass_, sample.mass);
    }
    find_neighbours();
    for (std::uint32_t a = 0; a < clusters_.size(); ++a) {
      work_.poll();
      for (const std::uint32_t b : clusters_[a].neighbours) {
        if (b > a) push(a, b);
      }
    }
  }

  void reduce_to(std::size_t most) {
    std::size_t left = clusters_.size();
    const double all = static_cast<double>(left) - static_cast<double>(most);
    constexpr std::size_t merges_a_report = 1024;
    while (left > most && !pairs_.empty()) {
      work_.poll();
      if (left % merges_a_report == 0) work_.tell(static_cast<double>(clusters_.size() - left) / all);
      const Pair pair = pairs_.top();
      pairs_.pop();
      if (clusters_[pair.a].into != pair.a || clusters_[pair.b].into != pair.b) continue;
      if (clusters_[pair.a].volume != pair.volume_a || clusters_[pair.b].volume != pair.volume_b) continue;
      merge(pair.a, pair.b);
      --left;
    }
  }

  std::vector<VolumeSample> rest() const {
    std::vector<VolumeSample> rest;
    for (std::uint32_t i = 0; i < clusters_.size(); ++i) {
      if (clusters_[i].into == i) rest.push_back(clusters_[i].sum);
    }
    return rest;
  }

 private:
  static double unwillingness(const std::array<int, 3>& block, const std::array<int, 3>& lowest,
                              std::uint64_t seed) {
    const PhiloxBlock drawn = philox_block(
        static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), OFFING_STREAM_CLOUD_MERGING,
        block[0] - lowest[0], block[1] - lowest[1], static_cast<std::uint32_t>(block[2] - lowest[2]));
    return std::pow(most_unwilling, 0.5 * static_cast<double>(uniform_open01(drawn.v[0])));
  }

  void find_neighbours() {
    const auto order = [](const std::array<int, 3>& block) {
      return std::array{block[2], block[1], block[0]};
    };
    for (std::uint32_t number = 0; number < clusters_.size(); ++number) {
      work_.poll();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<int, 3> next = clusters_[number].sum.block;
        ++next[axis];
        const auto found = std::lower_bound(clusters_.begin(), clusters_.end(), order(next),
                                            [&](const Cluster& cluster, const std::array<int, 3>& key) {
                                              return order(cluster.sum.block) < key;
                                            });
        if (found == clusters_.end() || found->sum.block != next) continue;
        clusters_[number].neighbours.push_back(static_cast<std::uint32_t>(found - clusters_.begin()));
        found->neighbours.push_back(number);
      }
    }
    for (Cluster& cluster : clusters_) std::sort(cluster.neighbours.begin(), cluster.neighbours.end());
  }

  void push(std::uint32_t a, std::uint32_t b) {
    const Cluster &first = clusters_[a], &second = clusters_[b];
    const glm::dvec3 apart_m = first.sum.place_m - second.sum.place_m;
    const double change = (first.sum.mass / first.volume - second.sum.mass / second.volume) / largest_mass_;
    const double both = first.volume * second.volume / (first.volume + second.volume);
    const double unwilling = first.unwilling * second.unwilling;
    pairs_.push({unwilling * both * glm::dot(apart_m, apart_m) * (even_weight + change * change),
                 std::min(a, b), std::max(a, b), clusters_[std::min(a, b)].volume,
                 clusters_[std::max(a, b)].volume});
  }

  void merge(std::uint32_t a, std::uint32_t b) {
    Cluster &kept = clusters_[a], &gone = clusters_[b];
    kept.sum = merged(kept.sum, gone.sum);
    kept.volume += gone.volume;
    gone.into = a;
    std::vector<std::uint32_t> neighbours;
    for (const std::vector<std::uint32_t>* list : {&kept.neighbours, &gone.neighbours}) {
      for (std::uint32_t neighbour : *list) {
        while (clusters_[neighbour].into != neighbour) neighbour = clusters_[neighbour].into;
        if (neighbour != a) neighbours.push_back(neighbour);
      }
    }
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    kept.neighbours = std::move(neighbours);
    gone.neighbours = {};
    for (const std::uint32_t neighbour : kept.neighbours) {
      clusters_[neighbour].neighbours.push_back(a);
      push(a, neighbour);
    }
  }

  const Work& work_;
  std::vector<Cluster> clusters_;
  std::priority_queue<Pair> pairs_;
  double largest_mass_ = 0.0;
};

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

std::vector<VolumeSample> merged_samples(const VolumeBlocks& samples, std::size_t most, std::uint64_t seed,
                                         const Work& work) {
  Merging merging(samples, seed, work);
  merging.reduce_to(most);
  return merging.rest();
}

}  // namespace offing::clouds
