#include "present/passes/water/foam_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

namespace offing::present {
namespace {

constexpr int size = 512;

struct Point {
  float x, y;
};

/// Two numbers 0 ... 1, the same for the same cell and seed everywhere (finaliser of MurmurHash3, Appleby
/// 2011).
Point cell_point(int column, int row, std::uint32_t seed) {
  std::uint32_t h = static_cast<std::uint32_t>(column) * 0x9E3779B1u ^
                    static_cast<std::uint32_t>(row) * 0x85EBCA77u ^ seed * 0xC2B2AE3Du;
  h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
  h = (h ^ (h >> 13)) * 0xC2B2AE35u;
  h ^= h >> 16;
  return {static_cast<float>(h & 0xffffu) / 65536.0f, static_cast<float>(h >> 16) / 65536.0f};
}

/// `count` x `count` scattered points, one in each cell of a tile that repeats (Worley 1996).
class ScatteredPoints {
 public:
  ScatteredPoints(int count, std::uint32_t seed) : count_(count) {
    // With the cells around, from -1 to `count`.
    const auto wrapped = [count](int i) { return (i + count) % count; };
    for (int row = -1; row <= count; ++row) {
      for (int column = -1; column <= count; ++column) {
        const Point point = cell_point(wrapped(column), wrapped(row), seed);
        points_.push_back({static_cast<float>(column) + point.x, static_cast<float>(row) + point.y});
      }
    }
  }

  /// How close a place (0 ... 1, repeating) is to the border between the cells of the points: 0 on it,
  /// growing inward, in units of a cell.
  float border_distance(Point place) const {
    const float x = place.x * static_cast<float>(count_), y = place.y * static_cast<float>(count_);
    const int cell_x = std::clamp(static_cast<int>(x), 0, count_ - 1),
              cell_y = std::clamp(static_cast<int>(y), 0, count_ - 1);
    float nearest = 1e9f, second = 1e9f;  // squares of distances
    for (int row = 0; row < 3; ++row) {
      const Point* const points = &points_[static_cast<std::size_t>((cell_y + row) * (count_ + 2) + cell_x)];
      for (int column = 0; column < 3; ++column) {
        const float away_x = points[column].x - x, away_y = points[column].y - y;
        const float square = away_x * away_x + away_y * away_y;
        second = std::min(second, std::max(nearest, square));
        nearest = std::min(nearest, square);
      }
    }
    return std::sqrt(second) - std::sqrt(nearest);
  }

 private:
  int count_;
  std::vector<Point> points_;
};

/// Threads between cells of a metre and less, bent and torn by coarser ones.
class FoamHeights {
 public:
  float at(Point place) const {
    const float bend = coarse_.border_distance(place) - 0.4f;
    const auto moved = [&](float by) {
      const auto wrapped = [](float v) { return v - std::floor(v); };
      return Point{wrapped(place.x + by * bend), wrapped(place.y - 0.7f * by * bend)};
    };
    return -0.9f * wide_.border_distance(moved(0.05f)) - 0.7f * middle_.border_distance(moved(0.03f)) -
           0.5f * small_.border_distance(moved(0.02f)) - 0.35f * fine_.border_distance(place);
  }

 private:
  ScatteredPoints coarse_{5, 1}, wide_{7, 2}, middle_{15, 3}, small_{37, 4}, fine_{83, 5};
};

/// The x that a standard normal variable exceeds with this probability: Newton's method from a guess.
double normal_quantile(double above, double guess) {
  double x = guess;
  for (int i = 0; i < 20; ++i) {
    const double density = std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi);
    const double step = (0.5 * std::erfc(x / std::numbers::sqrt2) - above) / density;
    x += std::clamp(step, -1.0, 1.0);
    if (std::abs(step) < 1e-6) break;  // the next one would be of its square
  }
  return x;
}

struct Texel {
  std::uint16_t value, square;
};

// Values by their rank, as a normal distribution has them, and their squares, both as foam_texture() packs
// them.
std::vector<Texel> normal_texels(const std::vector<float>& heights) {
  std::vector<std::uint32_t> order(heights.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return heights[a] != heights[b] ? heights[a] < heights[b] : a < b;
  });
  const auto packed = [](double value, double low, double high) {
    return static_cast<std::uint16_t>(
        std::lround(65535.0 * std::clamp((value - low) / (high - low), 0.0, 1.0)));
  };
  const auto count = static_cast<double>(order.size());
  std::vector<Texel> texels(heights.size());
  double quantile = -5.0;  // each close to the one before
  for (std::size_t i = 0; i < order.size(); ++i) {
    quantile = normal_quantile(1.0 - (static_cast<double>(i) + 0.5) / count, quantile);
    const double value = std::clamp(quantile, -foam_value_limit, foam_value_limit);
    texels[order[i]] = {packed(value, -foam_value_limit, foam_value_limit),
                        packed(value * value, 0.0, foam_value_limit * foam_value_limit)};
  }
  return texels;
}

}  // namespace

GlTexture foam_texture() {
  const FoamHeights foam;
  std::vector<float> heights;
  heights.reserve(static_cast<std::size_t>(size) * size);
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      heights.push_back(
          foam.at({(static_cast<float>(column) + 0.5f) / size, (static_cast<float>(row) + 0.5f) / size}));
    }
  }
  const std::vector<Texel> texels = normal_texels(heights);
  GlTexture texture = GlTexture::make();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RG16, size, size, 0, GL_RG, GL_UNSIGNED_SHORT, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glGenerateMipmap(GL_TEXTURE_2D);
  return texture;
}

}  // namespace offing::present
