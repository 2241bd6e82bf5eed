#include "host/highlights/surface_place.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/highlights/highlight_points.h"
#include "host/highlights/nearest_face.h"

namespace offing::highlights {
namespace {

/// How far along from a to b the point of the edge nearest to p is: 0 ... 1.
double share_of_edge(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a;
  const double length2 = glm::dot(along, along);
  return length2 > 0.0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
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
  const auto corner = [&](std::size_t i) -> const glm::dvec3& {
    return surface.mesh().positions_m[corners[i]];
  };
  const glm::dvec3 normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
  const double area2 = glm::dot(normal, normal);
  if (area2 > 0.0) {
    const auto weight = [&](std::size_t a, std::size_t b) {
      return glm::dot(glm::cross(corner(b) - corner(a), point_m - corner(a)), normal) / area2;
    };
    const glm::dvec3 weights(weight(1, 2), weight(2, 0), weight(0, 1));
    if (std::min({weights.x, weights.y, weights.z}) >= 0.0)
      return {face, weights / (weights.x + weights.y + weights.z)};
  }
  SurfacePlace nearest{.face = face};
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    const double share = share_of_edge(point_m, corner(a), corner(b));
    const double distance_m = glm::distance(point_m, corner(a) + share * (corner(b) - corner(a)));
    if (distance_m >= least_m) continue;
    least_m = distance_m;
    nearest.weights = glm::dvec3(0.0);
    nearest.weights[static_cast<int>(a)] = 1.0 - share;
    nearest.weights[static_cast<int>(b)] = share;
  }
  return nearest;
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
