#pragma once

#include <glm/mat4x4.hpp>

#include "host/base/camera.h"
#include "present/passes/view_uniforms.h"

namespace offing::present {

/// Distance of the near plane along the line of sight. Depth is reversed: near_m over that distance, 1 there
/// and 0 at infinity.
inline constexpr double near_m = 0.05;

/// From coordinates relative to the eye, in the world's axes, to those of the screen, with the near plane at
/// near_m; where the driver has no clip control, so that OpenGL makes the same depth of them.
glm::dmat4 clip_from_eye(const Camera& camera, bool has_clip_control);

/// The uniforms of a camera's view. Haze and white stay 0.
glsl::ViewUniforms view_uniforms(const Camera& camera);

/// The same view on a picture so many times as wide and high, of at least a pixel.
Camera scaled_camera(Camera camera, double scale);

}  // namespace offing::present
