#include "host/cli/terrain_place.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::cli {

terrain::GroundPoint ground_under(std::string_view flag, const HeightMap& map, double x_m, double z_m) {
  if (const auto ground = terrain::ground_at(map, x_m, z_m)) return *ground;
  throw Error(
      ErrorKind::bad_input,
      fmt::format("{}: expected a place within 0 ... {:g} m east and 0 ... {:g} m south of the "
                  "north-west post, found {:g}, {:g}",
                  flag, map.spacing_x_m * (map.columns - 1), map.spacing_z_m * (map.rows - 1), x_m, z_m),
      "`offing terrain info` tells the extent of the map");
}

double slope_deg(const glm::dvec3& normal) {
  return std::acos(std::clamp(normal.y, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

nlohmann::ordered_json to_json(const glm::dvec3& vector) {
  return {vector.x, vector.y, vector.z};
}

}  // namespace offing::cli
