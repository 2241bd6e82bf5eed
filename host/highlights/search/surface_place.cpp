#include "host/highlights/search/surface_place.h"

#include <limits>

#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/highlights/search/highlight_points.h"
#include "host/highlights/search/triangle_point.h"

namespace offing::highlights {
namespace {

glm::dvec3 way_from_rest(const HighlightSurface& surface, const SurfacePlace& place) {
  if (surface.revision() == 0) return glm::dvec3(0.0);
  const std::vector<glm::dvec3>& at_rest_m = surface.positions_at_rest_m();
  const auto& [a, b, c] = surface.mesh().faces[place.face];
  return position_at(surface, place) -
         (place.weights.x * at_rest_m[a] + place.weights.y * at_rest_m[b] + place.weights.z * at_rest_m[c]);
}

}  // namespace

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
  const std::vector<TriangleIndices>& faces = surface.mesh().faces;
  const std::vector<glm::dvec3>& at_rest_m = surface.positions_at_rest_m();
  if (faces.empty())
    throw Error(ErrorKind::bad_input, "highlights: expected a mesh with faces, found none",
                "pin highlights on meshes with faces only");
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t face = 0; face < faces.size(); ++face) {
    const auto& [a, b, c] = faces[face];
    const double found = squared_distance(point_m, at_rest_m[a], at_rest_m[b], at_rest_m[c]);
    if (found >= least) continue;
    least = found;
    nearest = face;
  }
  const auto& [a, b, c] = faces[nearest];
  return {nearest, nearest_weights(point_m, at_rest_m[a], at_rest_m[b], at_rest_m[c])};
}

glm::dvec3 carried(const HighlightSurface& surface, const SurfacePlace& nearest, const glm::dvec3& point_m) {
  return point_m + way_from_rest(surface, nearest);
}

glm::dvec3 at_rest(const HighlightSurface& surface, const SurfacePlace& nearest, const glm::dvec3& point_m) {
  return point_m - way_from_rest(surface, nearest);
}

}  // namespace offing::highlights
