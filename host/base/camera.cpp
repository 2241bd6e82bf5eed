#include "host/base/camera.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing {
namespace {

// Rounding of an angle given in degrees is no reason to refuse straight up.
constexpr double angle_tolerance_rad = 1e-9;

void require(bool is_valid, const char* name, double found, const char* expected) {
  if (is_valid) return;
  throw Error(ErrorKind::bad_input, fmt::format("camera.{}: expected {}, found {:g}", name, expected, found),
              fmt::format("set {} to {}", name, expected));
}

}  // namespace

void require_valid(const Camera& camera) {
  for (const double coordinate_m : {camera.eye_m.x, camera.eye_m.y, camera.eye_m.z}) {
    require(std::isfinite(coordinate_m), "eye_m", coordinate_m, "finite coordinates");
  }
  require(std::isfinite(camera.yaw_rad), "yaw_rad", camera.yaw_rad, "a finite angle");
  require(std::isfinite(camera.roll_rad), "roll_rad", camera.roll_rad, "a finite angle");
  require(std::abs(camera.pitch_rad) <= std::numbers::pi / 2.0 + angle_tolerance_rad, "pitch_rad",
          camera.pitch_rad, "-pi/2 ... pi/2");
  require(camera.vertical_field_of_view_rad > 0.0 && camera.vertical_field_of_view_rad < std::numbers::pi,
          "vertical_field_of_view_rad", camera.vertical_field_of_view_rad, "more than 0 and less than pi");
  require(camera.width_px >= 1, "width_px", camera.width_px, "at least 1");
  require(camera.height_px >= 1, "height_px", camera.height_px, "at least 1");
}

Camera above_level(Camera camera, double level_m) {
  camera.eye_m.y -= level_m;
  return camera;
}

Camera mirrored(const Camera& camera, double plane_m) {
  Camera image = camera;
  image.eye_m.y = 2.0 * plane_m - camera.eye_m.y;
  image.pitch_rad = -camera.pitch_rad;
  image.roll_rad = -camera.roll_rad;
  return image;
}

CameraBasis basis(const Camera& camera) {
  const double cos_yaw = std::cos(camera.yaw_rad), sin_yaw = std::sin(camera.yaw_rad);
  const double cos_pitch = std::cos(camera.pitch_rad), sin_pitch = std::sin(camera.pitch_rad);
  const double cos_roll = std::cos(camera.roll_rad), sin_roll = std::sin(camera.roll_rad);
  const glm::dvec3 level_right(cos_yaw, 0.0, sin_yaw);
  const glm::dvec3 level_up(-sin_yaw * sin_pitch, cos_pitch, cos_yaw * sin_pitch);
  return {cos_roll * level_right - sin_roll * level_up, cos_roll * level_up + sin_roll * level_right,
          glm::dvec3(sin_yaw * cos_pitch, sin_pitch, -cos_yaw * cos_pitch)};
}

glm::dvec2 half_extent(const Camera& camera) {
  const double half_height = std::tan(0.5 * camera.vertical_field_of_view_rad);
  return {half_height * camera.width_px / camera.height_px, half_height};
}

glm::dvec3 ray_direction(const Camera& camera, glm::dvec2 clip) {
  const CameraBasis axes = basis(camera);
  const glm::dvec2 extent = half_extent(camera);
  return axes.forward + clip.x * extent.x * axes.right + clip.y * extent.y * axes.up;
}

glm::dmat4 view_rotation(const Camera& camera) {
  const CameraBasis axes = basis(camera);
  glm::dmat4 rotation(1.0);  // column-major
  for (int axis = 0; axis < 3; ++axis) {
    rotation[axis] = glm::dvec4(axes.right[axis], axes.up[axis], -axes.forward[axis], 0.0);
  }
  return rotation;
}

glm::dmat4 projection(const Camera& camera, double near_m) {
  require(std::isfinite(near_m) && near_m > 0.0, "near_m", near_m, "a finite distance above 0");
  const glm::dvec2 extent = half_extent(camera);
  glm::dmat4 matrix(0.0);
  matrix[0][0] = 1.0 / extent.x;
  matrix[1][1] = 1.0 / extent.y;
  matrix[2][3] = -1.0;
  matrix[3][2] = near_m;
  return matrix;
}

}  // namespace offing
