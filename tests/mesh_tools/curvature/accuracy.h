#pragma once

#include <string>
#include <vector>

#include "host/mesh_shapes/shape.h"
#include "mesh_tools/curvature/curvature.h"

namespace offing::test {

/// How far measured curvatures are from true ones, in the mean over vertices.
struct CurvatureErrors {
  double curvature = 0.0;  ///< |difference| / max |true curvature of the vertex|, mean over both curvatures
  double direction_deg =
      0.0;  ///< of e_max as a line, where the true curvatures differ by a tenth of the larger or more
};

CurvatureErrors errors_of(const VertexCurvatures& measured, const VertexCurvatures& truth);

/// The meshes on which methods are compared: an ellipsoid, a torus, the same with noise, an open saddle;
/// vertices move along the surface and diagonals are random.
struct NamedShape {
  std::string name;
  mesh_shapes::Shape shape;
};
NamedShape jittered_ellipsoid();
NamedShape jittered_torus();
NamedShape noisy_torus();
NamedShape jittered_saddle();
std::vector<NamedShape> comparison_shapes();

}  // namespace offing::test
