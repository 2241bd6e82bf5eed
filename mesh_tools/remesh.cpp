// SPDX-License-Identifier: GPL-3.0-or-later (CGAL)
#include "mesh_tools/remesh.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <glm/geometric.hpp>

#include "host/base/progress.h"
#include "mesh_tools/surface.h"

namespace offing::mesh_tools {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;

constexpr double equilateral_area = std::numbers::sqrt3 / 4.0;  // of an edge of 1

double area_m2_of(const TriangleMesh& mesh) {
  double area_m2 = 0.0;
  for (const TriangleIndices& face : mesh.faces) {
    const glm::dvec3& origin = mesh.positions_m[face[0]];
    const glm::dvec3 a = mesh.positions_m[face[1]] - origin, b = mesh.positions_m[face[2]] - origin;
    area_m2 += 0.5 * glm::length(glm::cross(a, b));
  }
  return area_m2;
}

}  // namespace

TriangleMesh remesh(const TriangleMesh& mesh, std::string_view file_name, const RemeshSettings& settings,
                    const CancelToken& cancel, Verbosity verbosity) {
  Surface surface = to_surface(mesh, file_name);
  const auto is_sharp = surface.add_property_map<Surface::Edge_index, bool>("e:is_sharp", false).first;
  if (settings.sharp_rad) {
    pmp::detect_sharp_edges(surface, *settings.sharp_rad * 180.0 / std::numbers::pi, is_sharp);
  }
  Progress progress(settings.rounds, "rounds", verbosity);
  for (int round = 0; round < settings.rounds; ++round) {
    cancel.throw_if_cancelled();
    pmp::isotropic_remeshing(CGAL::faces(surface), settings.edge_m, surface,
                             CGAL::parameters::number_of_iterations(1).edge_is_constrained_map(is_sharp));
    progress.advance();
  }
  return to_mesh(surface);
}

double most_faces_at(const TriangleMesh& mesh, double edge_m) {
  double edges_m = 0.0;
  for (const TriangleIndices& face : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges_m += glm::distance(mesh.positions_m[face[i]], mesh.positions_m[face[(i + 1) % 3]]);
    }
  }
  return area_m2_of(mesh) / (equilateral_area * edge_m * edge_m) + edges_m / edge_m;
}

double edge_length_for(const TriangleMesh& mesh, double faces) {
  return std::sqrt(area_m2_of(mesh) / (equilateral_area * faces));
}

}  // namespace offing::mesh_tools
