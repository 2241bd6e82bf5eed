#include "host/cli/pictures/preview_raster.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/base/parallel_rows.h"

namespace offing::cli {
namespace {

struct Strip {
  int begin = 0, end = 0;  ///< columns of samples
};

using Triangle = std::array<const ScreenVertex*, 3>;

float twice_area(const ScreenVertex& a, const ScreenVertex& b, float x, float y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

void draw(const Triangle& triangle, Strip strip, int width, int height, std::vector<RasterSample>& samples) {
  const auto& [a, b, c] = triangle;
  const float area = twice_area(*a, *b, c->x, c->y);
  if (area == 0.0f || a->nearness <= 0.0f || b->nearness <= 0.0f || c->nearness <= 0.0f) return;
  // Clamped as floats: a vertex close to the eye can lie beyond the range of int.
  const auto clamped = [](float value, int low, int high) {
    return static_cast<int>(std::clamp(value, static_cast<float>(low), static_cast<float>(high)));
  };
  const int left = clamped(std::floor(std::min({a->x, b->x, c->x})), strip.begin, strip.end);
  const int right = clamped(std::ceil(std::max({a->x, b->x, c->x})), strip.begin, strip.end);
  const int top = clamped(std::floor(std::min({a->y, b->y, c->y})), 0, height);
  const int bottom = clamped(std::ceil(std::max({a->y, b->y, c->y})), 0, height);
  for (int row = top; row < bottom; ++row) {
    const float y = static_cast<float>(row) + 0.5f;
    for (int column = left; column < right; ++column) {
      const float x = static_cast<float>(column) + 0.5f;
      const float share_a = twice_area(*b, *c, x, y) / area;
      const float share_b = twice_area(*c, *a, x, y) / area;
      const float share_c = 1.0f - share_a - share_b;
      if (share_a < 0.0f || share_b < 0.0f || share_c < 0.0f) continue;
      // What is linear in space is linear on the screen once multiplied by the nearness.
      const float near_a = share_a * a->nearness, near_b = share_b * b->nearness,
                  near_c = share_c * c->nearness;
      const float nearness = near_a + near_b + near_c;
      RasterSample& sample = samples[static_cast<std::size_t>(row) * width + column];
      if (nearness <= sample.nearness) continue;
      sample = {nearness, (near_a * a->label_x + near_b * b->label_x + near_c * c->label_x) / nearness,
                (near_a * a->label_z + near_b * b->label_z + near_c * c->label_z) / nearness};
    }
  }
}

}  // namespace

std::vector<RasterSample> rasterise(const std::vector<ScreenVertex>& vertices, int columns, int rows,
                                    int width, int height) {
  std::vector<RasterSample> samples(static_cast<std::size_t>(width) * height);
  constexpr int strips = 16;
  parallel_rows(strips, [&](int index) {
    const Strip strip{width * index / strips, width * (index + 1) / strips};
    const float begin = static_cast<float>(strip.begin), end = static_cast<float>(strip.end);
    for (int row = 0; row + 1 < rows; ++row) {
      const ScreenVertex* const above = &vertices[static_cast<std::size_t>(row) * columns];
      const ScreenVertex* const below = above + columns;
      for (int column = 0; column + 1 < columns; ++column) {
        const std::array<const ScreenVertex*, 4> corners{above + column, above + column + 1, below + column,
                                                         below + column + 1};
        const auto [low, high] = std::minmax({corners[0]->x, corners[1]->x, corners[2]->x, corners[3]->x});
        if (high < begin || low > end) continue;
        draw({corners[0], corners[2], corners[1]}, strip, width, height, samples);
        draw({corners[1], corners[2], corners[3]}, strip, width, height, samples);
      }
    }
  });
  return samples;
}

}  // namespace offing::cli
