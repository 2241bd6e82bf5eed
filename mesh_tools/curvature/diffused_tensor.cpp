#include <array>

#include <glm/geometric.hpp>

#include "host/base/parallel_chunks.h"
#include "mesh_tools/curvature/methods.h"

namespace offing::mesh_tools {
namespace {

/// What bends about a vertex: the six parts of the tensor; how much surface that is; nothing, which fills a
/// line of the cache. All are averaged alike.
struct alignas(64) Share {
  std::array<double, 8> parts{};

  Share& operator+=(const Share& other) {
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i] += other.parts[i];
    return *this;
  }
  Share& operator*=(double factor) {
    for (double& part : parts) part *= factor;
    return *this;
  }
};

/// An edge's angle belongs half to either end, a face's area by thirds to its corners.
Share own_share(const UnitMesh& mesh, const SurfaceMeasures& measures, std::size_t vertex) {
  SymmetricTensor tensor;
  for (const std::uint32_t edge : mesh.neighbours.vertex_edges.row(vertex))
    tensor += measures.edge_tensors[edge];
  tensor = 0.5 * tensor;
  Share share{{tensor.xx, tensor.xy, tensor.xz, tensor.yy, tensor.yz, tensor.zz, measures.areas[vertex]}};
  return share *= mesh.on_border[vertex] != 0 ? border_weight : 1.0;
}

/// A round moves six parts of seven by an edge; at first, edges reach to their middles.
Spread spread_about(const UnitMesh& mesh, std::size_t vertex, const VertexBend& bend, int rounds) {
  const auto neighbours = mesh.neighbours.neighbours_of(vertex);
  Spread spread;
  for (const std::uint32_t neighbour : neighbours) {
    const glm::dvec3 along = mesh.positions[neighbour] - mesh.positions[vertex];
    const double x = glm::dot(along, bend.e_max), y = glm::dot(along, bend.e_min);
    spread.along_max += x * x;
    spread.along_min += y * y;
  }
  const double steps = (0.25 + rounds * 6.0 / 7.0) / static_cast<double>(neighbours.size());
  return {steps * spread.along_max, steps * spread.along_min};
}

}  // namespace

// In a round of averaging each vertex gives its share away in equal parts, to its neighbours and itself:
// nothing is lost, so that no edge counts for more than another because of how many its ends have.
std::vector<VertexBend> diffused_tensor_bends(const UnitMesh& mesh, const SurfaceMeasures& measures,
                                              int rounds, int threads) {
  const std::size_t vertices = mesh.vertex_count();
  std::vector<Share> shares(vertices), next(rounds > 0 ? vertices : 0);
  // Shares are kept divided already; the quotient of tensor and area is the same.
  const auto divide = [&](Share& share, std::size_t vertex) {
    share *= 1.0 / static_cast<double>(mesh.neighbours.neighbours_of(vertex).size() + 1);
  };
  parallel_for(vertices, threads, [&](std::size_t vertex) {
    shares[vertex] = own_share(mesh, measures, vertex);
    divide(shares[vertex], vertex);
  });
  for (int round = 0; round < rounds; ++round) {
    parallel_for(vertices, threads, [&](std::size_t vertex) {
      Share sum = shares[vertex];
      for (const std::uint32_t neighbour : mesh.neighbours.neighbours_of(vertex)) sum += shares[neighbour];
      divide(sum, vertex);
      next[vertex] = sum;
    });
    shares.swap(next);
  }
  std::vector<VertexBend> bends(vertices);
  parallel_for(vertices, threads, [&](std::size_t vertex) {
    const Share& share = shares[vertex];
    const auto& [xx, xy, xz, yy, yz, zz, area, nothing] = share.parts;
    if (!(area > 0.0)) return;
    bends[vertex] =
        bend_of_tensor((1.0 / area) * SymmetricTensor{xx, xy, xz, yy, yz, zz}, measures.normals[vertex]);
    straighten(bends[vertex], spread_about(mesh, vertex, bends[vertex], rounds));
  });
  return bends;
}

}  // namespace offing::mesh_tools
