#include "tests/clouds/example_clouds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "kernels/shared/random.h"

namespace offing::clouds::test {
namespace {

constexpr double ball_mass = 0.815595;  // of h over a ball of radius 1 (C1)

// C1.
double h(double r2) {
  return r2 < 1.0 ? 1.0 + r2 * (-22.0 + r2 * (17.0 - 4.0 * r2)) / 9.0 : 0.0;
}

// Integral of h along a line at the distance whose square is b2, by Gauss-Legendre with three points, exact
// for a polynomial of the sixth degree in half the way with one of four.
double chord(double b2) {
  if (b2 >= 1.0) return 0.0;
  constexpr double at[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
  constexpr double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                               0.1012285362903763};
  const double half = std::sqrt(1.0 - b2);
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) sum += 2.0 * weight[i] * h(b2 + half * half * at[i] * at[i]);
  return half * sum;
}

CloudParticle particle_of(const glm::dvec3& place, double radius, double extinction_per_m) {
  CloudParticle particle{};
  particle.x = static_cast<float>(place.x);
  particle.y = static_cast<float>(place.y);
  particle.z = static_cast<float>(place.z);
  particle.radius = static_cast<float>(radius);
  particle.optical_mass = static_cast<float>(ball_mass * radius * radius * radius * extinction_per_m);
  particle.red = particle.green = particle.blue = 0.9999f;
  return particle;
}

glm::dvec3 place_of(const CloudParticle& particle) {
  return {particle.x, particle.y, particle.z};
}

}  // namespace

std::vector<CloudParticle> heap(const Heap& heap) {
  std::vector<CloudParticle> particles;
  for (int i = 0; static_cast<int>(particles.size()) < heap.count; ++i) {
    const PhiloxBlock block =
        philox_block(static_cast<std::uint32_t>(heap.seed), 0, OFFING_STREAM_SHAPES, i, 0, heap.cloud);
    glm::dvec3 place(uniform_open01(block.v[0]), uniform_open01(block.v[1]), uniform_open01(block.v[2]));
    place = 2.0 * place - 1.0;
    if (glm::length(place) > 1.0 || place.y * heap.half_axes_m.y < heap.base_m) continue;
    const double radius = std::lerp(heap.most_radius_m, heap.least_radius_m, glm::length(place));
    particles.push_back(particle_of(place * heap.half_axes_m, radius, heap.extinction_per_m));
    particles.back().cloud = heap.cloud;
    particles.back().id = static_cast<unsigned>(particles.size());
  }
  return particles;
}

std::vector<CloudParticle> layer(double optical_depth, double half_width_m, double thickness_m,
                                 double spacing_m) {
  std::vector<CloudParticle> particles;
  const int across = static_cast<int>(std::round(2.0 * half_width_m / spacing_m));
  const int high = std::max(1, static_cast<int>(std::round(thickness_m / spacing_m)));
  const double mass = optical_depth * spacing_m * spacing_m / high, radius = 1.2 * spacing_m;
  for (int y = 0; y < high; ++y) {
    for (int z = 0; z < across; ++z) {
      for (int x = 0; x < across; ++x) {
        // Odd planes lie over the gaps of even ones.
        const double shift = y % 2 == 0 ? 0.25 : 0.75;
        const glm::dvec3 place =
            spacing_m * glm::dvec3(x + shift - 0.5 * across, y + 0.5 - 0.5 * high, z + shift - 0.5 * across);
        particles.push_back(particle_of(place, radius, mass / (ball_mass * radius * radius * radius)));
      }
    }
  }
  return particles;
}

CloudVolume volume_of(std::span<const CloudParticle> particles, double cell_m) {
  constexpr int edge = CloudVolume::brick_cells;
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const CloudParticle& particle : particles) {
    low = glm::min(low, place_of(particle) - double{particle.radius});
    high = glm::max(high, place_of(particle) + double{particle.radius});
  }
  CloudVolume volume;
  volume.origin_m = low - cell_m;
  volume.cell_m = cell_m;
  std::array<int, 3> size{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    volume.bricks[i] = static_cast<int>(std::ceil((high[axis] - low[axis] + 2.0 * cell_m) / (cell_m * edge)));
    size[i] = volume.bricks[i] * edge;
  }
  std::vector<double> cells(static_cast<std::size_t>(size[0]) * size[1] * size[2]);
  std::vector<std::pair<std::size_t, double>> touched;
  for (const CloudParticle& particle : particles) {
    const glm::dvec3 at = (place_of(particle) - volume.origin_m) / cell_m;
    const double radius = particle.radius / cell_m;
    touched.clear();
    double sum = 0.0;
    const glm::ivec3 first(glm::floor(at - radius)), last(glm::floor(at + radius));
    for (int z = first.z; z <= last.z; ++z) {
      for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
          const glm::dvec3 way = (glm::dvec3(x, y, z) + 0.5 - at) / radius;
          const double value = h(glm::dot(way, way));
          if (value <= 0.0) continue;
          touched.emplace_back((static_cast<std::size_t>(z) * size[1] + y) * size[0] + x, value);
          sum += value;
        }
      }
    }
    for (const auto& [cell, value] : touched)
      cells[cell] += particle.optical_mass * value / (sum * cell_m * cell_m * cell_m);
  }
  for (int brick = 0; brick < volume.bricks[0] * volume.bricks[1] * volume.bricks[2]; ++brick) {
    const int bx = brick % volume.bricks[0], by = brick / volume.bricks[0] % volume.bricks[1],
              bz = brick / volume.bricks[0] / volume.bricks[1];
    std::vector<float> values;
    for (int i = 0; i < edge * edge * edge; ++i) {
      const int x = bx * edge + i % edge, y = by * edge + i / edge % edge, z = bz * edge + i / (edge * edge);
      values.push_back(static_cast<float>(cells[(static_cast<std::size_t>(z) * size[1] + y) * size[0] + x]));
    }
    const bool has_any = std::any_of(values.begin(), values.end(), [](float value) { return value > 0.0f; });
    volume.brick_of.push_back(has_any ? static_cast<std::int32_t>(volume.density.size() / values.size())
                                      : CloudVolume::no_brick);
    if (has_any) volume.density.insert(volume.density.end(), values.begin(), values.end());
  }
  return volume;
}

