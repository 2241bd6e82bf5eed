#include "host/scene/prepare/mesh_motion.h"

#include <memory>

#include "host/base/camera.h"
#include "host/scene/model/moving_number.h"

namespace offing::scene {

namespace {

/// A mesh is turned as a head is: its -z axis is where it looks (camera.h).
class MeshMotion {
 public:
  MeshMotion(const Scene& scene, const MeshScene& mesh, ElementIndex element)
      : x_m_(scene, {"mesh.x_m", element}, mesh.position_m.x),
        y_m_(scene, {"mesh.y_m", element}, mesh.position_m.y),
        z_m_(scene, {"mesh.z_m", element}, mesh.position_m.z),
        yaw_rad_(scene, {"mesh.yaw_deg", element}, mesh.yaw_rad),
        pitch_rad_(scene, {"mesh.pitch_deg", element}, mesh.pitch_rad),
        roll_rad_(scene, {"mesh.roll_deg", element}, mesh.roll_rad),
        spin_radps_(mesh.spin_radps) {}

  highlights::RigidMotion at(double time_s) const {
    const CameraBasis axes = basis({.yaw_rad = yaw_rad_.at(time_s) + spin_radps_ * time_s,
                                    .pitch_rad = pitch_rad_.at(time_s),
                                    .roll_rad = roll_rad_.at(time_s)});
    return {.rotation = {axes.right, axes.up, -axes.forward},
            .translation_m = {x_m_.at(time_s), y_m_.at(time_s), z_m_.at(time_s)}};
  }

 private:
  MovingNumber x_m_, y_m_, z_m_, yaw_rad_, pitch_rad_, roll_rad_;
  double spin_radps_;
};

}  // namespace

std::function<highlights::RigidMotion(double)> motion_of(const Scene& scene, std::size_t mesh) {
  // Shared, because functions are copied.
  const auto motion = std::make_shared<const MeshMotion>(scene, scene.meshes.at(mesh), ElementIndex{mesh, 0});
  return [motion](double time_s) { return motion->at(time_s); };
}

}  // namespace offing::scene
