#include "present/editing/ground_pick.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace offing::present {

std::optional<GroundPick> pick_ground(world::GroundView& ground, const Camera& camera, glm::dvec2 clip) {
  GroundPick pick{
      .ray = {.origin_m = camera.eye_m, .direction = glm::normalize(ray_direction(camera, clip))}};
  const terrain::RayHit hit = ground.cast(pick.ray);
  if (hit.kind == TERRAIN_MISS) return std::nullopt;
  pick.distance_m = hit.distance_m;
  pick.place_m = pick.ray.origin_m + pick.distance_m * pick.ray.direction;
  if (ground.field()) pick.nodes = terrain::nodes_on_ray(*ground.field(), pick.ray, pick.distance_m);
  return pick;
}

}  // namespace offing::present
