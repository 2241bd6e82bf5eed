#include "mesh_tools/curvature/unit_mesh.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/base/mesh_neighbours.h"

namespace offing::mesh_tools {
namespace {

// Areas and curvatures of such meshes are still finite numbers.
constexpr double largest_extent_m = 1e100, smallest_extent_m = 1e-100;

void require_finite(const std::vector<glm::dvec3>& positions_m) {
  for (std::size_t i = 0; i < positions_m.size(); ++i) {
    const glm::dvec3& p = positions_m[i];
    // A sum is finite only if all of it is, or nearly as large as numbers get.
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    throw Error(
        ErrorKind::bad_input,
        fmt::format("mesh: vertex {}: expected finite coordinates, found ({}, {}, {})", i, p.x, p.y, p.z),
        "export the mesh again from the program that made it");
  }
}

}  // namespace

UnitMesh unit_mesh(const TriangleMesh& mesh) {
  require_finite(mesh.positions_m);
  UnitMesh unit;
  glm::dvec3 low(0.0), high(0.0);
  for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
    low = i == 0 ? mesh.positions_m[i] : glm::min(low, mesh.positions_m[i]);
    high = i == 0 ? mesh.positions_m[i] : glm::max(high, mesh.positions_m[i]);
  }
  const glm::dvec3 extent = high - low;
  const double largest_m = std::max({extent.x, extent.y, extent.z});
  if (!(largest_m <= largest_extent_m)) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("mesh: expected an extent of at most {:g} m, found {:g} m", largest_extent_m, largest_m),
        "look for vertices that are far away");
  }
  unit.scale_m = std::max(largest_m, smallest_extent_m);
  unit.first = first_at_place(mesh.positions_m);
  unit.neighbours = mesh_neighbours(mesh.positions_m.size(), welded_faces(mesh.faces, unit.first));
  unit.positions.reserve(mesh.positions_m.size());
  for (const glm::dvec3& position_m : mesh.positions_m) {
    unit.positions.push_back((position_m - low) / unit.scale_m);
  }
  unit.on_border.assign(mesh.positions_m.size(), 0);
  for (std::size_t edge = 0; edge < unit.neighbours.edges.size(); ++edge) {
    if (unit.neighbours.edge_faces.row(edge).size() == 2) continue;
    for (const std::uint32_t end : unit.neighbours.edges[edge]) unit.on_border[end] = 1;
  }
  double sum = 0.0;
  for (const auto& [a, b] : unit.neighbours.edges) {
    sum += glm::distance(unit.positions[a], unit.positions[b]);
  }
  if (sum > 0.0) unit.mean_edge = sum / static_cast<double>(unit.neighbours.edges.size());
  return unit;
}

long long euler_characteristic(const MeshNeighbours& mesh) {
  long long vertices = 0, faces = 0;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) vertices += mesh.vertex_faces.row(i).empty() ? 0 : 1;
  for (const TriangleIndices& edges : mesh.face_edges) faces += edges[0] == MeshNeighbours::none ? 0 : 1;
  return vertices - static_cast<long long>(mesh.edges.size()) + faces;
}

}  // namespace offing::mesh_tools
