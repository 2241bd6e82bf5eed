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
  const SurfaceQueryPoint place = tile_point(to.x_m, to.z_m);
  const auto f = [](double value) { return static_cast<float>(value); };
  // A heading may pass half a turn between two places.
  const double turn = std::remainder(to.heading_rad - from.heading_rad, 2.0 * std::numbers::pi);
  BodyDrive drive{};
  drive.follows_path = 1;
  drive.tile_x = place.tile_x;
  drive.tile_z = place.tile_z;
  drive.x_m = place.x_m;
  drive.z_m = place.z_m;
  drive.heading_rad = f(std::remainder(to.heading_rad, 2.0 * std::numbers::pi));
  drive.velocity_x_mps = f((to.x_m - from.x_m) * per_s);
  drive.velocity_z_mps = f((to.z_m - from.z_m) * per_s);
  drive.heading_rate_radps = f(turn * per_s);
  return drive;
}

}  // namespace offing::bodies
