#include "present/window/free_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "host/scene/schema/parameter_table.h"

namespace offing::present {
namespace {

constexpr double start_speed_mps = 10.0;
// Not in the water, which begins at its level for pictures, where a trough lies before the eye.
constexpr double above_level_m = 0.001;
constexpr double slowest_mps = 0.1, fastest_mps = 1000.0;
constexpr double wheel_factor = 1.25;
constexpr double fast_factor = 5.0, slow_factor = 0.2;
constexpr double clearance_m = 0.2;  // above water and ground
constexpr double steepest_rad = 0.5 * std::numbers::pi;

/// As the scene file allows them.
double within_range(std::string_view key, double value) {
  const scene::Parameter& row = *scene::find_parameter(key);
  return std::clamp(value, row.low, row.high);
}

}  // namespace

FreeCamera::FreeCamera(const Camera& start) : start_(start), camera_(start), speed_mps_(start_speed_mps) {}

void FreeCamera::look(const CameraInput& input) {
  // The picture follows the mouse, however many pixels it has.
  const glm::dvec2 turn_rad = camera_.vertical_field_of_view_rad * input.turn;
  camera_.yaw_rad = std::remainder(camera_.yaw_rad + turn_rad.x, 2.0 * std::numbers::pi);
  camera_.pitch_rad = std::clamp(camera_.pitch_rad - turn_rad.y, -steepest_rad, steepest_rad);
}

void FreeCamera::rise_above(double surface_m) {
  double& height_m = camera_.eye_m.y;
  height_m = within_range("camera.y_m",
                          std::max({height_m, surface_m + clearance_m, water_level_m_ + above_level_m}));
}

void FreeCamera::advance(const CameraInput& input, double seconds, const SurfaceHeight& surface_m) {
  speed_mps_ = std::clamp(speed_mps_ * std::pow(wheel_factor, input.wheel), slowest_mps, fastest_mps);
  look(input);
  if (input.move == glm::dvec3(0.0)) return;
  const double factor = (input.is_fast ? fast_factor : 1.0) * (input.is_slow ? slow_factor : 1.0);
  const CameraBasis axes = basis(camera_);
  const glm::dvec3 velocity =
      input.move.x * axes.right + glm::dvec3(0.0, input.move.y, 0.0) + input.move.z * axes.forward;
  glm::dvec3& eye_m = camera_.eye_m;
  eye_m += velocity * (speed_mps_ * factor * seconds);
  eye_m.x = within_range("camera.x_m", eye_m.x);
  eye_m.z = within_range("camera.z_m", eye_m.z);
  rise_above(surface_m(eye_m.x, eye_m.z));
}

void FreeCamera::look_at(const glm::dvec3& middle_m, double radius_m, const SurfaceHeight& surface_m,
                         const FreeWidth& free) {
  constexpr double least_radius_m = 0.5, room = 1.5, down_rad = 0.3;
  const glm::dvec2 extent = half_extent(camera_);
  const double sine = std::sin(std::atan(std::min(0.5 * (free.right - free.left) * extent.x, extent.y)));
  // What stands on the surface is seen from above, with the surface around it.
  if (middle_m.y - radius_m <= surface_m(middle_m.x, middle_m.z))
    camera_.pitch_rad = std::min(camera_.pitch_rad, -down_rad);
  glm::dvec3& eye_m = camera_.eye_m;
  eye_m = middle_m - room * std::max(radius_m, least_radius_m) / sine * basis(camera_).forward;
  eye_m.x = within_range("camera.x_m", eye_m.x);
  eye_m.z = within_range("camera.z_m", eye_m.z);
  rise_above(surface_m(eye_m.x, eye_m.z));
  const glm::dvec3 way_m = middle_m - eye_m;
  if (way_m == glm::dvec3(0.0)) return;
  camera_.yaw_rad = std::atan2(way_m.x, -way_m.z) - std::atan(0.5 * (free.left + free.right) * extent.x);
  camera_.pitch_rad = std::atan2(way_m.y, std::hypot(way_m.x, way_m.z));
}

void FreeCamera::reset() {
  place(start_);
  speed_mps_ = start_speed_mps;
}

void FreeCamera::place(const Camera& other) {
  const int width = camera_.width_px, height = camera_.height_px;
  camera_ = other;
  camera_.width_px = width;
  camera_.height_px = height;
}

}  // namespace offing::present
