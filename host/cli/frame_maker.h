#pragma once

#include <vector>

#include "host/cli/bake_settings.h"
#include "host/io/grid_mesh.h"
#include "host/ocean/ocean.h"
#include "host/ocl/device.h"
#include "host/scene/sea.h"

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
  GridMesh mesh;  ///< all cascades together, over the longest patch; or empty
};

/// Simulates frames on one device; confined to one thread.
class FrameMaker {
 public:
  FrameMaker(const ocl::Device& device, const scene::Sea& sea, const BakeSettings& settings);

  BakedFrame make(int frame);

 private:
  GridMesh make_mesh();

  const BakeSettings& settings_;
  ocean::Ocean ocean_;
};

}  // namespace offing::cli
