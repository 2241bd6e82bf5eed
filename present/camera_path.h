#pragma once

#include "host/scene/ocean_scene.h"

namespace offing::present {

/// Whether a scene's camera has keyframes.
bool has_camera_path(const scene::OceanScene& scene);

/// Gives a scene the camera's keyframes of another one, in the stead of its own.
void take_camera_path(const scene::OceanScene& from, scene::OceanScene& to);

}  // namespace offing::present
