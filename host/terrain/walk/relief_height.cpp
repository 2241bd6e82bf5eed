// Relief between posts in double precision, as kernels/terrain/relief_posts.cl lays it.
#include "host/terrain/walk/relief_height.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>

#include "host/terrain/lakes/lake.h"
#include "kernels/shared/terrain_noise.h"

namespace offing::terrain {
namespace {

constexpr std::array<float, TERRAIN_RELIEF_OCTAVES> turf_slopes{TERRAIN_TURF_SLOPES},
    stone_slopes{TERRAIN_STONE_SLOPES}, rock_slopes{TERRAIN_ROCK_SLOPES}, sand_slopes{TERRAIN_SAND_SLOPES};

double smooth_step(double from, double to, double value) {
  const double share = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

double fade(double x) {
  return x * x * x * (x * (6.0 * x - 15.0) + 10.0);
}

/// Gradient noise of deviation 1 (kernels/terrain/cover/terrain_noise.clh), at a place in cells of its lattice.
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

/// How much of the relief's height each cover of the ground has.
struct ReliefParts {
  double turf = 1.0, stones = 0.0, rock = 0.0, sand = 0.0;

  void scale(double share) {
    for (double* part : {&turf, &stones, &rock, &sand}) *part *= share;
  }
};

/// The ground's own cover, without its snow.
ReliefParts cover_parts(const ReliefSettings& settings, double height_m, double up) {
  ReliefParts parts;
  const double soils = 0.85 * (1.0 - smooth_step(0.69, 0.79, up));
  const double stony = smooth_step(-0.6, 1.3, (height_m - settings.tree_line_m) / 200.0);
  const double rocky = 1.0 - smooth_step(0.73, 0.82, up);
  parts.turf = (1.0 - rocky) * (1.0 - soils) * (1.0 - stony);
  parts.stones = (1.0 - rocky) * (0.6 * soils * (1.0 - stony) + stony);
  parts.rock = rocky;
  return parts;
}

double snow_share(const ReliefSettings& settings, double height_m, double up) {
  return smooth_step(-0.5, 1.0, (height_m - settings.snow_line_m) / 200.0) * smooth_step(0.62, 0.74, up);
}

double cell_m_of(unsigned octave) {
  return std::ldexp(1.0, static_cast<int>(octave) - 6);
}

/// Of deviation 1, at a place on the axes of the noise, in thirds of steps.
double octave_at(const glm::dvec3& place, unsigned octave) {
  return noise_at(place / std::ldexp(4.0, static_cast<int>(octave)), 0x9e3779b9u * octave);
}

/// How much of an octave is left at this distance.
double octave_share(unsigned octave, double distance_m) {
  return 1.0 - smooth_step(16.0 * cell_m_of(octave), 26.0 * cell_m_of(octave), distance_m);
}

/// The noise that shapes patches of materials (ground_textures.clh), of deviation 1 but for the variance that
/// is too small to be seen. Nothing of its finest range is seen.
struct PatchNoise {
  double broad = 0.0, patch = 0.0, patch_lost = 1.0;
};

PatchNoise patch_noise(const glm::dvec3& steps, const glm::dvec3& place, double distance_m, double least_m) {
  constexpr unsigned first_patch = 6;
  constexpr double patch_octaves = TERRAIN_RELIEF_OCTAVES - first_patch;
  // Level noise is noise in space, cut through points of its lattice, but its deviation is another one.
  constexpr double level_scale = 0.1906 / 0.1761;
  PatchNoise noise;
  for (const unsigned cell_log2 : {13u, 15u, 17u}) {
    const double cell = std::ldexp(1.0, static_cast<int>(cell_log2));
    noise.broad +=
        0.577 * level_scale * noise_at({steps.x / cell, 0.0, steps.z / cell}, 0x9e3779b9u * cell_log2);
  }
  for (unsigned octave = first_patch; octave < TERRAIN_RELIEF_OCTAVES; ++octave) {
    if (cell_m_of(octave) < least_m) continue;
    const double share = octave_share(octave, distance_m);
    noise.patch += 0.378 * share * octave_at(place, octave);
    noise.patch_lost -= share * share / patch_octaves;
  }
  noise.patch_lost = std::max(noise.patch_lost, 0.0);
  return noise;
}

/// The mean of a smooth step over values of this variance.
double soft_step(double middle, double half_width, double value, double variance) {
  const double width = std::sqrt(half_width * half_width + 5.0 * variance);
  return smooth_step(middle - width, middle + width, value);
}

/// As material_share() has it (terrain_cover.clh).
double material_share(const Material& material, const TerrainMaterial& on_device, const PatchNoise& seen,
                      double height_m, double up) {
  constexpr double half_rad = 0.07, wander_rad = 0.03;
  const auto square = [](double value) { return value * value; };
  const double noise = 0.577 * (seen.broad + seen.patch), lost = (seen.patch_lost + 1.0) / 3.0;
  const double wander_m = 0.4 * material.edge_m, half_m = 0.5 * material.edge_m;
  const auto above = [&](double limit_m) {
    return soft_step(limit_m, half_m, height_m + wander_m * noise, square(wander_m) * lost);
  };
  const double slope_rad = std::acos(std::clamp(up, 0.0, 1.0)) + wander_rad * noise;
  const auto steeper = [&](double limit_rad) {
    return soft_step(limit_rad, half_rad, slope_rad, square(wander_rad) * lost);
  };
  double share = 1.0;
  if (material.lowest_m) share = above(*material.lowest_m);
  if (material.highest_m) share *= 1.0 - above(*material.highest_m);
  if (material.steepest_rad) share *= 1.0 - steeper(*material.steepest_rad);
  if (material.gentlest_rad > 0.0) share *= steeper(material.gentlest_rad);
  const auto part = [](float value) { return static_cast<double>(value); };
  const double patches = part(on_device.of_broad) * seen.broad + part(on_device.of_patch) * seen.patch;
  const double patches_lost =
      square(part(on_device.of_patch)) * seen.patch_lost + square(part(on_device.of_fine));
  return share * soft_step(part(on_device.patches), 0.3, patches, patches_lost);
}

void lay_materials(const ReliefSettings& settings, const PatchNoise& seen, double height_m, double up,
                   ReliefParts& parts) {
  const std::vector<TerrainMaterial> on_device = device_materials(settings.materials);
  for (std::size_t i = 0; i < on_device.size(); ++i) {
    const Material& material = settings.materials[i];
    const double share = material_share(material, on_device[i], seen, height_m, up);
    parts.scale(1.0 - share);
    double* const of_like[]{&parts.turf, &parts.stones, &parts.rock, &parts.sand};
    *of_like[static_cast<std::size_t>(material.like)] += material.roughness * share;
  }
}

constexpr float step_m = TERRAIN_STEP_M;

/// A place on an axis in steps of kernels/terrain/cover/terrain_noise.clh, where a cell is whole 4096ths of them.
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
  const glm::dvec3 steps(lattice_place(cells_x, posts.spacing_x_m),
                         ground->height_m / static_cast<double>(step_m),
                         lattice_place(cells_z, posts.spacing_z_m));
  const glm::dvec3 place(2.0 * (steps.x + steps.z) - steps.y, 2.0 * (steps.x + steps.y) - steps.z,
                         2.0 * (steps.y + steps.z) - steps.x);
  const double least_m = 4.0 * std::ldexp(spacing_m, -levels.finest_log2);
  ReliefParts parts = cover_parts(settings, ground->height_m, normal->y);
  if (!settings.materials.empty()) {
    lay_materials(settings, patch_noise(steps, place, distance_m, least_m), ground->height_m, normal->y,
                  parts);
  }
  parts.scale(1.0 - snow_share(settings, ground->height_m, normal->y));
  double height_m = 0.0;
  for (unsigned octave = 0; octave < TERRAIN_RELIEF_OCTAVES; ++octave) {
    const double cell_m = cell_m_of(octave);
    const double shown =
        std::clamp(2.0 - cell_m / least_spacing_m, 0.0, 1.0) * octave_share(octave, distance_m);
    if (cell_m < least_m || shown == 0.0) continue;
    const double noise = octave_at(place, octave);
    const double lump = std::sqrt(noise * noise + 0.01) - 0.798;
    const auto slope = [octave](const std::array<float, TERRAIN_RELIEF_OCTAVES>& slopes) {
      return static_cast<double>(slopes[octave]);
    };
    height_m += shown * cell_m / 2.615 *
                (noise * (parts.turf * slope(turf_slopes) + parts.sand * slope(sand_slopes)) +
                 lump * (parts.stones * slope(stone_slopes) - parts.rock * slope(rock_slopes)));
  }
  return strength * height_m;
}

}  // namespace offing::terrain
