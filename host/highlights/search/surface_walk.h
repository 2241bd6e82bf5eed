#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "host/highlights/search/surface_place.h"

namespace offing::highlights {

/// Where a walk over a surface ended, and how what went along was turned.
struct SurfaceWalk {
  SurfacePlace place;
  glm::dvec3 way_m{0.0};     ///< from where it began
  glm::dmat3 rotation{1.0};  ///< takes the normal there to the normal here, without a twist on the way
};

/// Goes straight on over a surface from a place, `length_m` >= 0 along `direction` (unit, projected onto the
/// plane across the normal). As normals are interpolated, vertices and edges do not bend the way: where it
/// ends depends continuously on where and how it begins. It is the same both ways: from the end, against
/// the carried direction, it leads back to the start (1e-9 of the length). It ends early at a border and
/// where the surface folds away by more than about 80 degrees. The length is that of sixteen chords: short
/// by a^2 / 6144 of itself where the normal turns by a radians in all.
SurfaceWalk walk_over(const HighlightSurface& surface, const SurfacePlace& from, const glm::dvec3& direction,
                      double length_m);

/// How far a line from a place goes over the surface, seen along the normal there, until the normal has
/// turned away so that both have this cosine, or until the surface folds away: at most `most_m`. A border
/// ends no line. Between places where it crosses edges, cosines are interpolated.
double facing_length_m(const HighlightSurface& surface, const SurfacePlace& from, const glm::dvec3& direction,
                       double least_cosine, double most_m);

}  // namespace offing::highlights
