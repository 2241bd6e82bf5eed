#include "present/passes/camera_projection.h"

#include <algorithm>
#include <cmath>

namespace offing::present {

glm::dmat4 clip_from_eye(const Camera& camera, bool has_clip_control) {
  glm::dmat4 matrix = projection(camera, near_m) * view_rotation(camera);
  if (!has_clip_control) {
    // OpenGL then maps depth from -1 ... 1: z' = 2 z - w.
    for (int column = 0; column < 4; ++column) {
      matrix[column][2] = 2.0 * matrix[column][2] - matrix[column][3];
    }
  }
  return matrix;
}

glsl::ViewUniforms view_uniforms(const Camera& camera) {
  const CameraBasis axes = basis(camera);
  const glm::dvec2 extent = half_extent(camera);
  glsl::ViewUniforms view{};
  view.ray_forward = axes.forward;
  view.near_m = static_cast<float>(near_m);
  view.ray_right = extent.x * axes.right;
  view.eye_height_m = static_cast<float>(camera.eye_m.y);
  view.ray_up = extent.y * axes.up;
  return view;
}

Camera scaled_camera(Camera camera, double scale) {
  const auto scaled = [scale](int side_px) {
    return std::max(1, static_cast<int>(std::lround(side_px * scale)));
  };
  camera.width_px = scaled(camera.width_px);
  camera.height_px = scaled(camera.height_px);
  return camera;
}

}  // namespace offing::present
