#pragma once

#include <glm/mat4x4.hpp>

#include "host/base/camera.h"

namespace offing::present {

/// From coordinates relative to the eye, in the world's axes, to those of the screen, with the near plane at
/// near_m; where the driver has no clip control, so that OpenGL makes the same depth of them.
glm::dmat4 clip_from_eye(const Camera& camera, bool has_clip_control);

}  // namespace offing::present
