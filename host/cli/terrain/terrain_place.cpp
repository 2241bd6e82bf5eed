#include "host/cli/terrain/terrain_place.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::cli {

namespace {

Error beyond_map(std::string_view flag, double width_m, double depth_m, double x_m, double z_m) {
  return {ErrorKind::bad_input,
          fmt::format("{}: expected a place within 0 ... {:g} m east and 0 ... {:g} m south of the "
                      "north-west post, found {:g}, {:g}",
                      flag, width_m, depth_m, x_m, z_m),
          "`offing terrain info FILE` prints the extent of the map"};
}

}  // namespace

void require_within(std::string_view flag, double width_m, double depth_m, double x_m, double z_m) {
  if (x_m >= 0.0 && x_m <= width_m && z_m >= 0.0 && z_m <= depth_m) return;
  throw beyond_map(flag, width_m, depth_m, x_m, z_m);
}

terrain::TerrainPoint terrain_under(std::string_view flag, const terrain::TerrainPosts& posts, double x_m,
                                    double z_m) {
  if (const auto terrain = terrain::terrain_at(posts, x_m, z_m)) return *terrain;
  throw beyond_map(flag, posts.width_m(), posts.depth_m(), x_m, z_m);
}

double slope_deg(const glm::dvec3& normal) {
  return std::acos(std::clamp(normal.y, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

nlohmann::ordered_json to_json(const glm::dvec3& vector) {
  return {vector.x, vector.y, vector.z};
}

}  // namespace offing::cli
