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
  std::vector<SymmetricTensor> edge_tensors;  ///< angle * length * e e^T, e the unit edge; convex positive
};

SurfaceMeasures measure_surface(const UnitMesh& mesh, int threads);

/// The angle between the faces of an edge, positive where convex; 0 unless it has two, both with areas. Faces
/// that disagree which side is out are measured as if the second were turned over.
double edge_angle(const UnitMesh& mesh, const std::vector<glm::dvec3>& face_normals, std::uint32_t edge);

}  // namespace offing::mesh_tools
