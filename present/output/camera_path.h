#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "host/highlights/tracks/highlight_tracks.h"
#include "host/scene/model/ocean_scene.h"
#include "host/world/ground_view.h"

namespace offing::present {

/// Whether a scene's camera has keyframes.
bool has_camera_path(const scene::OceanScene& scene);

/// Gives a scene the camera's keyframes of another one, in the stead of its own.
void take_camera_path(const scene::OceanScene& from, scene::OceanScene& to);

/// What makes the highlights of a recording, at any time: the scene's lamps and its eye, or one that has left
/// its path and stands there. The ground must stay.
highlights::LightingAt recorded_lighting(const scene::OceanScene& scene, const world::GroundView* ground,
                                         const std::optional<glm::dvec3>& eye_m);

}  // namespace offing::present
