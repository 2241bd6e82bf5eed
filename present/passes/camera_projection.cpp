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

void set_view_rays(const ShaderProgram& program, const Camera& camera) {
  const CameraBasis axes = basis(camera);
  const glm::dvec2 extent = half_extent(camera);
  program.set("ray_forward", glm::vec3(axes.forward));
  program.set("ray_right", glm::vec3(extent.x * axes.right));
  program.set("ray_up", glm::vec3(extent.y * axes.up));
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
