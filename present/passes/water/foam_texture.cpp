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

/// How close a place (0 ... 1, repeating) is to the border between the cells of `count` x `count` scattered
/// points (Worley 1996): 0 on it, growing inward, in units of a cell.
float border_distance(Point place, int count, std::uint32_t seed) {
  const float x = place.x * static_cast<float>(count), y = place.y * static_cast<float>(count);
  const int cell_x = static_cast<int>(std::floor(x)), cell_y = static_cast<int>(std::floor(y));
  float nearest = 1e9f, second = 1e9f;  // squares of distances
  for (int row = cell_y - 1; row <= cell_y + 1; ++row) {
    for (int column = cell_x - 1; column <= cell_x + 1; ++column) {
      const auto wrapped = [count](int i) { return (i % count + count) % count; };
      const Point point = cell_point(wrapped(column), wrapped(row), seed);
      const float away_x = static_cast<float>(column) + point.x - x,
                  away_y = static_cast<float>(row) + point.y - y;
      const float square = away_x * away_x + away_y * away_y;
      second = std::min(second, std::max(nearest, square));
      nearest = std::min(nearest, square);
    }
  }
  return std::sqrt(second) - std::sqrt(nearest);
}

// Threads between cells of a metre and less, bent and torn by coarser ones.
float foam_height(Point place) {
  const float bend = border_distance(place, 5, 1) - 0.4f;
  const auto moved = [&](float by) {
    const auto wrapped = [](float v) { return v - std::floor(v); };
    return Point{wrapped(place.x + by * bend), wrapped(place.y - 0.7f * by * bend)};
  };
  return -0.9f * border_distance(moved(0.05f), 7, 2) - 0.7f * border_distance(moved(0.03f), 15, 3) -
         0.5f * border_distance(moved(0.02f), 37, 4) - 0.35f * border_distance(place, 83, 5);
}

// The x that a standard normal variable exceeds with this probability: bisection of its distribution.
double normal_quantile(double above) {
  double low = -8.0, high = 8.0;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(middle / std::numbers::sqrt2) > above ? low : high) = middle;
  }
  return 0.5 * (low + high);
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
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double value = std::clamp(normal_quantile(1.0 - (static_cast<double>(i) + 0.5) / count),
                                    -foam_value_limit, foam_value_limit);
    texels[order[i]] = {packed(value, -foam_value_limit, foam_value_limit),
                        packed(value * value, 0.0, foam_value_limit * foam_value_limit)};
  }
  return texels;
}

}  // namespace

GlTexture foam_texture() {
  std::vector<float> heights;
  heights.reserve(static_cast<std::size_t>(size) * size);
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      heights.push_back(
          foam_height({(static_cast<float>(column) + 0.5f) / size, (static_cast<float>(row) + 0.5f) / size}));
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
