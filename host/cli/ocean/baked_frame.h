#pragma once

#include <optional>
#include <vector>

#include "host/io/meshes/grid_mesh.h"
#include "host/ocean/surface/ocean.h"

namespace offing::cli {

/// One frame in host memory, as far as the settings ask for it.
struct BakedFrame {
  struct CascadeFields {
    ocean::SurfaceFields surface;
    std::vector<float> foam;         ///< [n][n], or empty
    ocean::VelocityFields velocity;  ///< at the settings' depth, or empty
  };
  int number = 0;
  double time_s = 0.0;
  std::vector<CascadeFields> cascades;
  /// The first cascade with the Gerstner waves, where they are to be included (GerstnerLayer).
  std::optional<CascadeFields> first_with_gerstner = {};
  GridMesh mesh;  ///< all cascades together, and included Gerstner waves, over the longest patch; or empty
};

}  // namespace offing::cli
