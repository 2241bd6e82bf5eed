#include "host/bodies/hull.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "host/base/error.h"
#include "host/base/mesh_neighbours.h"

namespace offing::bodies {
namespace {

/// Edges that two faces do not pass in opposite directions.
std::size_t open_edges(const TriangleMesh& mesh) {
  const MeshNeighbours around =
      mesh_neighbours(mesh.positions_m.size(), welded_faces(mesh.faces, first_at_place(mesh.positions_m)));
  std::size_t open = 0;
  for (std::uint32_t edge = 0; edge < around.edges.size(); ++edge) {
    int balance = 0;
    for (const std::uint32_t face : around.edge_faces.row(edge)) {
      balance += around.runs_along(face, edge) ? 1 : -1;
    }
    if (balance != 0) ++open;
  }
  return open;
}

}  // namespace

Extent extent_of(const TriangleMesh& mesh) {
  Extent extent{mesh.positions_m.front(), mesh.positions_m.front()};
  for (const glm::dvec3& place : mesh.positions_m) {
    extent.low_m = glm::min(extent.low_m, place);
    extent.high_m = glm::max(extent.high_m, place);
  }
  return extent;
}

Enclosed enclosed_by(const TriangleMesh& mesh) {
  // Tetrahedra from the mean of the vertices, so that no digits are lost far from the origin.
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& place : mesh.positions_m) middle += place;
  if (!mesh.positions_m.empty()) middle /= static_cast<double>(mesh.positions_m.size());

  double volume_m3 = 0.0;
  glm::dvec3 first(0.0);
  glm::dmat3 second(0.0);  // integral of r r^T
  for (const TriangleIndices& face : mesh.faces) {
    const glm::dvec3 a = mesh.positions_m[face[0]] - middle, b = mesh.positions_m[face[1]] - middle,
                     c = mesh.positions_m[face[2]] - middle;
    const double volume = glm::dot(a, glm::cross(b, c)) / 6.0;
    const glm::dvec3 sum = a + b + c;
    volume_m3 += volume;
    first += volume / 4.0 * sum;
    second += volume / 20.0 *
              (glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(c, c) +
               glm::outerProduct(sum, sum));
  }
  Enclosed result{.volume_m3 = volume_m3};
  if (volume_m3 == 0.0) return result;
  const glm::dvec3 centre = first / volume_m3;
  second -= volume_m3 * glm::outerProduct(centre, centre);
  const double trace = second[0][0] + second[1][1] + second[2][2];
  result.centre_m = middle + centre;
  result.inertia_m5 = glm::dmat3(trace) - second;
  return result;
}

void require_hull(const TriangleMesh& mesh, const char* subject) {
  if (mesh.faces.empty()) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: expected a closed mesh, found no faces", subject),
                "choose a mesh with faces");
  }
  if (const std::size_t open = open_edges(mesh); open > 0) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected a closed mesh, found {} edges that are open or turned", subject, open),
        "`offing-mesh check` shows where, `offing-mesh repair` closes small holes");
  }
  if (const double volume_m3 = enclosed_by(mesh).volume_m3; !(volume_m3 > 0.0)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected faces that point outward around a volume, found {:.3g} m3", subject,
                            volume_m3),
                "turn the faces: `offing-mesh repair IN -o OUT --outward`");
  }
}

}  // namespace offing::bodies
