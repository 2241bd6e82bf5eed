#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "host/highlights/search/highlight_surface.h"

namespace offing::highlights {

/// A place on a surface: a face and the weights of its corners, >= 0, their sum is 1.
struct SurfacePlace {
  std::uint32_t face = 0;
  glm::dvec3 weights{1.0, 0.0, 0.0};

  bool operator==(const SurfacePlace&) const = default;
};

/// Where it is, in metres.
glm::dvec3 position_at(const HighlightSurface& surface, const SurfacePlace& place);

/// The unit normal there, interpolated as the search for highlights does; that of the face where the corners'
/// cancel out.
glm::dvec3 normal_at(const HighlightSurface& surface, const SurfacePlace& place);

/// The place of a face nearest to a point.
SurfacePlace place_of_face_near(const HighlightSurface& surface, std::uint32_t face,
                                const glm::dvec3& point_m);

/// The place of the whole surface at rest nearest to a point, on the first of faces that are equally near.
/// Looks at every face: for what an artist sets, not for each frame. Throws Error(bad_input) for a surface
/// without faces.
SurfacePlace nearest_place(const HighlightSurface& surface, const glm::dvec3& point_m);

/// Where a point is that goes with its nearest place, as the surface deforms.
glm::dvec3 carried(const HighlightSurface& surface, const SurfacePlace& nearest, const glm::dvec3& point_m);
/// The other way: of a point near a place, where it is on the surface at rest.
glm::dvec3 at_rest(const HighlightSurface& surface, const SurfacePlace& nearest, const glm::dvec3& point_m);

}  // namespace offing::highlights
