#pragma once

#include <glm/vec3.hpp>

#include "host/highlights/search/surface_place.h"

namespace offing::highlights {

/// Seen along `normal`: a straight line over the surface from a place, by `length_m` >= 0 along `along`
/// (unit, across the normal), face by face. It ends early at a border and where faces look away from the
/// normal.
SurfacePlace line_end(const HighlightSurface& surface, const SurfacePlace& from, const glm::dvec3& along,
                      const glm::dvec3& normal, double length_m);

}  // namespace offing::highlights
