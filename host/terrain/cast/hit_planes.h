#pragma once

#include <cstddef>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "kernels/shared/terrain.h"

namespace offing::terrain {

/// Distances and steps of hits, for pictures.
class HitPlanes {
 public:
  static constexpr std::size_t plane_count = 2;

  /// Throws what programs throw.
  explicit HitPlanes(const ocl::Device& device);

  /// Enqueues distances_m [count] of the first `count` hits along their unit rays, +inf where they miss, and
  /// their steps into the second of planes [2][count]. EdgeDistances writes the first. Throws
  /// Error(bad_usage) for buffers that hold fewer.
  void at(const ocl::Buffer<TerrainHit>& hits, std::size_t count, ocl::Buffer<float>& distances_m,
          ocl::Buffer<float>& planes) const;

 private:
  ocl::Kernel kernel_;
};

}  // namespace offing::terrain
