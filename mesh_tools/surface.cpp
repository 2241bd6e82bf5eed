// SPDX-License-Identifier: GPL-3.0-or-later (CGAL)
#include "mesh_tools/surface.h"

#include <vector>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include "mesh_tools/mesh_defects.h"

namespace offing::mesh_tools {

Surface to_surface(const TriangleMesh& mesh, std::string_view file_name) {
  require_manifold(mesh, file_name);
  std::vector<Kernel::Point_3> points;
  points.reserve(mesh.positions_m.size());
  for (const glm::dvec3& p : mesh.positions_m) points.emplace_back(p.x, p.y, p.z);
  Surface surface;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, mesh.faces, surface);
  return surface;
}

TriangleMesh to_mesh(const Surface& surface) {
  TriangleMesh mesh;
  std::vector<std::uint32_t> numbers(surface.num_vertices());  // those that are removed included
  for (const Surface::Vertex_index vertex : surface.vertices()) {
    numbers[vertex] = static_cast<std::uint32_t>(mesh.positions_m.size());
    const Kernel::Point_3& point = surface.point(vertex);
    mesh.positions_m.emplace_back(point.x(), point.y(), point.z());
  }
  for (const Surface::Face_index face : surface.faces()) {
    TriangleIndices corners{};
    std::size_t i = 0;
    for (const Surface::Vertex_index vertex : surface.vertices_around_face(surface.halfedge(face))) {
      corners[i++] = numbers[vertex];
    }
    mesh.faces.push_back(corners);
  }
  return mesh;
}

}  // namespace offing::mesh_tools
