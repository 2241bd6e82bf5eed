#include "host/clouds/image/billboard_textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/base/error.h"
#include "host/base/parallel_for.h"
#include "kernels/shared/random.h"

namespace offing::clouds {
namespace {

/// Heights of the surface of a billboard over its billboard, from noise:
/// [CLOUD_TEXTURE_SIZE][CLOUD_TEXTURE_SIZE] row-major, of no unit, about 0 ... 1.
using BillboardHeights = std::vector<float>;

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

/// Round lumps that carry smaller ones, with creases between: a cauliflower. `texture` says which one.
BillboardHeights lumpy_heights(int texture) {
  // Each octave's lumps are near half as wide and high as those that carry them, and none is quite round.
  const std::vector<Domes> domes{{4, 0, texture}, {9, 1, texture}, {19, 2, texture}, {41, 3, texture}};
  return bent_sum({.bend = 0.05f, .height = 0.0f, .share = 0.54f, .gain = 0.48f},
                  {GradientNoise(6, 4, texture), GradientNoise(6, 5, texture)}, domes);
}

/// Wisps that the wind has drawn out.
BillboardHeights wispy_heights(int texture) {
  std::vector<GradientNoise> octaves;
  for (int octave = 0; octave < 5; ++octave) octaves.emplace_back(3 << octave, 10 + octave, texture);
  return bent_sum({.bend = 0.22f, .height = 0.5f, .share = 0.62f, .gain = 0.5f},
                  {GradientNoise(3, 8, texture), GradientNoise(3, 9, texture)}, octaves);
}

constexpr int size = CLOUD_TEXTURE_SIZE;
constexpr std::size_t texel_count = std::size_t{size} * size;
// Opacities in the mean, of which patterns are kept.
constexpr std::array pattern_means{1.0f / 3.0f, 2.0f / 3.0f};
// Rings of texels that are equally far from the middle. The inmost is wider than lumps are, so that they do
// not end there.
constexpr int ring_count = 48;
constexpr float inmost_ring = 0.2f;

/// How the heights of a billboard become opacities and slopes.
struct BillboardStyle {
  float softness;  ///< over which heights an edge of a pattern goes from clear to opaque, in their deviation
  float relief;    ///< height of the lumps, in radii of the billboard
};
constexpr BillboardStyle crisp{.softness = 1.3f, .relief = 0.30f};
constexpr BillboardStyle soft{.softness = 5.0f, .relief = 0.10f};

/// Relief and patterns of a texel or the mean of several.
using Texel = std::array<float, 4>;

/// Distance of a texel's middle from that of the texture, 1 where the ball's rim touches an edge.
glm::vec2 place_of(std::size_t texel) {
  const glm::vec2 middle(static_cast<float>(texel % size) + 0.5f, static_cast<float>(texel / size) + 0.5f);
  return middle * (2.0f / size) - 1.0f;
}

int ring_of(float radius) {
  if (radius < inmost_ring) return 0;
  return std::min(ring_count - 1,
                  static_cast<int>((radius - inmost_ring) / (1.0f - inmost_ring) * (ring_count - 1)) + 1);
}

/// Opacities of heights of one ring, of this mean: edges lie where they must for it.
class RingPattern {
 public:
  RingPattern(const std::vector<float>& heights, float softness, float mean) : softness_(softness) {
    if (heights.empty()) return;
    const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
    // The mean falls as the edge rises. 14 halvings leave less of a few deviations than a byte shows.
    float low = *least - softness, high = *most + softness;
    for (int i = 0; i < 14; ++i) {
      edge_ = 0.5f * (low + high);
      double sum = 0.0;
      for (const float height : heights) sum += at(height);
      (sum > mean * static_cast<double>(heights.size()) ? low : high) = edge_;
    }
  }

  float at(float height) const {
    const float x = std::clamp((height - edge_) / softness_ + 0.5f, 0.0f, 1.0f);
    return x * x * (3.0f - 2.0f * x);
  }

