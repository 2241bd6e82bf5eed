#include "host/bodies/path_drive.h"

#include <cmath>
#include <numbers>

#include "host/base/parameter_check.h"
#include "host/bodies/floating_bodies.h"

namespace offing::bodies {

BodyDrive drive_along(const Path& path, double time_s) {
  constexpr double per_s = FloatingBodies::steps_per_s;
  const PathPlace from = path(time_s), to = path(time_s + 1.0 / per_s);
  require_within("body.x_m", to.x_m, -farthest_point_m, farthest_point_m);
  require_within("body.z_m", to.z_m, -farthest_point_m, farthest_point_m);
  const double tile_x = std::nearbyint(to.x_m / query_tile_m), tile_z = std::nearbyint(to.z_m / query_tile_m);
  const auto f = [](double value) { return static_cast<float>(value); };
  // A heading may pass half a turn between two places.
  const double turn = std::remainder(to.heading_rad - from.heading_rad, 2.0 * std::numbers::pi);
  BodyDrive drive{};
  drive.follows_path = 1;
  drive.tile_x = static_cast<int>(tile_x);
  drive.tile_z = static_cast<int>(tile_z);
  drive.x_m = f(to.x_m - tile_x * query_tile_m);
  drive.z_m = f(to.z_m - tile_z * query_tile_m);
  drive.heading_rad = f(std::remainder(to.heading_rad, 2.0 * std::numbers::pi));
  drive.velocity_x_mps = f((to.x_m - from.x_m) * per_s);
  drive.velocity_z_mps = f((to.z_m - from.z_m) * per_s);
  drive.heading_rate_radps = f(turn * per_s);
  return drive;
}

}  // namespace offing::bodies
