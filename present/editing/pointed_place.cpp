#include "present/editing/pointed_place.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "present/editing/terrain_pick.h"

namespace offing::present {
namespace {

constexpr double farthest_m = 1000.0;

}  // namespace

std::optional<SurfacePlace> seen_surface(LiveSea& sea, const Screen& screen, glm::dvec2 clip) {
  std::optional<SurfacePlace> seen;
  if (sea.scene().has_sea()) {
    if (const auto place_m = on_plane(ray_at(screen, clip), {0.0, sea.sea_level_m(), 0.0}, {0.0, 1.0, 0.0}))
      seen = {*place_m, true};
  }
  if (sea.terrain() == nullptr || !sea.terrain()->is_in_reach()) return seen;
  const glm::dvec3& eye_m = screen.camera.eye_m;
  const std::optional<TerrainPick> terrain = pick_terrain(*sea.terrain(), screen.camera, clip);
  const bool is_before =
      terrain && (!seen || glm::distance(terrain->place_m, eye_m) < glm::distance(seen->place_m, eye_m));
  if (is_before) {
    const auto lake_m = sea.terrain()->water_before(terrain->ray, terrain->distance_m);
    seen = {lake_m.value_or(terrain->place_m), false};
  }
  return seen;
}

glm::dvec3 pointed_place(LiveSea& sea, const Screen& screen, glm::dvec2 clip) {
  if (!sea.scene().has_sea() && sea.terrain() == nullptr) return glm::dvec3(0.0);
  const glm::dvec3& eye_m = screen.camera.eye_m;
  const std::optional<SurfacePlace> pointed = seen_surface(sea, screen, clip);
  if (pointed && glm::distance(pointed->place_m, eye_m) < farthest_m) return pointed->place_m;
  const double yaw_rad = screen.camera.yaw_rad;
  const glm::dvec3 before_m = eye_m + ahead_m * glm::dvec3(std::sin(yaw_rad), 0.0, -std::cos(yaw_rad));
  const auto terrain_m =
      sea.terrain() != nullptr ? sea.terrain()->surface_m(before_m.x, before_m.z) : std::nullopt;
  const double water_m = sea.scene().has_sea() ? sea.sea_level_m() : -std::numeric_limits<double>::infinity();
  const double height_m = std::max(terrain_m.value_or(water_m), water_m);
  return {before_m.x, std::isfinite(height_m) ? height_m : 0.0, before_m.z};
}

}  // namespace offing::present
