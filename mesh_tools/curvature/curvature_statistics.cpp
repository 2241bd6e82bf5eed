#include "mesh_tools/curvature/curvature_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace offing::mesh_tools {
namespace {

/// Grows a range by a value of some area; `mean` is a sum until the end.
void grow(ValueRange& range, double value, double area_m2, bool is_first) {
  range.least = is_first ? value : std::min(range.least, value);
  range.largest = is_first ? value : std::max(range.largest, value);
  range.mean += value * area_m2;
}

/// The angles of all corners at a vertex.
double angle_around(const UnitMesh& mesh, std::uint32_t vertex) {
  double sum = 0.0;
  for (const std::uint32_t face : mesh.neighbours.vertex_faces.row(vertex)) {
    const TriangleIndices& corners = mesh.neighbours.faces[face];
    const std::size_t here = static_cast<std::size_t>(std::ranges::find(corners, vertex) - corners.begin());
    const glm::dvec3 a = mesh.positions[corners[(here + 1) % 3]] - mesh.positions[vertex];
    const glm::dvec3 b = mesh.positions[corners[(here + 2) % 3]] - mesh.positions[vertex];
    sum += std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  }
  return sum;
}

}  // namespace

CurvatureStatistics curvature_statistics(const UnitMesh& mesh, const VertexCurvatures& curvatures) {
  CurvatureStatistics statistics;
  GaussBonnet& gauss_bonnet = statistics.gauss_bonnet;
  for (std::uint32_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    if (mesh.neighbours.vertex_faces.row(vertex).empty()) continue;
    const double k_max = curvatures.k_max_per_m[vertex], k_min = curvatures.k_min_per_m[vertex];
    const double area_m2 = curvatures.area_m2[vertex];
    grow(statistics.k_max_per_m, k_max, area_m2, statistics.vertices == 0);
    grow(statistics.k_min_per_m, k_min, area_m2, statistics.vertices == 0);
    ++statistics.vertices;
    statistics.area_m2 += area_m2;
    gauss_bonnet.integral += k_max * k_min * area_m2;
    gauss_bonnet.absolute += std::abs(k_max * k_min) * area_m2;
    if (mesh.on_border[vertex] == 0) continue;
    ++statistics.border_vertices;
    gauss_bonnet.border_turning += std::numbers::pi - angle_around(mesh, vertex);
  }
  for (ValueRange* range : {&statistics.k_max_per_m, &statistics.k_min_per_m}) {
    range->mean = statistics.area_m2 > 0.0 ? range->mean / statistics.area_m2 : 0.0;
  }
  for (std::size_t edge = 0; edge < mesh.neighbours.edge_faces.rows(); ++edge) {
    if (mesh.neighbours.edge_faces.row(edge).size() > 2) statistics.is_manifold = false;
  }
  constexpr double turn = 2.0 * std::numbers::pi;
  gauss_bonnet.expected = turn * static_cast<double>(euler_characteristic(mesh.neighbours));
  gauss_bonnet.difference_share =
      (gauss_bonnet.integral + gauss_bonnet.border_turning - gauss_bonnet.expected) /
      std::max(gauss_bonnet.absolute, turn);
  return statistics;
}

}  // namespace offing::mesh_tools
