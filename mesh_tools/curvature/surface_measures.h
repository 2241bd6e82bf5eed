#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "host/base/tangent_plane.h"
#include "mesh_tools/curvature/unit_mesh.h"

namespace offing::mesh_tools {

/// What can be said of the faces, edges and vertices of a mesh one by one, in units of its scale.
struct SurfaceMeasures {
  std::vector<glm::dvec3> face_normals;  ///< unit; 0 without an area
  std::vector<double> face_areas;        ///< 0 for faces that are in no list
  std::vector<glm::dvec3>
      normals;                ///< of vertices: the mean of the faces around by area; unit, 0 without any
  std::vector<double> areas;  ///< of vertices: a third of the faces around
  /// Angle / length of edges, convex positive; 0 for those of other than two faces with areas.
  std::vector<double> edge_bends;
};

/// angle * length * e e^T of an edge, e its unit direction.
inline SymmetricTensor edge_tensor(const UnitMesh& mesh, const SurfaceMeasures& measures,
                                   std::uint32_t edge) {
  const auto& [from, to] = mesh.neighbours.edges[edge];
  return outer_square(measures.edge_bends[edge], mesh.positions[to] - mesh.positions[from]);
}

SurfaceMeasures measure_surface(const UnitMesh& mesh, int threads);

}  // namespace offing::mesh_tools
