#include "host/bodies/pressed_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/bodies/hull.h"

namespace offing::bodies {
namespace {

// A vertex looks so many columns along its normal, which takes it off its own wall.
constexpr double columns_off = 1.5;
constexpr int finest_grid = 64, coarsest_grid = 3;  // squares along the longest side

std::vector<glm::dvec3> normals_of(const TriangleMesh& mesh) {
  std::vector<glm::dvec3> normals(mesh.positions_m.size(), glm::dvec3(0.0));
  for (const TriangleIndices& face : mesh.faces) {
    const glm::dvec3& a = mesh.positions_m[face[0]];
    const glm::dvec3 twice = glm::cross(mesh.positions_m[face[1]] - a, mesh.positions_m[face[2]] - a);
    for (const std::uint32_t corner : face) normals[corner] += twice;
  }
  for (glm::dvec3& normal : normals) {
    const double length = glm::length(normal);
    if (length > 0.0) normal /= length;
  }
  return normals;
}

/// The rim above vertices that face what an open boat holds, their own height for others.
double covered_height_m(const HullMap& map, const glm::dvec3& place_m, const glm::dvec3& normal) {
  const glm::dvec3 off_m =
      place_m +
      columns_off * normal * glm::dvec3(map.cell_x_m, std::min(map.cell_x_m, map.cell_z_m), map.cell_z_m);
  const auto column = static_cast<int>(std::lround((off_m.x - map.low_x_m) / map.cell_x_m));
  const auto row = static_cast<int>(std::lround((off_m.z - map.low_z_m) / map.cell_z_m));
  if (column < 0 || column >= HullMap::columns || row < 0 || row >= HullMap::rows) return place_m.y;
  const std::size_t at = static_cast<std::size_t>(row) * HullMap::columns + static_cast<std::size_t>(column);
  const bool is_inside =
      off_m.y > static_cast<double>(map.top_m[at]) && off_m.y < static_cast<double>(map.rim_m[at]);
  return is_inside ? static_cast<double>(map.rim_m[at]) : place_m.y;
}

void cover(const HullMap& map, TriangleMesh& mesh) {
  const std::vector<glm::dvec3> normals = normals_of(mesh);
  for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
    mesh.positions_m[i].y = covered_height_m(map, mesh.positions_m[i], normals[i]);
  }
}

/// The mean of the vertices in each square of a grid, and the faces that are left (Rossignac & Borrel 1993).
/// A closed surface stays closed: what collapses has no edges left.
TriangleMesh clustered(const TriangleMesh& mesh, int squares) {
  const Extent extent = extent_of(mesh);
  const glm::dvec3 size_m = extent.high_m - extent.low_m;
  const double side_m = std::max({size_m.x, size_m.y, size_m.z}) / squares;
  std::map<std::array<int, 3>, std::uint32_t> known;
  std::vector<std::uint32_t> cluster_of;
  std::vector<int> members;
  TriangleMesh coarse;
  for (const glm::dvec3& place_m : mesh.positions_m) {
    const glm::dvec3 square = glm::floor((place_m - extent.low_m) / side_m);
    const auto [found, is_new] = known.try_emplace(
        {static_cast<int>(square.x), static_cast<int>(square.y), static_cast<int>(square.z)},
        static_cast<std::uint32_t>(coarse.positions_m.size()));
    if (is_new) {
      coarse.positions_m.emplace_back(0.0);
      members.push_back(0);
    }
    coarse.positions_m[found->second] += place_m;
    ++members[found->second];
    cluster_of.push_back(found->second);
  }
  for (std::size_t i = 0; i < members.size(); ++i) coarse.positions_m[i] /= members[i];
  for (const TriangleIndices& face : mesh.faces) {
    const TriangleIndices kept{cluster_of[face[0]], cluster_of[face[1]], cluster_of[face[2]]};
    if (kept[0] != kept[1] && kept[1] != kept[2] && kept[2] != kept[0]) coarse.faces.push_back(kept);
  }
  return coarse;
}

}  // namespace

TriangleMesh pressed_hull(const TriangleMesh& mesh, const HullMap& map, std::size_t most_faces) {
  TriangleMesh hull;
  hull.positions_m = mesh.positions_m;
  hull.faces = mesh.faces;
  if (is_open(map)) cover(map, hull);
  if (hull.faces.size() <= most_faces) return hull;
  const Enclosed whole = enclosed_by(hull);
  TriangleMesh coarse;
  for (int squares = finest_grid; squares >= coarsest_grid; --squares) {
    coarse = clustered(hull, squares);
    if (coarse.faces.size() <= most_faces) break;
  }
  const double volume_m3 = enclosed_by(coarse).volume_m3;
  if (!(volume_m3 > 0.0)) return hull;
  const double breadth = std::sqrt(whole.volume_m3 / volume_m3);
  for (glm::dvec3& place_m : coarse.positions_m) {
    place_m.x = whole.centre_m.x + breadth * (place_m.x - whole.centre_m.x);
    place_m.z = whole.centre_m.z + breadth * (place_m.z - whole.centre_m.z);
  }
  return coarse;
}

}  // namespace offing::bodies
