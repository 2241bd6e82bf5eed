#pragma once

#include <functional>
#include <vector>

#include "host/base/camera.h"

namespace offing::cli {

/// A flight over a map whose first post is at x = z = 0.
struct Flight {
  double width_m = 0.0, depth_m = 0.0;
  double step_m = 10.0;     ///< from frame to frame
  double height_m = 150.0;  ///< above the ground
  int frames = 600;
  /// Upper bound of the ground around a place of the plan.
  std::function<double(double x_m, double z_m)> bound_m;
};

/// Eye and direction of each frame: along a figure of eight that keeps a tenth of the map from its edges and
/// begins a little past the middle, following the bound of the ground smoothly, looking ahead and 10 degrees
/// down.
std::vector<Camera> flight_path(const Flight& flight);

}  // namespace offing::cli
