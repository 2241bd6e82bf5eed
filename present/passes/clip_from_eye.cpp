#include "present/passes/clip_from_eye.h"

#include "present/passes/view_depth.h"

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

}  // namespace offing::present
