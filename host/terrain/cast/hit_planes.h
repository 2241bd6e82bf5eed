#pragma once

#include <cstddef>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "kernels/shared/terrain.h"

namespace offing::terrain {

/// What pictures show of hits beside their light, a plane each, as textures want them.
class HitPlanes {
 public:
  static constexpr std::size_t plane_count = 2;

  /// Throws what programs throw.
  explicit HitPlanes(const ocl::Device& device);

  /// Enqueues planes [2][count] of the first `count` hits: distance along the unit ray, m, +inf where it
  /// misses; steps. Throws Error(bad_usage) for buffers that hold fewer.
  void at(const ocl::Buffer<TerrainHit>& hits, std::size_t count, ocl::Buffer<float>& planes) const;

 private:
  ocl::Kernel kernel_;
};

}  // namespace offing::terrain
