#include "host/highlights/projectors/controlled_projector.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace offing::highlights {
namespace {

// A width at anisotropy 1 over that at 0.
constexpr double most_stretch = 4.0;

/// By how much an axis of a projector turns until its up goes up the surface. Where that is level there is no
/// such way: the turn fades out over the last 12 degrees.
double uprighting_rad(const Projector& projector, double upright) {
  constexpr double level = 0.2;
  const glm::dvec3 y(0.0, 1.0, 0.0), way_up = y - glm::dot(y, projector.normal) * projector.normal;
  const double turn_rad = std::atan2(-glm::dot(way_up, projector.right), glm::dot(way_up, projector.up));
  return upright * std::min(1.0, glm::length(way_up) / level) * turn_rad;
}

}  // namespace

Projector reshaped(const Projector& projector, const HighlightControls& controls) {
  Projector result = projector;
  const double evened = std::pow(projector.height_m / projector.width_m, 0.5 * controls.squareness);
  const double stretch = evened * std::pow(most_stretch, controls.anisotropy);
  result.width_m *= controls.scale * stretch;
  result.height_m *= controls.scale / stretch;
  const double turn_rad = controls.rotation_rad + uprighting_rad(projector, controls.upright);
  const double cosine = std::cos(turn_rad), sine = std::sin(turn_rad);
  result.right = cosine * projector.right + sine * projector.up;
  result.up = cosine * projector.up - sine * projector.right;
  return result;
}

PlacedProjector moved(const HighlightSurface& surface, const PlacedProjector& placed,
                      const glm::dvec2& way_m) {
  const double length_m = glm::length(way_m);
  if (!(length_m > 0.0)) return placed;
  PlacedProjector result = placed;
  Projector& projector = result.projector;
  const glm::dvec3 direction = (way_m.x * projector.right + way_m.y * projector.up) / length_m;
  const SurfaceWalk walk = walk_over(surface, placed.place, direction, length_m);
  projector.centre_m += walk.way_m;
  for (glm::dvec3* axis : {&projector.right, &projector.up, &projector.normal}) *axis = walk.rotation * *axis;
  result.place = walk.place;
  return result;
}

CopyPlace copy_place(const HighlightControls& controls, int copy) {
  const double copies = controls.split, pitch = 1.0 + controls.split_gap;
  const double width = 1.0 / (1.0 + (copies - 1.0) * pitch);
  return {(copy - 0.5 * (copies - 1.0)) * pitch * width, width};
}

}  // namespace offing::highlights
