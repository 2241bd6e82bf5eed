#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "kernels/shared/bodies.h"
#include "kernels/shared/query_params.h"

namespace offing::bodies {

/// Side of the tiles that devices count the places of bodies in.
inline constexpr double query_tile_m = SURFACE_QUERY_TILE_M;

/// Where a body is and how it moves.
struct BodyPose {
  glm::dvec3 mass_centre_m{0.0};        ///< in the world, y above the water plane
  glm::dquat turn{1.0, 0.0, 0.0, 0.0};  ///< from body axes (x forward, y up, z to starboard) to the world's
  glm::dvec3 velocity_mps{0.0};         ///< of the mass centre, in world axes
  glm::dvec3 spin_radps{0.0};           ///< in body axes
  double displaced_m3 = 0.0;            ///< of water, a sub-step before
  glm::dvec2 flow_mps{0.0};             ///< of the water around the hull then, along x and z
  glm::dvec2 shift_m{0.0};              ///< of that water from its place at rest, along x and z
};

/// A place as devices have it.
SurfaceQueryPoint tile_point(double x_m, double z_m);

/// Of body x in the world, from +x toward +z, rad.
double heading_of(const BodyPose& pose);
/// An upright body's turn.
glm::dquat turn_of_heading(double heading_rad);

/// As devices have it. Throws Error(bad_input) for places beyond farthest_point_m, or not finite.
BodyState device_state(const BodyPose& pose);
BodyPose pose_of(const BodyState& state);

/// Between two poses, share 0 ... 1: places and motions in proportion, turns along the shortest arc.
BodyPose pose_between(const BodyPose& from, const BodyPose& to, double share);

}  // namespace offing::bodies
