#include "present/editing/terrain_pick.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace offing::present {

std::optional<TerrainPick> pick_terrain(world::WorldTerrain& terrain, const Camera& camera, glm::dvec2 clip) {
  TerrainPick pick{
      .ray = {.origin_m = camera.eye_m, .direction = glm::normalize(ray_direction(camera, clip))}};
  const terrain::RayHit hit = terrain.cast(pick.ray);
  if (hit.kind == TERRAIN_MISS) return std::nullopt;
  pick.distance_m = hit.distance_m;
  pick.place_m = pick.ray.origin_m + pick.distance_m * pick.ray.direction;
  if (terrain.field()) pick.nodes = terrain::nodes_on_ray(*terrain.field(), pick.ray, pick.distance_m);
  return pick;
}

}  // namespace offing::present
