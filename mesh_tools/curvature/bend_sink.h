#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh_tools/curvature/curvature.h"
#include "mesh_tools/curvature/surface_measures.h"
#include "mesh_tools/curvature/unit_mesh.h"
#include "mesh_tools/curvature/vertex_bend.h"

/// Where methods put what they find, and the methods.
namespace offing::mesh_tools {

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

/// Put all vertices of the mesh. The radius is in units of the mesh's scale.
void ball_tensor_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, double radius, int threads,
                       const BendSink& sink);
void clipped_tensor_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, double radius, int threads,
                          const BendSink& sink);
void printed_tensor_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, double radius,
                          EdgeAngles angles, int threads, const BendSink& sink);
void diffused_tensor_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, int rounds, int threads,
                           const BendSink& sink);
/// Without a radius, it is 3.5 edges, or wider where the mesh is noisy.
void fitted_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, std::optional<double> radius,
                  int threads, const BendSink& sink);
void jet_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, int threads, const BendSink& sink);

}  // namespace offing::mesh_tools
