#include "host/terrain/shading/materials.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/base/numbers/degrees.h"
#include "host/base/numbers/normal_deviations.h"

namespace offing::terrain {
namespace {

TerrainMaterial device_material(const Material& material, std::size_t number) {
  const auto narrow = [](double value) { return static_cast<float>(value); };
  TerrainMaterial made{};
  made.like = static_cast<int>(material.like);
  made.red = narrow(material.colour.r);
  made.green = narrow(material.colour.g);
  made.blue = narrow(material.colour.b);
  made.roughness = narrow(material.roughness);
  made.lowest_m = material.lowest_m ? narrow(*material.lowest_m) : -TERRAIN_NO_LIMIT_M;
  made.highest_m = material.highest_m ? narrow(*material.highest_m) : TERRAIN_NO_LIMIT_M;
  made.edge_m = narrow(material.edge_m);
  made.gentlest_rad = narrow(material.gentlest_rad);
  made.steepest_rad = narrow(material.steepest_rad.value_or(std::numbers::pi));
  // Of the same noise with other signs, so that patches of materials do not lie on one another.
  made.of_patch = number % 2 == 0 ? 0.75f : -0.75f;
  made.of_broad = number / 2 % 2 == 0 ? 0.5f : -0.5f;
  made.of_fine = 0.43f;
  made.patches = narrow(patch_threshold(material.share));
  return made;
}

std::optional<double> degrees(double angle_deg) {
  return angle_deg * radians_per_degree;
}

}  // namespace

double patch_threshold(double share) {
  constexpr double all_deviations = -1e3;  // beyond all noise
  constexpr double least_share = 1e-6;
  return share >= 1.0 - least_share ? all_deviations : -deviations_below(std::max(share, least_share));
}

// Albedos are those of broadband tables (Oke 1987, Boundary layer climates, table 1.1) with colours of
// photographs.
std::vector<Material> materials_of(Landscape landscape, const LandscapeLines& lines) {
  const double above_shore_m = lines.shore_m + 1.5;
  switch (landscape) {
    case Landscape::plain:
      return {};
    case Landscape::alpine:
      return {{.name = "meadow",
               .like = MaterialLike::grass,
               .colour = {0.060, 0.092, 0.030},
               .lowest_m = above_shore_m,
               .highest_m = lines.tree_line_m + 250.0,
               .edge_m = 150.0,
               .steepest_rad = degrees(38.0)},
              {.name = "limestone scree",
               .like = MaterialLike::scree,
               .colour = {0.30, 0.29, 0.27},
               .lowest_m = lines.tree_line_m + 100.0,
               .edge_m = 200.0},
              {.name = "limestone",
               .like = MaterialLike::rock,
               .colour = {0.27, 0.265, 0.25},
               .gentlest_rad = 40.0 * radians_per_degree}};
    case Landscape::desert:
      return {{.name = "sand",
               .like = MaterialLike::sand,
               .colour = {0.42, 0.29, 0.17},
               .lowest_m = lines.shore_m,
               .edge_m = 2.0},
              {.name = "gravel",
               .like = MaterialLike::scree,
               .colour = {0.31, 0.21, 0.135},
               .lowest_m = above_shore_m,
               .gentlest_rad = 17.0 * radians_per_degree},
              {.name = "shrubs",
               .like = MaterialLike::grass,
               .colour = {0.105, 0.098, 0.052},
               .lowest_m = above_shore_m,
               .steepest_rad = degrees(24.0),
               .share = 0.08},
              {.name = "sandstone",
               .like = MaterialLike::rock,
               .colour = {0.29, 0.155, 0.092},
               .gentlest_rad = 32.0 * radians_per_degree}};
    case Landscape::tropical:
      return {{.name = "jungle",
               .like = MaterialLike::grass,
               .colour = {0.024, 0.048, 0.014},
               .roughness = 1.8,
               .lowest_m = above_shore_m,
               .edge_m = 1.0,
               .steepest_rad = degrees(52.0)},
              {.name = "grass",
               .like = MaterialLike::grass,
               .colour = {0.062, 0.090, 0.026},
               .lowest_m = above_shore_m,
               .edge_m = 1.0,
               .steepest_rad = degrees(30.0),
               .share = 0.25},
              {.name = "red soil",
               .like = MaterialLike::scree,
               .colour = {0.15, 0.078, 0.045},
               .roughness = 0.6,
               .lowest_m = above_shore_m,
               .gentlest_rad = 18.0 * radians_per_degree,
               .steepest_rad = degrees(48.0),
               .share = 0.06},
              {.name = "mossy rock",
               .like = MaterialLike::rock,
               .colour = {0.075, 0.080, 0.058},
               .gentlest_rad = 52.0 * radians_per_degree}};
    case Landscape::volcanic:
      return {{.name = "black sand",
               .like = MaterialLike::sand,
               .colour = {0.055, 0.052, 0.052},
               .steepest_rad = degrees(20.0)},
              {.name = "cinders",
               .like = MaterialLike::scree,
               .colour = {0.072, 0.060, 0.055},
               .lowest_m = above_shore_m,
               .gentlest_rad = 8.0 * radians_per_degree},
              {.name = "moss",
               .like = MaterialLike::grass,
               .colour = {0.070, 0.088, 0.024},
               .lowest_m = above_shore_m,
               .steepest_rad = degrees(35.0),
               .share = 0.35},
              {.name = "lava",
               .like = MaterialLike::rock,
               .colour = {0.062, 0.056, 0.054},
               .roughness = 1.2,
               .gentlest_rad = 36.0 * radians_per_degree}};
  }
  return {};
}

std::vector<TerrainMaterial> device_materials(std::span<const Material> materials) {
  std::vector<TerrainMaterial> made;
  for (const Material& material : materials) made.push_back(device_material(material, made.size()));
  return made;
}

MaterialLayer::MaterialLayer(const ocl::Device& device, std::span<const Material> materials)
    : materials_(device, device_materials(materials), "materials of terrain") {}

}  // namespace offing::terrain
