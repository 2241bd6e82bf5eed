#include "present/output/camera_path.h"

#include <algorithm>
#include <string_view>

#include "host/scene/prepare/scene_meshes.h"

namespace offing::present {

bool is_of_camera(const scene::ValueKey& value) {
  return value.key.starts_with("camera.");
}

bool has_camera_path(const scene::Scene& scene) {
  return std::any_of(scene.tracks.begin(), scene.tracks.end(),
                     [](const auto& track) { return is_of_camera(track.first); });
}

void take_camera_path(const scene::Scene& from, scene::Scene& to) {
  std::erase_if(to.tracks, [](const auto& track) { return is_of_camera(track.first); });
  for (const auto& [value, track] : from.tracks) {
    if (is_of_camera(value)) to.tracks.emplace(value, track);
  }
}

highlights::LightingAt recorded_lighting(const scene::Scene& scene, const world::WorldTerrain* terrain,
                                         const std::optional<glm::dvec3>& eye_m) {
  highlights::LightingAt lighting = scene::lighting_of(scene, terrain);
  if (!eye_m) return lighting;
  return [lighting, eye_m](double time_s) {
    highlights::Lighting there = lighting(time_s);
    there.eye.vector = *eye_m;
    return there;
  };
}

}  // namespace offing::present
