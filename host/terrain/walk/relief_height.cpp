// Relief between posts in double precision, as kernels/terrain/relief_posts.cl lays it.
#include "host/terrain/walk/relief_height.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>

#include "host/terrain/lakes/lake.h"

namespace offing::terrain {
namespace {

constexpr std::array<float, TERRAIN_RELIEF_OCTAVES> turf_slopes{TERRAIN_TURF_SLOPES},
    stone_slopes{TERRAIN_STONE_SLOPES}, rock_slopes{TERRAIN_ROCK_SLOPES};

double smooth_step(double from, double to, double value) {
  const double share = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

double fade(double x) {
  return x * x * x * (x * (6.0 * x - 15.0) + 10.0);
}

/// Gradient noise of deviation 1 (kernels/terrain/terrain_noise.clh), at a place in cells of its lattice.
double noise_at(const glm::dvec3& place, std::uint32_t seed) {
  constexpr std::array<std::uint32_t, 3> steps{0x8da6b343u, 0xd8163841u, 0xcb1ab31fu};
  constexpr double scale = 1.0 / (2147483648.0 * 0.1906);
  double sum = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    std::uint32_t number = seed;
    double weight = 1.0;
    glm::dvec3 way;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double first = std::floor(place[axis]), in_cell = place[axis] - first;
      const unsigned is_far = corner >> axis & 1u;
      number += static_cast<std::uint32_t>(static_cast<std::int64_t>(first) + is_far) * steps[axis];
      weight *= is_far != 0 ? fade(in_cell) : 1.0 - fade(in_cell);
      way[axis] = in_cell - is_far;
    }
    std::uint32_t hash = (number ^ number >> 15) * 0x2c1b3c6du;
    hash ^= hash >> 13;
    const auto component = [&](unsigned shift) {
      return static_cast<double>(static_cast<std::int32_t>(hash << shift));
    };
    sum += weight * glm::dot(glm::dvec3(component(0), component(11), component(22)), way);
  }
  return scale * sum;
}

/// Of what covers the ground, parts of the relief's height.
struct ReliefParts {
  double turf = 1.0, stones = 0.0, rock = 0.0;
};

ReliefParts parts_of(const ReliefSettings& settings, double height_m, double up) {
  ReliefParts parts;
  const double soils = 0.85 * (1.0 - smooth_step(0.69, 0.79, up));
  const double stony = smooth_step(-0.6, 1.3, (height_m - settings.tree_line_m) / 200.0);
  const double rocky = 1.0 - smooth_step(0.73, 0.82, up);
  const double snow =
      smooth_step(-0.5, 1.0, (height_m - settings.snow_line_m) / 200.0) * smooth_step(0.62, 0.74, up);
  const double open = (1.0 - rocky) * (1.0 - snow);
  parts.turf = open * (1.0 - soils) * (1.0 - stony);
  parts.stones = open * (0.6 * soils * (1.0 - stony) + stony);
  parts.rock = rocky * (1.0 - snow);
  return parts;
}

constexpr float step_m = 0.01171875f;

/// A place on an axis in steps of kernels/terrain/terrain_noise.clh, where a cell is whole 4096ths of them.
double lattice_place(double cells, double spacing_m) {
  const float steps = 1.0f / (static_cast<float>(1.0 / spacing_m) * step_m);
  return cells * std::floor(static_cast<double>(steps) * 4096.0) / 4096.0;
}

}  // namespace

double relief_height_m(const TerrainPosts& posts, const ReliefSettings& settings, double x_m, double z_m,
                       const glm::dvec3& eye_m) {
  const auto ground = terrain_at(posts, x_m, z_m);
  const auto normal = smooth_normal_at(posts, x_m, z_m);
  const double spacing_m = std::max(posts.spacing_x_m, posts.spacing_z_m),
               least_spacing_m = std::min(posts.spacing_x_m, posts.spacing_z_m);
  const ReliefLevels levels =
      relief_levels(posts.columns - 1, posts.rows - 1, posts.spacing_x_m, posts.spacing_z_m);
  const double distance_m = glm::length(glm::dvec3(x_m, ground ? ground->height_m : 0.0, z_m) - eye_m);
  if (!ground || !normal || levels.count == 0 || distance_m >= levels.reach_m) return 0.0;
  const double cells_x = x_m / posts.spacing_x_m, cells_z = z_m / posts.spacing_z_m;
  const double to_edge =
      std::min(std::min(cells_x, posts.columns - 1 - cells_x), std::min(cells_z, posts.rows - 1 - cells_z));
  double strength = settings.strength * smooth_step(0.0, 1.0, to_edge) *
                    std::clamp((ground->height_m - settings.shore_m) / 4.0, 0.0, 1.0) /
                    std::max(normal->y, 0.4) *
                    (1.0 - smooth_step(0.5 * levels.reach_m, levels.reach_m, distance_m));
  for (const LevelDisc& disc : settings.discs) {
    const double away_m = std::hypot(x_m - disc.x_m, z_m - disc.z_m);
    strength *= 1.0 - disc.share * (1.0 - smooth_step(disc.radius_m, disc.radius_m + disc.ramp_m(), away_m));
  }
  for (const auto& lake : settings.lakes) {
    const double above = std::clamp((ground->height_m - lake->level_m) / 4.0, 0.0, 1.0);
    strength *= 1.0 - nearness_to_lake(*lake, posts, x_m, z_m) * (1.0 - above);
  }
  const ReliefParts parts = parts_of(settings, ground->height_m, normal->y);
  const glm::dvec3 steps(lattice_place(cells_x, posts.spacing_x_m),
                         ground->height_m / static_cast<double>(step_m),
                         lattice_place(cells_z, posts.spacing_z_m));
  const glm::dvec3 place(2.0 * (steps.x + steps.z) - steps.y, 2.0 * (steps.x + steps.y) - steps.z,
                         2.0 * (steps.y + steps.z) - steps.x);
  const double least_m = 4.0 * std::ldexp(spacing_m, -levels.finest_log2);
  double height_m = 0.0;
  for (unsigned octave = 0; octave < TERRAIN_RELIEF_OCTAVES; ++octave) {
    const double cell_m = std::ldexp(1.0, static_cast<int>(octave) - 6);
    const double shown = std::clamp(2.0 - cell_m / least_spacing_m, 0.0, 1.0) *
                         (1.0 - smooth_step(16.0 * cell_m, 26.0 * cell_m, distance_m));
    if (cell_m < least_m || shown == 0.0) continue;
    const double noise = noise_at(place / std::ldexp(4.0, static_cast<int>(octave)), 0x9e3779b9u * octave);
    const double lump = std::sqrt(noise * noise + 0.01) - 0.798;
    const auto slope = [octave](const std::array<float, TERRAIN_RELIEF_OCTAVES>& slopes) {
      return static_cast<double>(slopes[octave]);
    };
    height_m += shown * cell_m / 2.615 *
                (noise * parts.turf * slope(turf_slopes) +
                 lump * (parts.stones * slope(stone_slopes) - parts.rock * slope(rock_slopes)));
  }
  return strength * height_m;
}

}  // namespace offing::terrain
