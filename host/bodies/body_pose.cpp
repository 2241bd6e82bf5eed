#include "host/bodies/body_pose.h"

#include <cmath>

#include <glm/common.hpp>

#include "host/base/parameter_check.h"

namespace offing::bodies {

double heading_of(const BodyPose& pose) {
  const glm::dvec3 forward = pose.turn * glm::dvec3(1.0, 0.0, 0.0);
  return std::atan2(forward.z, forward.x);
}

glm::dquat turn_of_heading(double heading_rad) {
  return glm::angleAxis(-heading_rad, glm::dvec3(0.0, 1.0, 0.0));
}

SurfaceQueryPoint tile_point(double x_m, double z_m) {
  const double tile_x = std::nearbyint(x_m / query_tile_m), tile_z = std::nearbyint(z_m / query_tile_m);
  return {.tile_x = static_cast<int>(tile_x),
          .tile_z = static_cast<int>(tile_z),
          .x_m = static_cast<float>(x_m - tile_x * query_tile_m),
          .z_m = static_cast<float>(z_m - tile_z * query_tile_m)};
}

BodyState device_state(const BodyPose& pose) {
  require_within("body.x_m", pose.mass_centre_m.x, -farthest_point_m, farthest_point_m);
  require_within("body.y_m", pose.mass_centre_m.y, -deepest_m, deepest_m);
  require_within("body.z_m", pose.mass_centre_m.z, -farthest_point_m, farthest_point_m);
  const SurfaceQueryPoint place = tile_point(pose.mass_centre_m.x, pose.mass_centre_m.z);
  return {.tile_x = place.tile_x,
          .tile_z = place.tile_z,
          .x_m = place.x_m,
          .y_m = static_cast<float>(pose.mass_centre_m.y),
          .z_m = place.z_m,
          .turn_x = static_cast<float>(pose.turn.x),
          .turn_y = static_cast<float>(pose.turn.y),
          .turn_z = static_cast<float>(pose.turn.z),
          .turn_w = static_cast<float>(pose.turn.w),
          .velocity_x_mps = static_cast<float>(pose.velocity_mps.x),
          .velocity_y_mps = static_cast<float>(pose.velocity_mps.y),
          .velocity_z_mps = static_cast<float>(pose.velocity_mps.z),
          .spin_x_radps = static_cast<float>(pose.spin_radps.x),
          .spin_y_radps = static_cast<float>(pose.spin_radps.y),
          .spin_z_radps = static_cast<float>(pose.spin_radps.z),
          .displaced_m3 = static_cast<float>(pose.displaced_m3),
          .flow_x_mps = static_cast<float>(pose.flow_mps.x),
          .flow_z_mps = static_cast<float>(pose.flow_mps.y),
          .shift_x_m = static_cast<float>(pose.shift_m.x),
          .shift_z_m = static_cast<float>(pose.shift_m.y)};
}

BodyPose pose_of(const BodyState& state) {
  return {.mass_centre_m = {query_tile_m * state.tile_x + static_cast<double>(state.x_m), state.y_m,
                            query_tile_m * state.tile_z + static_cast<double>(state.z_m)},
          .turn = glm::normalize(glm::dquat(state.turn_w, state.turn_x, state.turn_y, state.turn_z)),
          .velocity_mps = {state.velocity_x_mps, state.velocity_y_mps, state.velocity_z_mps},
          .spin_radps = {state.spin_x_radps, state.spin_y_radps, state.spin_z_radps},
          .displaced_m3 = state.displaced_m3,
          .flow_mps = {state.flow_x_mps, state.flow_z_mps},
          .shift_m = {state.shift_x_m, state.shift_z_m}};
}

BodyPose pose_between(const BodyPose& from, const BodyPose& to, double share) {
  return {.mass_centre_m = glm::mix(from.mass_centre_m, to.mass_centre_m, share),
          .turn = glm::slerp(from.turn, to.turn, share),
          .velocity_mps = glm::mix(from.velocity_mps, to.velocity_mps, share),
          .spin_radps = glm::mix(from.spin_radps, to.spin_radps, share),
          .displaced_m3 = std::lerp(from.displaced_m3, to.displaced_m3, share),
          .flow_mps = glm::mix(from.flow_mps, to.flow_mps, share),
          .shift_m = glm::mix(from.shift_m, to.shift_m, share)};
}

}  // namespace offing::bodies
