#pragma once

#include <glm/vec3.hpp>

#include "host/base/sea/hydrodynamic_data.h"
#include "host/bodies/floating_body.h"

namespace offing::bodies {

/// Sway force and yaw moment of a long hull that runs ahead while it sways and yaws, besides those of its
/// added mass and of cross-flow drag, at a point amidships:
///   force = -density (|u| force_by_sway w + u force_by_yaw q),
///   moment = -density (u moment_by_sway w + |u| moment_by_yaw q)
/// in body axes, u ahead and w to starboard at the point and through the water, q about the axis up. They
/// never do work on the hull.
struct HullLift {
  double share = 0.0;     ///< of the hull's cross-flow that drags apart from what runs along it
  glm::dvec3 arm_m{0.0};  ///< of the point, from the mass centre
  double force_by_sway_m2 = 0.0, force_by_yaw_m3 = 0.0, moment_by_sway_m3 = 0.0, moment_by_yaw_m4 = 0.0;
};

/// What is missing to the linear derivatives of Clarke, Gedling & Hine 1983, The application of manoeuvring
/// criteria in hull design using linear theory, for its length, breadth, draught and block coefficient where
/// it floats. They are regressions of ships of 5 to 8 times their breadth: whole from 4 times on, none below
/// 2 times. added_mass: at infinite frequency, about the mass centre; 0 if the body's motion has none.
HullLift lift_of_hull(const FloatingBody& body, double density_kgpm3, const HullMatrix& added_mass);

}  // namespace offing::bodies
