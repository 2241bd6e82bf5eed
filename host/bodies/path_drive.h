#pragma once

#include <functional>

#include "kernels/shared/bodies.h"

namespace offing::bodies {

/// Where a body that follows a path is to be at a time.
struct PathPlace {
  double x_m = 0.0, z_m = 0.0;
  double heading_rad = 0.0;  ///< of body x in the world, from +x toward +z
};
using Path = std::function<PathPlace(double time_s)>;

/// The drive of a body that is led along a path, in the sub-step that begins at a time: it ends where the
/// path is then. Speeds are those of the path's differences over the sub-step. Throws Error(bad_input) for a
/// place beyond farthest_point_m.
BodyDrive drive_along(const Path& path, double time_s);

}  // namespace offing::bodies
