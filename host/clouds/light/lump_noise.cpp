#include "host/clouds/light/lump_noise.h"

#include <cmath>
#include <cstddef>

#include "kernels/shared/cloud_march.h"
#include "kernels/shared/random.h"

namespace offing::clouds {
namespace {

constexpr int edge_texels = CLOUD_LUMP_TEXELS;
// LumpLattice points along an edge of the first octave, and how much weaker each is than the one before.
constexpr int first_points = 4, octaves = 3;
constexpr double gain = 0.6;

double lump_fade(double t) {
  return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

/// Random values at the points of a lattice, -1 ... 1, faded into each other.
class LumpLattice {
 public:
  explicit LumpLattice(int octave) : points_(first_points << octave) {
    for (int i = 0; i < points_ * points_ * points_; ++i) {
      const PhiloxBlock drawn =
          philox_4x32_10({{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(octave), 0u,
                           OFFING_STREAM_CLOUD_LUMPS}},
                         0u, 0u);
      values_.push_back(2.0 * drawn.v[0] / 4294967295.0 - 1.0);
    }
  }

  double at(int x, int y, int z) const {
    const int corner[3] = {x, y, z};
    int low[3];
    double share[3];
    for (int axis = 0; axis < 3; ++axis) {
      const double place = (corner[axis] + 0.5) * points_ / edge_texels;
      low[axis] = static_cast<int>(place);
      share[axis] = lump_fade(place - low[axis]);
    }
    double sum = 0.0;
    for (int i = 0; i < 8; ++i) {
      double weight = 1.0;
      int point[3];
      for (int axis = 0; axis < 3; ++axis) {
        const int up = (i >> axis) & 1;
        weight *= up == 1 ? share[axis] : 1.0 - share[axis];
        point[axis] = (low[axis] + up) % points_;
      }
      sum += weight * values_[static_cast<std::size_t>((point[2] * points_ + point[1]) * points_ + point[0])];
    }
    return sum;
  }

 private:
  int points_;
  std::vector<double> values_;
};

}  // namespace

std::vector<float> lump_noise() {
  std::vector<double> sums(static_cast<std::size_t>(edge_texels) * edge_texels * edge_texels, 0.0);
  double strength = 1.0;
  for (int octave = 0; octave < octaves; ++octave, strength *= gain) {
    const LumpLattice lattice(octave);
    std::size_t i = 0;
    for (int z = 0; z < edge_texels; ++z)
      for (int y = 0; y < edge_texels; ++y)
        for (int x = 0; x < edge_texels; ++x) sums[i++] += strength * std::abs(lattice.at(x, y, z));
  }
  double mean = 0.0, square = 0.0;
  for (const double sum : sums) mean += sum / static_cast<double>(sums.size());
  for (const double sum : sums) square += (sum - mean) * (sum - mean) / static_cast<double>(sums.size());
  std::vector<float> noise;
  for (const double sum : sums) noise.push_back(static_cast<float>((sum - mean) / std::sqrt(square)));
  return noise;
}

}  // namespace offing::clouds
