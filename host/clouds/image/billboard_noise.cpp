#include "host/clouds/image/billboard_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "kernels/shared/random.h"

namespace offing::clouds {
namespace {

// Of the noise of textures: they are the same for all scenes.
constexpr std::uint32_t seed = 9;

/// Random numbers in (0, 1), two at each point of a lattice that covers the texture with a point to spare on
/// each side.
class Lattice {
 public:
  /// `cells` along an edge of the texture; `octave` is another for each lattice of the texture.
  Lattice(int cells, int octave, int texture) : side_(cells + 3) {
    for (int m = 0; m < side_; ++m) {
      for (int n = 0; n < side_; ++n) {
        const PhiloxBlock block = philox_block(seed, 0, OFFING_STREAM_CLOUD_BILLBOARDS, n, m,
                                               static_cast<std::uint32_t>(64 * texture + octave));
        values_.emplace_back(uniform_open01(block.v[0]), uniform_open01(block.v[1]));
      }
    }
  }

  /// -1 ... cells + 1 along both.
  const glm::vec2& at(int n, int m) const {
    return values_[static_cast<std::size_t>((m + 1) * side_ + n + 1)];
  }
  int last() const { return side_ - 2; }
  template <class Change>
  void for_each(const Change& change) {
    std::for_each(values_.begin(), values_.end(), change);
  }

 private:
  int side_;
  std::vector<glm::vec2> values_;
};

/// Gradient noise (Perlin 2002): continuous with its slopes, 0 in the mean, about -0.7 ... 0.7.
class GradientNoise {
 public:
  GradientNoise(int cells, int octave, int texture) : cells_(cells), slopes_(cells, octave, texture) {
    slopes_.for_each([](glm::vec2& random) {
      const float turn = 2.0f * std::numbers::pi_v<float> * random.x;
      random = {std::cos(turn), std::sin(turn)};
    });
  }

  /// At a place of the texture, 0 ... 1 along both; beyond its lattice it stays as it is at the edge.
  float at(glm::vec2 place) const {
    const glm::vec2 point = glm::clamp(place * static_cast<float>(cells_), glm::vec2(-0.999f),
                                       glm::vec2(static_cast<float>(slopes_.last()) - 0.001f));
    const glm::vec2 corner = glm::floor(point), in = point - corner;
    const glm::vec2 share = in * in * in * (in * (in * 6.0f - 15.0f) + 10.0f);
    const auto slope = [&](int n, int m) {
      return glm::dot(slopes_.at(static_cast<int>(corner.x) + n, static_cast<int>(corner.y) + m),
                      in - glm::vec2(n, m));
    };
    return std::lerp(std::lerp(slope(0, 0), slope(1, 0), share.x),
                     std::lerp(slope(0, 1), slope(1, 1), share.x), share.y);
  }

 private:
  int cells_;
  Lattice slopes_;
};

/// Domes around points, one in each cell (Worley 1996): 1 at a point, 0 where the nearest is a cell away.
class Domes {
 public:
  Domes(int cells, int octave, int texture) : cells_(cells), lattice_(cells, octave, texture) {}

  float at(glm::vec2 place) const {
    const glm::vec2 point = place * static_cast<float>(cells_);
    const int n = static_cast<int>(std::floor(point.x)), m = static_cast<int>(std::floor(point.y));
    float nearest = std::numeric_limits<float>::infinity();
    for (int j = std::max(m - 1, -1); j <= std::min(m + 1, lattice_.last()); ++j) {
      for (int i = std::max(n - 1, -1); i <= std::min(n + 1, lattice_.last()); ++i) {
        const glm::vec2 way = glm::vec2(i, j) + lattice_.at(i, j) - point;
        nearest = std::min(nearest, glm::dot(way, way));
      }
    }
    return std::max(0.0f, 1.0f - nearest);
  }

 private:
  int cells_;
  Lattice lattice_;
};

/// Calls height(place) for the middle of each texel.
template <class Height>
BillboardHeights filled(const Height& height) {
  BillboardHeights heights;
  heights.reserve(std::size_t{CLOUD_TEXTURE_SIZE} * CLOUD_TEXTURE_SIZE);
  for (int row = 0; row < CLOUD_TEXTURE_SIZE; ++row) {
    for (int column = 0; column < CLOUD_TEXTURE_SIZE; ++column) {
      heights.push_back(height((glm::vec2(column, row) + 0.5f) / static_cast<float>(CLOUD_TEXTURE_SIZE)));
    }
  }
  return heights;
}

/// Octaves summed at places that other noise bends.
struct BentSum {
  float bend;    ///< how far, of the texture's edge
  float height;  ///< to begin with
  float share;   ///< of the first octave
  float gain;    ///< share of an octave over that before
};

template <class Octave>
BillboardHeights bent_sum(const BentSum& sum, const std::array<GradientNoise, 2>& bends,
                          const std::vector<Octave>& octaves) {
  return filled([&](glm::vec2 place) {
    const glm::vec2 bent = place + sum.bend * glm::vec2(bends[0].at(place), bends[1].at(place));
    float height = sum.height, share = sum.share;
    for (const Octave& octave : octaves) {
      height += share * octave.at(bent);
      share *= sum.gain;
    }
    return height;
  });
}

}  // namespace

BillboardHeights lumpy_heights(int texture) {
  // Each octave's lumps are near half as wide and high as those that carry them, and none is quite round.
  const std::vector<Domes> domes{{4, 0, texture}, {9, 1, texture}, {19, 2, texture}, {41, 3, texture}};
  return bent_sum({.bend = 0.05f, .height = 0.0f, .share = 0.54f, .gain = 0.48f},
                  {GradientNoise(6, 4, texture), GradientNoise(6, 5, texture)}, domes);
}

BillboardHeights wispy_heights(int texture) {
  std::vector<GradientNoise> octaves;
  for (int octave = 0; octave < 5; ++octave) octaves.emplace_back(3 << octave, 10 + octave, texture);
  return bent_sum({.bend = 0.22f, .height = 0.5f, .share = 0.62f, .gain = 0.5f},
                  {GradientNoise(3, 8, texture), GradientNoise(3, 9, texture)}, octaves);
}

}  // namespace offing::clouds
