#pragma once

#include <cstddef>

#include "mesh_tools/curvature/curvature.h"
#include "mesh_tools/curvature/unit_mesh.h"

namespace offing::mesh_tools {

struct ValueRange {
  double least = 0.0, mean = 0.0, largest = 0.0;  ///< mean by area
};

/// Gauss and Bonnet: over a surface and along its border, curvature adds up to 2 pi times Euler's
/// characteristic.
struct GaussBonnet {
  double integral = 0.0;        ///< sum of k_max k_min area
  double absolute = 0.0;        ///< sum of |k_max k_min| area
  double border_turning = 0.0;  ///< sum over border vertices of pi - the angles of the corners there
  double expected = 0.0;        ///< 2 pi times vertices - edges + faces
  /// How far the first and the third are from the fourth, as a part of the larger of the absolute integral
  /// and 2 pi.
  double difference_share = 0.0;
};

struct CurvatureStatistics {
  std::size_t vertices = 0;         ///< places with faces around
  std::size_t border_vertices = 0;  ///< of these, with an edge of other than two faces
  bool is_manifold = true;          ///< no edge has three faces or more: Gauss and Bonnet hold
  double area_m2 = 0.0;
  ValueRange k_max_per_m, k_min_per_m;
  GaussBonnet gauss_bonnet;
};

/// Vertices at one place count once. Where edges have three faces or more there is no theorem; the numbers
/// are given all the same.
CurvatureStatistics curvature_statistics(const UnitMesh& mesh, const VertexCurvatures& curvatures);

}  // namespace offing::mesh_tools
