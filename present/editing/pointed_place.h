#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "present/editing/handle_geometry.h"
#include "present/passes/live_sea.h"

namespace offing::present {

/// How far before the eye things go where a picture shows no place for them.
inline constexpr double ahead_m = 30.0;

/// The ground or the still water that a point of a picture shows.
struct SurfacePlace {
  glm::dvec3 place_m{0.0};  ///< world
  bool is_water = false;
};
/// In clip coordinates; nothing where it shows neither.
std::optional<SurfacePlace> seen_surface(LiveSea& sea, const Screen& screen, glm::dvec2 clip);

/// Where something is put that is dropped on a picture, world, m: on the ground or the still water that a
/// point of it shows, in clip coordinates; where that is farther away than a kilometre, or sky, 30 m before
/// the eye. At the origin where there is neither ground nor sea, as there meshes stand alone.
glm::dvec3 pointed_place(LiveSea& sea, const Screen& screen, glm::dvec2 clip);

}  // namespace offing::present
