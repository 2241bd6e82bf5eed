#pragma once

#include <cstddef>
#include <vector>

#include "host/bodies/body_pose.h"
#include "host/bodies/floating_body.h"
#include "host/bodies/hull_map.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "kernels/shared/wake.h"

namespace offing::bodies {

/// A hull as it presses on water in a wake window: by the volume that it displaces at the moment, which its
/// underside shares out, as deep as it is below a level of its own axes. That level is the one at which the
/// upright hull displaces this volume: on steep waves it is an approximation, its volume is not.
class HullPresser {
 public:
  /// `map` is that of the body's mesh (map_of_hull()).
  HullPresser(const ocl::Device& device, const HullMap& map, const glm::dvec3& mass_centre_m);

  /// Enqueues what adds the hull in this pose to displaced [n][n] m of a window, taken by a factor.
  /// Nothing for a hull beside the window, or one that displaces nothing.
  void press(const BodyPose& pose, double factor, const WakeGrid& grid, ocl::Buffer<float>& displaced) const;

  /// The level of the mesh's axes at which the upright hull displaces this volume, by its map.
  double level_m(double displaced_m3) const;

 private:
  ocl::Kernel kernel_;
  std::size_t group_side_;  // cells
  ocl::Buffer<float> bottom_;
  double low_x_m_, low_z_m_, cell_x_m_, cell_z_m_;
  glm::dvec3 mass_centre_m_;
  double lowest_m_, level_step_m_;
  std::vector<double> volumes_m3_;  // by levels from the lowest place on
};

}  // namespace offing::bodies
