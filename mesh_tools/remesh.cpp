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

double edge_length_for(const TriangleMesh& mesh, double faces) {
  double area_m2 = 0.0;
  for (const TriangleIndices& face : mesh.faces) {
    const glm::dvec3 &a = mesh.positions_m[face[0]], &b = mesh.positions_m[face[1]],
                     &c = mesh.positions_m[face[2]];
    area_m2 += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  // Area of an equilateral triangle: sqrt(3)/4 of its edge's square.
  return std::sqrt(4.0 / std::numbers::sqrt3 * area_m2 / faces);
}

}  // namespace offing::mesh_tools