std::vector<std::array<float, 3>> albedo_of(std::span<const CloudParticle> particles,
                                            const CloudVolume& volume) {
  std::vector<std::array<float, 3>> albedo(volume.density.size(), {1.0f, 1.0f, 1.0f});
  constexpr std::array<float CloudParticle::*, 3> colours{&CloudParticle::red, &CloudParticle::green,
                                                          &CloudParticle::blue};
  for (std::size_t colour = 0; colour < colours.size(); ++colour) {
    // Less than nothing is not scattered: bricks stay those of the volume.
    std::vector<CloudParticle> weighted(particles.begin(), particles.end());
    for (CloudParticle& particle : weighted)
      particle.optical_mass *= std::max(particle.*colours[colour], 1e-6f);
    const CloudVolume scattered = volume_of(weighted, volume.cell_m);
    for (std::size_t i = 0; i < albedo.size(); ++i)
      if (volume.density[i] > 0.0f)
        albedo[i][colour] = std::min(1.0f, scattered.density[i] / volume.density[i]);
  }
  return albedo;
}

SpriteView view_of(std::span<const CloudParticle> particles, std::span<const CloudSprite> sprites,
                   const glm::dvec3& middle_m, double radius_m, const glm::dvec3& toward_eye, int pixels) {
  const glm::dvec3 aside =
      std::abs(toward_eye.y) < 0.99 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, -1.0);
  const glm::dvec3 right = glm::normalize(glm::cross(aside, toward_eye)), up = glm::cross(toward_eye, right);
  std::vector<std::size_t> order(particles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return glm::dot(place_of(particles[a]), toward_eye) < glm::dot(place_of(particles[b]), toward_eye);
  });
  SpriteView view;
  view.pixels = pixels;
  view.pixel_m = 2.0 * radius_m / pixels;
  view.light.resize(static_cast<std::size_t>(pixels) * pixels);
  view.opacity.resize(view.light.size());
  for (const std::size_t i : order) {
    const CloudParticle& particle = particles[i];
    const CloudSprite& sprite = sprites[i];
    const glm::dvec3 place = place_of(particle) - middle_m;
    const double x = (glm::dot(place, right) + radius_m) / view.pixel_m,
                 y = (radius_m - glm::dot(place, up)) / view.pixel_m, radius = particle.radius / view.pixel_m;
    const int x0 = std::max(0, static_cast<int>(x - radius)),
              x1 = std::min(pixels - 1, static_cast<int>(x + radius));
    const int y0 = std::max(0, static_cast<int>(y - radius)),
              y1 = std::min(pixels - 1, static_cast<int>(y + radius));
    for (int row = y0; row <= y1; ++row) {
      for (int column = x0; column <= x1; ++column) {
        const double dx = (column + 0.5 - x) / radius, dy = (row + 0.5 - y) / radius;
        const double alpha = -std::expm1(-sprite.optical_depth * chord(dx * dx + dy * dy));
        const auto pixel = static_cast<std::size_t>(row) * pixels + column;
        view.light[pixel] += alpha * (glm::dvec3(sprite.red, sprite.green, sprite.blue) - view.light[pixel]);
        view.opacity[pixel] += alpha * (1.0 - view.opacity[pixel]);
      }
    }
  }
  for (std::size_t pixel = 0; pixel < view.light.size(); ++pixel) {
    view.intensity_kcd += view.light[pixel] * view.pixel_m * view.pixel_m;
    view.covered_m2 += view.opacity[pixel] * view.pixel_m * view.pixel_m;
  }
  return view;
}

}  // namespace offing::clouds::test
