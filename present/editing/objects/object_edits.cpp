#include "present/editing/objects/object_edits.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "host/clouds/shape/genera.h"
#include "host/scene/model/moving_number.h"
#include "present/editing/objects/pushed_value.h"

namespace offing::present {
namespace {

using scene::Scene;

/// The short way from one angle to another.
double way_between(double from_rad, double to_rad) {
  return std::remainder(to_rad - from_rad, 2.0 * std::numbers::pi);
}

void multiply(std::string_view key, std::optional<double>& value, double factor) {
  if (value) value = within_range(key, factor * *value);
}

glm::dvec2 azimuth_and_elevation(const glm::dvec3& direction) {
  return {std::atan2(direction.x, -direction.z), std::asin(std::clamp(direction.y, -1.0, 1.0))};
}

}  // namespace

glm::dvec3 turns_of(const glm::dmat3& rotation) {
  constexpr double nearly_up = 1.0 - 1e-12;
  const glm::dvec3 forward = -rotation[2], right = rotation[0];
  const double pitch_rad = std::asin(std::clamp(forward.y, -1.0, 1.0));
  if (std::abs(forward.y) > nearly_up) return {std::atan2(right.z, right.x), pitch_rad, 0.0};
  const double yaw_rad = std::atan2(forward.x, -forward.z);
  const glm::dvec3 level_right(std::cos(yaw_rad), 0.0, std::sin(yaw_rad));
  const glm::dvec3 level_up(-std::sin(yaw_rad) * forward.y, std::cos(pitch_rad),
                            std::cos(yaw_rad) * forward.y);
  return {yaw_rad, pitch_rad, std::atan2(-glm::dot(right, level_up), glm::dot(right, level_right))};
}

glm::dmat3 rotation_of(const ObjectPull& pull) {
  const double angle_rad = glm::length(pull.turn_rad);
  if (angle_rad == 0.0) return glm::dmat3(1.0);
  return glm::mat3_cast(glm::angleAxis(angle_rad, pull.turn_rad / angle_rad));
}

void pull_mesh(Scene& scene, const HeldMesh& held, const ObjectPull& pull) {
  const scene::ElementIndex element{held.mesh, 0};
  scene::MeshScene& mesh = scene.meshes[held.mesh];
  const double scale = within_range("mesh.scale", pull.ratio * mesh.scale);
  const double ratio = scale / std::exchange(mesh.scale, scale);
  const glm::dmat3 to_parent = glm::transpose(held.parent.rotation);
  const glm::dmat3 rotation = to_parent * rotation_of(pull) * held.parent.rotation * held.local.rotation;
  const glm::dvec3 middle_m = held.local.rotation * held.middle_m + held.local.translation_m;
  const glm::dvec3 place_m = middle_m + to_parent * pull.way_m - rotation * (ratio * held.middle_m);
  const glm::dvec3 way_m = place_m - held.local.translation_m;
  for (const auto& [key, way] :
       {std::pair("mesh.x_m", way_m.x), {"mesh.y_m", way_m.y}, {"mesh.z_m", way_m.z}}) {
    push_value(scene, key, element, way);
  }
  if (pull.turn_rad == glm::dvec3(0.0)) return;
  const glm::dvec3 before = turns_of(held.local.rotation), after = turns_of(rotation);
  turn_value(scene, "mesh.yaw_deg", element, way_between(before.x, after.x));
  turn_value(scene, "mesh.pitch_deg", element, way_between(before.y, after.y));
  turn_value(scene, "mesh.roll_deg", element, way_between(before.z, after.z));
}

void pull_body(Scene& scene, const HeldBody& held, const ObjectPull& pull) {
  const scene::ElementIndex element{held.body, 0};
  scene::BodyScene& body = scene.bodies[held.body];
  if (held.pose) {
    body.x_m = held.pose->x_m;
    body.z_m = held.pose->z_m;
    body.heading_rad = std::remainder(held.pose->heading_rad, 2.0 * std::numbers::pi);
  }
  push_value(scene, "body.x_m", element, pull.way_m.x);
  push_value(scene, "body.z_m", element, pull.way_m.z);
  // Headings grow clockwise, seen from above.
  turn_value(scene, "body.heading_deg", element, -pull.turn_rad.y);
  if (pull.ratio == 1.0 || !held.hull) return;
  double& scale = scene.meshes[*held.hull].scale;
  const double larger = within_range("mesh.scale", pull.ratio * scale);
  const double ratio = larger / std::exchange(scale, larger);
  multiply("body.draught_m", body.draught_m, ratio);
  multiply("body.mass_kg", body.mass_kg, ratio * ratio * ratio);
  multiply("body.propeller_m", body.propeller_m, ratio);
  multiply("body.rudder_m2", body.rudder_m2, ratio * ratio);
}

std::optional<Sphere> place_of(const Scene& scene, const SceneObject& object, double time_s) {
  switch (object.kind) {
    case ObjectKind::cloud_layer: {
      const scene::CloudLayerScene& layer = scene.cloud_layers[object.index];
      const double usual_m = clouds::preset(layer.genus).position_m.y;
      return Sphere{{layer.x_m, layer.altitude_m.value_or(usual_m), layer.z_m}, 0.5 * layer.extent_m};
    }
    case ObjectKind::wake: {
      const scene::WakeScene& wake = scene.ocean.wakes[object.index];
      if (wake.centre != scene::WakeCentre::place) return {};
      const scene::ElementIndex element{object.index, 0};
      return Sphere{
          {scene::MovingNumber(scene, {"ocean.wake.x_m", element}, wake.x_m).at(time_s), scene.sea_level_m(),
           scene::MovingNumber(scene, {"ocean.wake.z_m", element}, wake.z_m).at(time_s)},
          0.5 * wake.parameters.length_m};
    }
    case ObjectKind::bookmark:
      return Sphere{scene.bookmarks[object.index].camera.eye_m, 0.0};
    default:
      return {};
  }
}

void pull_place(Scene& scene, const SceneObject& object, const Sphere& held, const ObjectPull& pull) {
  const scene::ElementIndex element{object.index, 0};
  const auto push = [&](const char* key, double way_m) { push_value(scene, key, element, way_m); };
  switch (object.kind) {
    case ObjectKind::cloud_layer: {
      scene::CloudLayerScene& layer = scene.cloud_layers[object.index];
      push("cloud_layer.x_m", pull.way_m.x);
      push("cloud_layer.z_m", pull.way_m.z);
      if (pull.way_m.y != 0.0)
        layer.altitude_m = within_range("cloud_layer.y_m", held.centre_m.y + pull.way_m.y);
      layer.extent_m = within_range("cloud_layer.extent_m", pull.ratio * layer.extent_m);
      break;
    }
    case ObjectKind::wake: {
      double& length_m = scene.ocean.wakes[object.index].parameters.length_m;
      push("ocean.wake.x_m", pull.way_m.x);
      push("ocean.wake.z_m", pull.way_m.z);
      length_m = within_range("ocean.wake.length_m", pull.ratio * length_m);
      break;
    }
    case ObjectKind::bookmark:
      push("bookmark.x_m", pull.way_m.x);
      push("bookmark.y_m", pull.way_m.y);
      push("bookmark.z_m", pull.way_m.z);
      // It grows clockwise, seen from above.
      turn_value(scene, "bookmark.yaw_deg", element, -pull.turn_rad.y);
      break;
    default:
      push("light.x_m", pull.way_m.x);
      push("light.y_m", pull.way_m.y);
      push("light.z_m", pull.way_m.z);
  }
}

void aim_light(Scene& scene, std::size_t light, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec2 before = azimuth_and_elevation(from), after = azimuth_and_elevation(to);
  turn_value(scene, "light.azimuth_deg", {light, 0}, way_between(before.x, after.x));
  push_value(scene, "light.elevation_deg", {light, 0}, after.y - before.y);
}

}  // namespace offing::present
