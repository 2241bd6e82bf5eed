#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh_tools/curvature/curvature.h"
#include "mesh_tools/curvature/surface_measures.h"
#include "mesh_tools/curvature/unit_mesh.h"

namespace offing::mesh_tools {

/// What a method says of one vertex, in units of the mesh's scale; all 0 where it has nothing to say.
struct VertexBend {
  double k_max = 0.0, k_min = 0.0;
  glm::dvec3 e_max{}, e_min{}, normal{};  ///< unit, e_max x e_min = normal
};

/// Takes what a method says of each vertex straight into a result: a list in between would be written and
/// read once more, which costs as much as the fastest method.
class BendSink {
 public:
  /// Gives the result its size. All three are kept.
  BendSink(const UnitMesh& mesh, const SurfaceMeasures& measures, CurvatureResult& result);

  /// Once for every vertex, from any thread. What is not finite counts as nothing said.
  void put(std::size_t vertex, const VertexBend& bend) const {
    VertexCurvatures& curvatures = result_.curvatures;
    curvatures.area_m2[vertex] = measures_.areas[vertex] * mesh_.scale_m * mesh_.scale_m;
    if (!is_sound(bend)) {
      if (measures_.normals[vertex] != glm::dvec3(0.0)) result_.normals[vertex] = measures_.normals[vertex];
      return;
    }
    curvatures.k_max_per_m[vertex] = bend.k_max / mesh_.scale_m;
    curvatures.k_min_per_m[vertex] = bend.k_min / mesh_.scale_m;
    curvatures.e_max[vertex] = bend.e_max;
    curvatures.e_min[vertex] = bend.e_min;
    curvatures.confidence[vertex] = confidence_of(vertex, bend);
    result_.normals[vertex] = bend.normal;
  }

  /// Vertices that another one stands for get what it got. After all put().
  void finish(int threads) const;

 private:
  static bool is_sound(const VertexBend& bend) {
    const double sum =
        bend.k_max + bend.k_min + glm::dot(bend.e_max, bend.e_max) + glm::dot(bend.normal, bend.normal);
    return std::isfinite(sum) && bend.normal != glm::dvec3(0.0);
  }
  /// How much one direction is preferred: 0 where all bend alike, 1 where one does not bend at all or bends
  /// the other way.
  double confidence_of(std::size_t vertex, const VertexBend& bend) const {
    constexpr double border_share = 0.5;
    const double sum = std::abs(bend.k_max) + std::abs(bend.k_min) + flat_bend_;
    return (bend.k_max - bend.k_min) / sum * (mesh_.on_border[vertex] != 0 ? border_share : 1.0);
  }

  const UnitMesh& mesh_;
  const SurfaceMeasures& measures_;
  CurvatureResult& result_;
  double flat_bend_;  // over an edge, less than this is rounding: a plane has no direction
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

/// The angles of the edges about each vertex and how much surface that is, averaged with its neighbours.
class DiffusedTensor {
 public:
  /// Keeps mesh and measures.
  DiffusedTensor(const UnitMesh& mesh, const SurfaceMeasures& measures, int rounds, int threads);

  VertexBend bend_at(std::size_t vertex) const;

 private:
  /// Six parts of the tensor, and the area; nothing, which fills a line of the cache. All are averaged alike.
  struct alignas(64) Share {
    std::array<double, 8> parts;

    Share& operator+=(const Share& other) {
      for (std::size_t i = 0; i < parts.size(); ++i) parts[i] += other.parts[i];
      return *this;
    }
    Share& operator*=(double factor) {
      for (double& part : parts) part *= factor;
      return *this;
    }
  };

  Share own_share(std::size_t vertex) const;
  Spread spread_about(std::size_t vertex, const VertexBend& bend) const;

  const UnitMesh& mesh_;
  const SurfaceMeasures& measures_;
  int rounds_;
  std::unique_ptr<Share[]> shares_;  // [vertices]
};

/// Put all vertices of the mesh. The radius is in units of the mesh's scale.
void ball_tensor_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, double radius, int threads,
                       const BendSink& sink);
void clipped_tensor_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, double radius, int threads,
                          const BendSink& sink);
void printed_tensor_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, double radius,
                          EdgeAngles angles, int threads, const BendSink& sink);
void diffused_tensor_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, int rounds, int threads,
                           const BendSink& sink);
void fitted_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, double radius, int threads,
                  const BendSink& sink);
void jet_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, int threads, const BendSink& sink);

}  // namespace offing::mesh_tools
