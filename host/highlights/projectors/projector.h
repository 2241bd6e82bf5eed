#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/highlights/search/highlight_points.h"

namespace offing::highlights {

/// A box through which a highlight's texture is cast along the normal, without perspective (H4, H5, H7 of
/// docs/sources.md). Its axes are right-handed, as OpenGL has them, with the third one out of the surface:
/// right x up = normal, so that textures are not mirrored.
struct Projector {
  glm::dvec3 centre_m{0.0};
  glm::dvec3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, normal{0.0, 0.0, 1.0};
  double width_m = 1.0, height_m = 1.0;  ///< full, along right and up

  bool operator==(const Projector&) const = default;
};

/// What limits highlights where a surface is flat.
enum class FlatLimit {
  surface,     ///< where its normal has turned by twice the angle at the rim, whatever the triangles
  mean_edges,  ///< three mean edges, as printed (H5)
};

/// How large highlights are.
struct HighlightSize {
  double threshold = 0.95;    ///< N.H at the rim: 0 ... 1
  double cap_radius_m = 0.0;  ///< largest half width, for flat places; 0: as `flat_limit` says
  FlatLimit flat_limit = FlatLimit::surface;
};

/// Throws Error(bad_input) that names the value which is out of range.
void require_valid(const HighlightSize& size);

/// The same size with the cap that it has on a surface: it stays 0 for FlatLimit::surface.
HighlightSize with_cap(const HighlightSize& size, const HighlightSurface& surface);

/// Full width along a direction of this curvature: min(2 cap, 2 / |k| sqrt(1 - threshold^2)). No cap:
/// infinite where flat.
double width_m(double curvature_per_m, const HighlightSize& size);

/// The same at a point of a surface along a unit direction across its normal. Without a cap, each half ends
/// where the line over the surface has turned away by twice the angle at the rim, or after a quarter of the
/// diagonal; the width is that of both halves.
double width_along(const HighlightSurface& surface, const HighlightPoint& point, const glm::dvec3& direction,
                   const HighlightSize& size);

/// Curvature of a point along a unit direction across its normal (Euler).
double curvature_along(const HighlightPoint& point, const glm::dvec3& direction);

/// The projector of a point: right = e_max, up = e_min = normal x e_max. Throws Error(bad_input) for a size
/// out of range.
Projector projector_at(const HighlightSurface& surface, const HighlightPoint& point,
                       const HighlightSize& size);

/// Mesh space -> the projector's: the box is -1 ... 1 in x and y; z grows along the normal, in units of the
/// larger half width.
glm::dmat4 projection_of(const Projector& projector);

/// Texture coordinates of a point of the projector's space: (0, 0) is the upper left corner.
inline glm::dvec2 texture_place(const glm::dvec3& q) {
  return {(q.x + 1.0) / 2.0, (1.0 - q.y) / 2.0};
}

}  // namespace offing::highlights
