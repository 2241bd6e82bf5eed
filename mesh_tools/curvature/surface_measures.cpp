#include "mesh_tools/curvature/surface_measures.h"

#include <cmath>

#include "host/base/parallel_for.h"

namespace offing::mesh_tools {
namespace {

void measure_faces(const UnitMesh& mesh, int threads, SurfaceMeasures& measures) {
  const std::size_t faces = mesh.neighbours.faces.size();
  measures.face_normals.assign(faces, {});
  measures.face_areas.assign(faces, 0.0);
  parallel_for(faces, threads, [&](std::size_t face) {
    if (mesh.neighbours.face_edges[face][0] == MeshNeighbours::none) return;
    const auto& [a, b, c] = mesh.neighbours.faces[face];
    const glm::dvec3 across =
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    const double length = glm::length(across);
    if (!(length > 0.0)) return;
    measures.face_areas[face] = 0.5 * length;
    measures.face_normals[face] = across / length;
  });
}

void measure_vertices(const UnitMesh& mesh, int threads, SurfaceMeasures& measures) {
  measures.normals.assign(mesh.vertex_count(), {});
  measures.areas.assign(mesh.vertex_count(), 0.0);
  parallel_for(mesh.vertex_count(), threads, [&](std::size_t vertex) {
    glm::dvec3 sum(0.0), largest_normal(0.0);
    double area = 0.0, largest = 0.0;
    for (const std::uint32_t face : mesh.neighbours.vertex_faces.row(vertex)) {
      const double face_area = measures.face_areas[face];
      sum += face_area * measures.face_normals[face];
      area += face_area;
      if (face_area > largest) largest = face_area, largest_normal = measures.face_normals[face];
    }
    measures.areas[vertex] = area / 3.0;
    const double length = glm::length(sum);
    // Faces back to back cancel but for rounding: then one of them has to do.
    measures.normals[vertex] = length > 1e-12 * area ? sum / length : largest_normal;
  });
}

/// atan2, by its series where the angle is small, as nearly all are: half of it has the tangent t < 1/8, and
/// what the series leaves out is t^16 / 17 of it, less than a bit.
double angle_of(double sine, double cosine) {
  constexpr double largest = 0.125;
  const double t = sine / (1.0 + cosine), t2 = t * t;
  if (!(std::abs(t) < largest)) return std::atan2(sine, cosine);
  const double series =
      1.0 -
      t2 * (1.0 / 3 -
            t2 * (1.0 / 5 - t2 * (1.0 / 7 - t2 * (1.0 / 9 - t2 * (1.0 / 11 - t2 * (1.0 / 13 - t2 / 15))))));
  return 2.0 * t * series;
}

/// The angle between the faces of an edge by its length, positive where convex; 0 unless it has two, both
/// with areas. Faces that disagree which side is out are measured as if the second were turned over.
double edge_bend(const UnitMesh& mesh, const std::vector<glm::dvec3>& face_normals, std::uint32_t edge) {
  const auto faces = mesh.neighbours.edge_faces.row(edge);
  if (faces.size() != 2) return 0.0;
  const auto& [from, to] = mesh.neighbours.edges[edge];
  const glm::dvec3 along = mesh.positions[to] - mesh.positions[from];
  const double length = glm::length(along);
  if (!(length > 0.0)) return 0.0;
  const bool first_along = mesh.neighbours.runs_along(faces[0], edge);
  const bool agree = first_along != mesh.neighbours.runs_along(faces[1], edge);
  const glm::dvec3& first = face_normals[faces[0]];
  const glm::dvec3 second = agree ? face_normals[faces[1]] : -face_normals[faces[1]];
  // Seen along the edge, the face that runs along it lies to the left of the other.
  const double per_length = 1.0 / length;
  const double sine = glm::dot(glm::cross(first, second), along) * per_length;
  return angle_of(first_along ? sine : -sine, glm::dot(first, second)) * per_length;
}

}  // namespace

SurfaceMeasures measure_surface(const UnitMesh& mesh, int threads) {
  SurfaceMeasures measures;
  measure_faces(mesh, threads, measures);
  measure_vertices(mesh, threads, measures);
  measures.edge_bends.resize(mesh.neighbours.edges.size());
  parallel_for(mesh.neighbours.edges.size(), threads, [&](std::size_t edge) {
    measures.edge_bends[edge] = edge_bend(mesh, measures.face_normals, static_cast<std::uint32_t>(edge));
  });
  return measures;
}

}  // namespace offing::mesh_tools
