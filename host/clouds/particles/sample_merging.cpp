#include "host/clouds/particles/sample_merging.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>

#include <glm/geometric.hpp>

#include "kernels/shared/random.h"

namespace offing::clouds {
namespace {

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
    constexpr std::size_t merges_a_tell = 1024;
    while (left > most && !pairs_.empty()) {
      work_.poll();
      if (left % merges_a_tell == 0) work_.tell(static_cast<double>(clusters_.size() - left) / all);
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

std::vector<VolumeSample> merged_samples(const VolumeBlocks& samples, std::size_t most, std::uint64_t seed,
                                         const Work& work) {
  Merging merging(samples, seed, work);
  merging.reduce_to(most);
  return merging.rest();
}

}  // namespace offing::clouds
