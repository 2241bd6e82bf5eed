#include "host/highlights/nearest_face.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace offing::highlights {
namespace {

double squared_distance_to_edge(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a, way = p - a;
  const double length2 = glm::dot(along, along);
  const double share = length2 > 0.0 ? std::clamp(glm::dot(way, along) / length2, 0.0, 1.0) : 0.0;
  const glm::dvec3 rest = way - share * along;
  return glm::dot(rest, rest);
}

}  // namespace

double squared_distance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double area2 = glm::dot(normal, normal);
  const bool is_above = area2 > 0.0 && glm::dot(glm::cross(b - a, p - a), normal) >= 0.0 &&
                        glm::dot(glm::cross(c - b, p - b), normal) >= 0.0 &&
                        glm::dot(glm::cross(a - c, p - c), normal) >= 0.0;
  if (is_above) {
    const double height = glm::dot(p - a, normal);
    return height * height / area2;
  }
  return std::min({squared_distance_to_edge(p, a, b), squared_distance_to_edge(p, b, c),
                   squared_distance_to_edge(p, c, a)});
}

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
