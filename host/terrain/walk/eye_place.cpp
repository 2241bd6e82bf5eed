// Eyes that are within or beside a ground.
#include "host/terrain/walk/eye_place.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace offing::terrain {

TerrainExtent extent_of(const HeightMap& map) {
  return {.width_m = map.spacing_x_m * (map.columns - 1),
          .depth_m = map.spacing_z_m * (map.rows - 1),
          .highest_m = *std::max_element(map.heights_m.begin(), map.heights_m.end())};
}

std::optional<std::string> lift_out_of_terrain(glm::dvec3& eye_m, double terrain_m, double above_m) {
  if (eye_m.y > terrain_m) return std::nullopt;
  const glm::dvec3 from_m = eye_m;
  eye_m.y = terrain_m + above_m;
  return fmt::format(
      "camera: the eye at ({:.1f}, {:.1f}, {:.1f}) m is {:.1f} m below the ground; raised to y = {:.1f} m, "
      "{:g} m above it",
      from_m.x, from_m.y, from_m.z, terrain_m - from_m.y, eye_m.y, above_m);
}

std::optional<std::string> warning_off_map(const glm::dvec3& eye_m, const TerrainExtent& extent,
                                           double origin_x_m, double origin_z_m) {
  constexpr double rounding_m = 1e-6;  // an eye on the edge is over the map
  const double x_m = eye_m.x - origin_x_m, z_m = eye_m.z - origin_z_m;
  const double beyond_m =
      std::hypot(std::max({0.0, -x_m, x_m - extent.width_m}), std::max({0.0, -z_m, z_m - extent.depth_m}));
  if (beyond_m <= rounding_m) return std::nullopt;
  return fmt::format(
      "camera: the eye at ({:.1f}, {:.1f}, {:.1f}) m is {:.1f} m beyond the map, which reaches from x = "
      "{:.1f} to {:.1f} m and from z = {:.1f} to {:.1f} m",
      eye_m.x, eye_m.y, eye_m.z, beyond_m, origin_x_m, origin_x_m + extent.width_m, origin_z_m,
      origin_z_m + extent.depth_m);
}

}  // namespace offing::terrain
