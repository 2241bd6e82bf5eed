#include "host/highlights/search/nearest_face.h"

#include "host/highlights/search/triangle_point.h"

namespace offing::highlights {
std::uint32_t nearest_face(const HighlightSurface& surface, std::uint32_t face, const glm::dvec3& point_m) {
  const TriangleMesh& mesh = surface.mesh();
  const auto distance2 = [&](std::uint32_t f) {
    const TriangleIndices& corners = mesh.faces[f];
    return squared_distance(point_m, mesh.positions_m[corners[0]], mesh.positions_m[corners[1]],
                            mesh.positions_m[corners[2]]);
  };
  double least = distance2(face);
  for (bool has_moved = true; has_moved;) {
    has_moved = false;
    const TriangleIndices corners = mesh.faces[face];
    for (const std::uint32_t corner : corners) {
      for (const std::uint32_t other : surface.links().faces_at(surface.links().place_of(corner))) {
        const double found = distance2(other);
        if (found >= least) continue;
        least = found;
        face = other;
        has_moved = true;
      }
    }
  }
  return face;
}

}  // namespace offing::highlights
