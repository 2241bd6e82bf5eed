#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/base/camera.h"
#include "host/terrain/cast/nodes_on_ray.h"
#include "host/world/world_terrain.h"

namespace offing::present {

/// A ray through a point of a picture, and the ground that it hit.
struct TerrainPick {
  terrain::Ray ray;
  double distance_m = 0.0;
  glm::dvec3 place_m{0.0};                   ///< of the hit
  std::vector<terrain::RayNode> nodes = {};  ///< that the ray met on its way; none of maps in tiles
};

/// Through a point of the picture in clip coordinates; nothing where there is sky. Waits for the device.
/// Throws Error(bad_input) for an eye from which no rays reach the map.
std::optional<TerrainPick> pick_terrain(world::WorldTerrain& terrain, const Camera& camera, glm::dvec2 clip);

}  // namespace offing::present
