#include "host/base/parallel_chunks.h"
#include "mesh_tools/curvature/methods.h"

namespace offing::mesh_tools {
namespace {

/// What bends about a vertex and how much surface that is; both are averaged, and divided at the end.
struct Share {
  SymmetricTensor tensor;
  double area = 0.0;
};

void add(Share& sum, const Share& share) {
  sum.tensor += share.tensor;
  sum.area += share.area;
}

}  // namespace

// An edge's angle belongs half to either end, a face's area by thirds to its corners. In a round of averaging
// each vertex gives its share away in equal parts, to its neighbours and itself: nothing is lost, so that no
// edge counts for more than another because of how many its ends have.
std::vector<VertexBend> diffused_tensor_bends(const UnitMesh& mesh, const SurfaceMeasures& measures,
                                              int rounds, int threads) {
  const MeshNeighbours& neighbours = mesh.neighbours;
  const std::size_t vertices = mesh.vertex_count();
  std::vector<Share> shares(vertices), next(rounds > 0 ? vertices : 0);
  parallel_for(vertices, threads, [&](std::size_t vertex) {
    Share& share = shares[vertex];
    double weight = 1.0;
    for (const std::uint32_t edge : neighbours.vertex_edges.row(vertex)) {
      share.tensor += measures.edge_tensors[edge];
      if (!has_two_faces(neighbours, edge)) weight = border_weight;
    }
    share.tensor = (0.5 * weight) * share.tensor;
    share.area = weight * measures.areas[vertex];
  });
  for (int round = 0; round < rounds; ++round) {
    parallel_for(vertices, threads, [&](std::size_t vertex) {
      const double part = 1.0 / static_cast<double>(neighbours.vertex_edges.row(vertex).size() + 1);
      shares[vertex] = {part * shares[vertex].tensor, part * shares[vertex].area};
    });
    parallel_for(vertices, threads, [&](std::size_t vertex) {
      Share sum = shares[vertex];
      for (const std::uint32_t edge : neighbours.vertex_edges.row(vertex)) {
        const auto& [a, b] = neighbours.edges[edge];
        add(sum, shares[a == vertex ? b : a]);
      }
      next[vertex] = sum;
    });
    shares.swap(next);
  }
  std::vector<VertexBend> bends(vertices);
  parallel_for(vertices, threads, [&](std::size_t vertex) {
    const Share& share = shares[vertex];
    if (share.area > 0.0)
      bends[vertex] = bend_of_tensor((1.0 / share.area) * share.tensor, measures.normals[vertex], 0.0);
  });
  return bends;
}

}  // namespace offing::mesh_tools