 private:
  float softness_;
  float edge_ = 0.0f;
};

float deviation(const BillboardHeights& heights) {
  double sum = 0.0, squares = 0.0;
  for (const float height : heights) {
    sum += height;
    squares += static_cast<double>(height) * height;
  }
  const double mean = sum / static_cast<double>(heights.size());
  // Of a picture that is the same everywhere any softness serves.
  return static_cast<float>(
      std::max(1e-3, std::sqrt(squares / static_cast<double>(heights.size()) - mean * mean)));
}

/// How far the surface of the ball with these lumps turns to the right and upward: the components of its
/// normal.
glm::vec2 turn_at(const BillboardHeights& heights, std::size_t texel, float relief) {
  const int column = static_cast<int>(texel % size), row = static_cast<int>(texel / size);
  const auto height = [&](int right, int up) {
    const int x = std::clamp(column + right, 0, size - 1), y = std::clamp(row + up, 0, size - 1);
    return heights[static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x)];
  };
  const float per_radius = relief * size / 4.0f;  // two texels, of which size / 2 are a radius
  const glm::vec2 lumps(per_radius * (height(1, 0) - height(-1, 0)),
                        per_radius * (height(0, 1) - height(0, -1)));
  const glm::vec2 place = place_of(texel);
  const glm::vec3 normal(place - lumps, std::sqrt(std::max(0.05f, 1.0f - glm::dot(place, place))));
  return glm::vec2(normal) / glm::length(normal);
}

/// Takes away what the turns of a ring have in the mean, so that relief makes no billboard brighter.
void balance(std::vector<Texel>& texels, const std::vector<std::vector<std::size_t>>& rings) {
  for (const std::vector<std::size_t>& ring : rings) {
    Texel sum{};
    for (const std::size_t texel : ring) {
      for (std::size_t c = 0; c < 2; ++c) sum[c] += texels[texel][c];
    }
    for (const std::size_t texel : ring) {
      for (std::size_t c = 0; c < 2; ++c) texels[texel][c] -= sum[c] / static_cast<float>(ring.size());
    }
  }
}

/// The largest level.
std::vector<Texel> texels_of(const BillboardHeights& heights, const BillboardStyle& style) {
  std::vector<std::vector<std::size_t>> rings(ring_count);
  // Beyond the rim there is no billboard.
  std::vector<Texel> texels(texel_count, {0.0f, 0.0f, pattern_means[0], pattern_means[1]});
  for (std::size_t i = 0; i < texel_count; ++i) {
    const float radius = glm::length(place_of(i));
    if (radius >= 1.0f) continue;
    rings[static_cast<std::size_t>(ring_of(radius))].push_back(i);
    const glm::vec2 turn = turn_at(heights, i, style.relief);
    texels[i][0] = turn.x;
    texels[i][1] = turn.y;
  }
  const float softness = style.softness * deviation(heights);
  for (const std::vector<std::size_t>& ring : rings) {
    std::vector<float> of_ring;
    of_ring.reserve(ring.size());
    for (const std::size_t texel : ring) of_ring.push_back(heights[texel]);
    for (std::size_t p = 0; p < pattern_means.size(); ++p) {
      const RingPattern pattern(of_ring, softness, pattern_means[p]);
      for (const std::size_t texel : ring) texels[texel][2 + p] = pattern.at(heights[texel]);
    }
  }
  balance(texels, rings);
  return texels;
}

std::vector<Texel> half_as_large(const std::vector<Texel>& finer, int finer_size) {
  const auto side = static_cast<std::size_t>(finer_size / 2);
  std::vector<Texel> coarser(side * side);
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const std::size_t corner = 4 * row * side + 2 * column;
      for (std::size_t c = 0; c < 4; ++c) {
        coarser[row * side + column][c] =
            0.25f * (finer[corner][c] + finer[corner + 1][c] + finer[corner + 2 * side][c] +
                     finer[corner + 2 * side + 1][c]);
      }
    }
  }
  return coarser;
}

