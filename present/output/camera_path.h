#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "host/highlights/tracks/highlight_tracker.h"
#include "host/scene/model/scene.h"
#include "host/world/world_terrain.h"

namespace offing::present {

/// Whether keyframes of this value are the camera's.
bool is_of_camera(const scene::ValueKey& value);
/// Whether a scene's camera has keyframes.
bool has_camera_path(const scene::Scene& scene);

/// Gives a scene the camera's keyframes of another one, in the stead of its own.
void take_camera_path(const scene::Scene& from, scene::Scene& to);

/// What makes the highlights of a recording, at any time: the scene's lights and its eye, or one that has
/// left its path and stands there. The ground must stay.
highlights::LightingAt recorded_lighting(const scene::Scene& scene, const world::WorldTerrain* terrain,
                                         const std::optional<glm::dvec3>& eye_m);

}  // namespace offing::present
