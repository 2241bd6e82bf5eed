#include "host/highlights/search/surface_place.h"

#include <limits>

#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/highlights/search/highlight_points.h"
#include "host/highlights/search/triangle_point.h"

namespace offing::highlights {
glm::dvec3 position_at(const HighlightSurface& surface, const SurfacePlace& place) {
  return place_on(surface, place.face, place.weights);
}

glm::dvec3 normal_at(const HighlightSurface& surface, const SurfacePlace& place) {
  const TriangleIndices& corners = surface.mesh().faces[place.face];
  const std::vector<glm::dvec3>& normals = surface.mesh().normals;
  const glm::dvec3 sum = place.weights.x * normals[corners[0]] + place.weights.y * normals[corners[1]] +
                         place.weights.z * normals[corners[2]];
  const double length = glm::length(sum);
  return length > 1e-9 ? sum / length : surface.face_normals()[place.face];
}

SurfacePlace place_of_face_near(const HighlightSurface& surface, std::uint32_t face,
                                const glm::dvec3& point_m) {
  const TriangleIndices& corners = surface.mesh().faces[face];
  const std::vector<glm::dvec3>& positions_m = surface.mesh().positions_m;
  return {face, nearest_weights(point_m, positions_m[corners[0]], positions_m[corners[1]],
                                positions_m[corners[2]])};
}

SurfacePlace nearest_place(const HighlightSurface& surface, const glm::dvec3& point_m) {
  const TriangleMesh& mesh = surface.mesh();
  if (mesh.faces.empty())
    throw Error(ErrorKind::bad_input, "highlights: expected a mesh with faces, found none",
                "pin highlights on meshes with faces only");
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    const TriangleIndices& corners = mesh.faces[face];
    const double found = squared_distance(point_m, mesh.positions_m[corners[0]], mesh.positions_m[corners[1]],
                                          mesh.positions_m[corners[2]]);
    if (found >= least) continue;
    least = found;
    nearest = face;
  }
  return place_of_face_near(surface, nearest, point_m);
}

}  // namespace offing::highlights