std::uint32_t packed(const Texel& texel) {
  const auto byte = [](float value) {
    return static_cast<std::uint32_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
  };
  return byte(0.5f + 0.5f * texel[0]) | byte(0.5f + 0.5f * texel[1]) << 8 | byte(texel[2]) << 16 |
         byte(texel[3]) << 24;
}

void fill_billboard(BillboardTextures& textures, int texture, const BillboardHeights& heights,
                    const BillboardStyle& style) {
  std::uint32_t* target = textures.texels.data() + static_cast<std::size_t>(texture) * CLOUD_TEXTURE_TEXELS;
  std::vector<Texel> texels = texels_of(heights, style);
  for (int level = 0; level < CLOUD_TEXTURE_LEVELS; ++level) {
    if (level > 0) texels = half_as_large(texels, 2 * size >> level);
    target = std::transform(texels.begin(), texels.end(), target, packed);
  }
}

/// Brightness times opacity of a picture of any size; its first row is the top one.
BillboardHeights image_heights(const RgbaImage& picture) {
  BillboardHeights heights;
  heights.reserve(texel_count);
  const auto value = [&](int column, int row) {
    const int x = std::clamp(column, 0, picture.width - 1), y = std::clamp(row, 0, picture.height - 1);
    const std::uint8_t* rgba =
        picture.rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                   static_cast<std::size_t>(x));
    return static_cast<float>((rgba[0] + rgba[1] + rgba[2]) * rgba[3]) / (3.0f * 255.0f * 255.0f);
  };
  for (std::size_t i = 0; i < texel_count; ++i) {
    const glm::vec2 place = 0.5f + 0.5f * place_of(i) * glm::vec2(1.0f, -1.0f);
    const glm::vec2 pixel = place * glm::vec2(picture.width, picture.height) - 0.5f;
    const glm::vec2 corner = glm::floor(pixel), in = pixel - corner;
    const int column = static_cast<int>(corner.x), row = static_cast<int>(corner.y);
    heights.push_back(std::lerp(std::lerp(value(column, row), value(column + 1, row), in.x),
                                std::lerp(value(column, row + 1), value(column + 1, row + 1), in.x), in.y));
  }
  return heights;
}

}  // namespace

BillboardTextures billboard_textures() {
  BillboardTextures textures{
      .texels = std::vector<std::uint32_t>(std::size_t{2 * CLOUD_TEXTURES} * CLOUD_TEXTURE_TEXELS)};
  parallel_rows(2 * CLOUD_TEXTURES, [&](int texture) {
    if (texture < CLOUD_TEXTURES) {
      fill_billboard(textures, texture, lumpy_heights(texture), crisp);
    } else {
      fill_billboard(textures, texture, wispy_heights(texture), soft);
    }
  });
  return textures;
}

void replace_billboards(BillboardTextures& textures, int set, std::span<const RgbaImage> pictures) {
  if (pictures.size() != CLOUD_TEXTURES) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("billboard textures: expected {} pictures, found {}", CLOUD_TEXTURES, pictures.size()),
        "give one picture for each texture of the set");
  }
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const RgbaImage& picture = pictures[i];
    const bool has_texels = picture.width > 0 && picture.height > 0;
    if (has_texels && picture.rgba.size() == 4 * static_cast<std::size_t>(picture.width) *
                                                 static_cast<std::size_t>(picture.height))
      continue;
    throw Error(
        ErrorKind::bad_input,
        fmt::format("billboard texture {}: expected width x height x 4 bytes, found {} x {} and {} bytes", i,
                    picture.width, picture.height, picture.rgba.size()),
        "make the picture again");
  }
  parallel_rows(CLOUD_TEXTURES, [&](int i) {
    fill_billboard(textures, set * CLOUD_TEXTURES + i, image_heights(pictures[static_cast<std::size_t>(i)]),
                   set == 0 ? crisp : soft);
  });
}

}  // namespace offing::clouds
