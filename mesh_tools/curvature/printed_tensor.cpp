#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "host/base/parallel_for.h"
#include "mesh_tools/curvature/bend_sink.h"
#include "mesh_tools/curvature/vertex_region.h"

namespace offing::mesh_tools {
namespace {

/// H2 as printed: the eigenvector of the eigenvalue smallest in magnitude is the normal, turned outward; of
/// the other two, each has the other's direction.
VertexBend printed_bend(const SymmetricTensor& mean, const glm::dvec3& outward) {
  Eigen::Matrix3d matrix;
  matrix << mean.xx, mean.xy, mean.xz, mean.xy, mean.yy, mean.yz, mean.xz, mean.yz, mean.zz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  const auto vector = [&](int i) {
    const Eigen::Vector3d column = solver.eigenvectors().col(i);
    return glm::dvec3(column.x(), column.y(), column.z());
  };
  // Eigenvalues ascend.
  std::array<int, 3> order{0, 1, 2};
  std::ranges::stable_sort(order, {}, [&](int i) { return std::abs(solver.eigenvalues()[i]); });
  glm::dvec3 normal = vector(order[0]);
  if (glm::dot(normal, outward) < 0.0) normal = -normal;
  const auto [smaller, larger] = std::minmax(order[1], order[2]);
  const glm::dvec3 e_max = vector(smaller);
  return {solver.eigenvalues()[larger], solver.eigenvalues()[smaller], e_max, glm::cross(normal, e_max),
          normal};
}

}  // namespace

void printed_tensor_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, double radius,
                          EdgeAngles angles, int threads, const BendSink& sink) {
  parallel_chunks(mesh.vertex_count(), threads, [&](ChunkQueue& queue) {
    Region region(mesh);
    std::vector<std::uint32_t> edge_marks(mesh.neighbours.edges.size(), MeshNeighbours::none);
    queue.drain([&](std::size_t vertex) {
      SymmetricTensor tensor;
      double area = 0.0;
      region.grow(
          static_cast<std::uint32_t>(vertex),
          [&](std::uint32_t face) {
            area += measures.face_areas[face];
            for (const std::uint32_t edge : mesh.neighbours.face_edges[face]) {
              if (edge_marks[edge] == vertex) continue;
              edge_marks[edge] = static_cast<std::uint32_t>(vertex);
              const bool is_turned =
                  angles == EdgeAngles::unsigned_as_printed && measures.edge_bends[edge] < 0.0;
              tensor += (is_turned ? -1.0 : 1.0) * edge_tensor(mesh, measures, edge);
            }
            return true;
          },
          [&](std::uint32_t corner, bool) {
            return glm::distance(mesh.positions[corner], mesh.positions[vertex]) < radius;
          });
      sink.put(vertex,
               area > 0.0 ? printed_bend((1.0 / area) * tensor, measures.normals[vertex]) : VertexBend{});
    });
  });
}

}  // namespace offing::mesh_tools
