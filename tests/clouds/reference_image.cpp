#include "tests/clouds/reference_image.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include <glm/geometric.hpp>

#include "host/base/camera.h"
#include "kernels/shared/cloud_image_params.h"

namespace offing::test {
namespace {

double smooth_step(double low, double high, double x) {
  const double share = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

struct TextureAxes {
  glm::dvec3 right, up;
};

/// The direction from which the texture is seen as it is, turned to the eye the shortest way.
TextureAxes axes_of(const CloudParticle& particle, const glm::dvec3& toward_eye) {
  const double own = 2.3999632 * (particle.id & 0xffffu);
  const glm::dvec3 from(std::cos(own), 0.0, std::sin(own));
  // Rodrigues' rotation about from x toward_eye.
  const glm::dvec3 axis = glm::cross(from, toward_eye);
  const double cosine = glm::dot(from, toward_eye);
  const auto turned = [&](const glm::dvec3& v) {
    return v * cosine + glm::cross(axis, v) + axis * glm::dot(axis, v) / (1.0 + cosine);
  };
  const glm::dvec3 side = turned({-from.z, 0.0, from.x}), high = turned({0.0, 1.0, 0.0});
  const double c = std::cos(particle.turn), s = std::sin(particle.turn);
  return {c * side + s * high, c * high - s * side};
}

using Texel = std::array<double, 4>;

Texel texel_at(const clouds::BillboardTextures& textures, unsigned texture, int level, double x, double y) {
  std::size_t first = std::size_t{texture} * CLOUD_TEXTURE_TEXELS;
  for (int l = 0; l < level; ++l) first += static_cast<std::size_t>(std::pow(CLOUD_TEXTURE_SIZE >> l, 2));
  const int size = CLOUD_TEXTURE_SIZE >> level;
  const double column = (0.5 + 0.5 * x) * size - 0.5, row = (0.5 + 0.5 * y) * size - 0.5;
  Texel sum{};
  for (const int up : {0, 1}) {
    for (const int right : {0, 1}) {
      const double left_share = column - std::floor(column), low_share = row - std::floor(row);
      const double share =
          (right == 1 ? left_share : 1.0 - left_share) * (up == 1 ? low_share : 1.0 - low_share);
      const int i = std::clamp(static_cast<int>(std::floor(column)) + right, 0, size - 1);
      const int j = std::clamp(static_cast<int>(std::floor(row)) + up, 0, size - 1);
      const std::uint32_t packed = textures.texels[first + static_cast<std::size_t>(j * size + i)];
      for (std::size_t c = 0; c < 4; ++c) sum[c] += share * (packed >> 8 * c & 255u) / 255.0;
    }
  }
  return sum;
}

struct Layer {
  double depth = 0.0;
  glm::dvec3 light{0.0};
};

}  // namespace

double chord_integral(double offset, double begin, double end) {
  if (end <= begin) return 0.0;
  const auto density = [&](double z) {
    const double q = offset * offset + z * z;
    return 1.0 - 22.0 / 9.0 * q + 17.0 / 9.0 * q * q - 4.0 / 9.0 * q * q * q;
  };
  constexpr int steps = 200;
  const double step = (end - begin) / steps;
  double sum = density(begin) + density(end);
  for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * density(begin + i * step);
  return sum * step / 3.0;
}

CloudSight reference_sight(std::span<const CloudParticle> particles, std::span<const CloudSprite> sprites,
                           const clouds::BillboardTextures& textures, const Camera& camera,
                           const glm::dvec3& sun_direction, const glm::dvec3& direction, double scene_m) {
  std::map<int, Layer> layers;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const CloudParticle& particle = particles[i];
    const glm::dvec3 way = glm::dvec3(particle.x, particle.y, particle.z) - camera.eye_m;
    const double radius = particle.radius, along = glm::dot(way, direction), distance_m = glm::length(way);
    const glm::dvec3 offset = (along * direction - way) / radius;
    const double square = glm::dot(offset, offset);
    if (square >= 1.0) continue;
    const double half_chord = std::sqrt(1.0 - square);
    const double begin = std::max(-half_chord, -along / radius);
    const double end = std::min(half_chord, (scene_m - along) / radius);
    double depth = sprites[i].optical_depth / CLOUD_CHORD * chord_integral(std::sqrt(square), begin, end);

    const double radius_px =
        0.5 * camera.height_px / half_extent(camera).y * radius / std::max(distance_m, radius);
    const double pattern = smooth_step(1.5, 4.0, radius_px) * smooth_step(0.5, 1.5, distance_m / radius);
    double light = 1.0;
    if (depth > 0.0 && pattern > 0.0) {
      const TextureAxes axes = axes_of(particle, -way / distance_m);
      const double x = glm::dot(offset, axes.right), y = glm::dot(offset, axes.up);
      const double level =
          std::clamp(std::log2(0.5 * CLOUD_TEXTURE_SIZE / radius_px), 0.0, CLOUD_TEXTURE_LEVELS - 1.0);
      const int finer = std::min(static_cast<int>(level), CLOUD_TEXTURE_LEVELS - 2);
      const double coarser = smooth_step(0.7, 1.0, level - finer);
      Texel texel = texel_at(textures, particle.texture, finer, x, y);
      const Texel next = texel_at(textures, particle.texture, finer + 1, x, y);
      for (std::size_t c = 0; c < 4; ++c) texel[c] = std::lerp(texel[c], next[c], coarser);
      const std::array<double, 4> knots{0.0, texel[2], texel[3], 1.0};
      const double mean = 1.0 - std::exp(-depth);
      const auto third = std::min<std::size_t>(2, static_cast<std::size_t>(3.0 * mean));
      const double opacity =
          std::lerp(knots[third], knots[third + 1], 3.0 * mean - static_cast<double>(third));
      depth = -std::log(std::max(1e-4, 1.0 - std::lerp(mean, opacity, pattern)));
      light += 0.45 * pattern *
               ((2.0 * texel[0] - 1.0) * glm::dot(sun_direction, axes.right) +
                (2.0 * texel[1] - 1.0) * glm::dot(sun_direction, axes.up));
    }
    const double place = std::log(1.0 + distance_m * CLOUD_LAYER_GROWTH / CLOUD_LAYER_M) / CLOUD_LAYER_GROWTH;
    const int layer = static_cast<int>(place);
    for (const int behind : {0, 1}) {
      const double share = behind == 1 ? place - layer : 1.0 - (place - layer);
      layers[layer + behind].depth += share * depth;
      layers[layer + behind].light +=
          share * depth * light * glm::dvec3(sprites[i].red, sprites[i].green, sprites[i].blue);
    }
  }
  CloudSight sight;
  double through = 1.0;
  for (const auto& [index, layer] : layers) {
    if (!(layer.depth > 0.0)) continue;
    const double opacity = through * (1.0 - std::exp(-layer.depth));
    for (glm::dvec3::length_type c = 0; c < 3; ++c) {
      sight.rgba[static_cast<std::size_t>(c)] += opacity * layer.light[c] / layer.depth;
    }
    sight.rgba[3] += opacity;
    sight.distance_m += opacity * double{CLOUD_LAYER_M} / CLOUD_LAYER_GROWTH *
                        (std::exp(CLOUD_LAYER_GROWTH * static_cast<double>(index)) - 1.0);
    through *= std::exp(-layer.depth);
  }
  if (sight.rgba[3] > 0.0) sight.distance_m /= sight.rgba[3];
  return sight;
}

}  // namespace offing::test
