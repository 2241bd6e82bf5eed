#include "mesh_tools/curvature/diffused_tensor.h"

#include <glm/geometric.hpp>

#include "host/base/parallel_for.h"
#include "mesh_tools/curvature/bend_sink.h"

namespace offing::mesh_tools {

// An edge's angle belongs half to either end, a face's area by thirds to its corners. The share is divided
// already by those that it will be given to: the quotient of tensor and area is the same.
DiffusedTensor::Share DiffusedTensor::own_share(std::size_t vertex) const {
  const auto edges = mesh_.neighbours.vertex_edges.row(vertex);
  const auto others = mesh_.neighbours.neighbours_of(vertex);
  const glm::dvec3 middle = mesh_.positions[vertex];
  SymmetricTensor tensor;
  for (std::size_t i = 0; i < edges.size(); ++i)
    tensor += outer_square(0.5 * measures_.edge_bends[edges[i]], mesh_.positions[others[i]] - middle);
  Share share{
      {tensor.xx, tensor.xy, tensor.xz, tensor.yy, tensor.yz, tensor.zz, measures_.areas[vertex], 0.0}};
  const double weight = mesh_.on_border[vertex] != 0 ? border_weight : 1.0;
  return share *= weight / static_cast<double>(edges.size() + 1);
}

// In a round of averaging each vertex gives its share away in equal parts, to its neighbours and itself:
// nothing is lost, so that no edge counts for more than another because of how many its ends have.
DiffusedTensor::DiffusedTensor(const UnitMesh& mesh, const SurfaceMeasures& measures, int rounds, int threads)
    : mesh_(mesh),
      measures_(measures),
      rounds_(rounds),
      shares_(std::make_unique_for_overwrite<Share[]>(mesh.vertex_count())) {
  const std::size_t vertices = mesh.vertex_count();
  parallel_for(vertices, threads, [&](std::size_t vertex) { shares_[vertex] = own_share(vertex); });
  auto next = std::make_unique_for_overwrite<Share[]>(rounds > 0 ? vertices : 0);
  for (int round = 0; round < rounds; ++round) {
    parallel_for(vertices, threads, [&](std::size_t vertex) {
      const auto others = mesh_.neighbours.neighbours_of(vertex);
      Share sum = shares_[vertex];
      for (const std::uint32_t other : others) sum += shares_[other];
      next[vertex] = sum *= 1.0 / static_cast<double>(others.size() + 1);
    });
    shares_.swap(next);
  }
}

// A round moves six parts of seven by an edge; at first, edges reach to their middles.
Spread DiffusedTensor::spread_about(std::size_t vertex, const VertexBend& bend) const {
  const auto others = mesh_.neighbours.neighbours_of(vertex);
  Spread spread;
  for (const std::uint32_t other : others) {
    const glm::dvec3 along = mesh_.positions[other] - mesh_.positions[vertex];
    const double x = glm::dot(along, bend.e_max), y = glm::dot(along, bend.e_min);
    spread.along_max += x * x;
    spread.along_min += y * y;
  }
  const double steps = (0.25 + rounds_ * 6.0 / 7.0) / static_cast<double>(others.size());
  return {steps * spread.along_max, steps * spread.along_min};
}

VertexBend DiffusedTensor::bend_at(std::size_t vertex) const {
  const auto& [xx, xy, xz, yy, yz, zz, area, nothing] = shares_[vertex].parts;
  if (!(area > 0.0)) return {};
  VertexBend bend =
      bend_of_tensor((1.0 / area) * SymmetricTensor{xx, xy, xz, yy, yz, zz}, measures_.normals[vertex]);
  straighten(bend, spread_about(vertex, bend));
  return bend;
}

void diffused_tensor_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, int rounds, int threads,
                           const BendSink& sink) {
  const DiffusedTensor tensor(mesh, measures, rounds, threads);
  parallel_for(mesh.vertex_count(), threads,
               [&](std::size_t vertex) { sink.put(vertex, tensor.bend_at(vertex)); });
}

}  // namespace offing::mesh_tools
