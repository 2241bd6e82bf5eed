#include "present/free_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offing::present {
namespace {

constexpr double start_speed_mps = 10.0;
constexpr double slowest_mps = 0.1, fastest_mps = 1000.0;
constexpr double wheel_factor = 1.25;
constexpr double fast_factor = 5.0, slow_factor = 0.2;
// Of the highest eye above the mean water and of pitches, as the scene file allows them.
constexpr double lowest_eye_m = 0.2, highest_eye_m = 50e3;
constexpr double steepest_rad = 0.5 * std::numbers::pi;

}  // namespace

FreeCamera::FreeCamera(const Camera& start) : start_(start), camera_(start), speed_mps_(start_speed_mps) {}

void FreeCamera::advance(const CameraInput& input, double seconds) {
  speed_mps_ = std::clamp(speed_mps_ * std::pow(wheel_factor, input.wheel), slowest_mps, fastest_mps);

  // The picture follows the mouse: a pixel of it turns by the angle of a pixel.
  const double pixel_rad = camera_.vertical_field_of_view_rad / camera_.height_px;
  camera_.yaw_rad = std::remainder(camera_.yaw_rad + input.turn_px.x * pixel_rad, 2.0 * std::numbers::pi);
  camera_.pitch_rad =
      std::clamp(camera_.pitch_rad - input.turn_px.y * pixel_rad, -steepest_rad, steepest_rad);

  const double factor = (input.is_fast ? fast_factor : 1.0) * (input.is_slow ? slow_factor : 1.0);
  const CameraBasis axes = basis(camera_);
  const glm::dvec3 velocity =
      input.move.x * axes.right + glm::dvec3(0.0, input.move.y, 0.0) + input.move.z * axes.forward;
  camera_.eye_m += velocity * (speed_mps_ * factor * seconds);
  camera_.eye_m.y = std::clamp(camera_.eye_m.y, lowest_eye_m, highest_eye_m);
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
