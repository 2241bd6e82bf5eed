#pragma once

#include <algorithm>
#include <cstdint>

#include <glm/vec3.hpp>

#include "host/base/mesh_neighbours.h"
#include "host/base/tangent_plane.h"

/// How a surface bends at a vertex, and what methods that sum tensors of edges share.
namespace offing::mesh_tools {

/// What a method says of one vertex, in units of the mesh's scale; all 0 where it has nothing to say.
struct VertexBend {
  double k_max = 0.0, k_min = 0.0;
  glm::dvec3 e_max{}, e_min{}, normal{};  ///< unit, e_max x e_min = normal
};

/// From the mean tensor of edges about a vertex: an angle is stored on edges along the axis of bending, so
/// that the larger eigenvalue's own direction is that of the smaller curvature (H2).
inline VertexBend bend_of_tensor(const SymmetricTensor& mean, const glm::dvec3& normal) {
  const TangentEigen eigen = tangent_eigen(mean, normal);
  return {eigen.larger, eigen.smaller, eigen.of_smaller, -eigen.of_larger, normal};
}

/// Where the edges of a mean tensor lie about the vertex: the mean square of the distance along e_max and
/// e_min.
struct Spread {
  double along_max = 0.0, along_min = 0.0;
};

/// Edges away from the vertex lean out of its tangent plane, so that a part of them is lost there: at x along
/// e, whose normal curvature is k, they lean by k x and lose k^2 x^2. Edges along e carry the other
/// curvature.
inline void straighten(VertexBend& bend, const Spread& spread) {
  constexpr double most = 0.25;  // where it is larger, the region is no small part of the surface
  const double max_loss = std::min(most, spread.along_min * bend.k_min * bend.k_min);
  const double min_loss = std::min(most, spread.along_max * bend.k_max * bend.k_max);
  // Capped losses could turn the order round.
  const double k_max = bend.k_max * (1.0 + max_loss), k_min = bend.k_min * (1.0 + min_loss);
  if (k_max >= k_min) bend.k_max = k_max, bend.k_min = k_min;
}

/// What a face or vertex with an edge that does not bend (on a border, or where three faces meet) counts
/// beside others: it misses a part of its tensor, but is better than nothing.
inline constexpr double border_weight = 1e-6;

inline bool has_two_faces(const MeshNeighbours& mesh, std::uint32_t edge) {
  return mesh.edge_faces.begin[edge + 1] - mesh.edge_faces.begin[edge] == 2;
}

}  // namespace offing::mesh_tools
