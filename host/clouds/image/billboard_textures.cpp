#include "host/clouds/image/billboard_textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/base/error.h"
#include "host/base/parallel_rows.h"
#include "host/clouds/image/billboard_noise.h"

namespace offing::clouds {
namespace {

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
