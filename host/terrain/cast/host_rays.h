#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/terrain/cast/ray.h"

namespace offing::terrain {

/// Casts rays that lie in host memory, as many at a time as its buffers hold. Not safe for use from several
/// threads at once.
class HostRays {
 public:
  using Cast = std::function<void(const ocl::Buffer<TerrainRay>& rays, std::size_t count,
                                  ocl::Buffer<TerrainHit>& hits)>;

  /// What the rays hit; waits. `cast` enqueues what the first `count` rays hit. Throws what `cast` throws,
  /// and Error(out_of_memory) and Error(device).
  std::vector<RayHit> cast(const ocl::Device& device, const PostGrid& grid, std::span<const RayToBox> rays,
                           const Cast& cast);

 private:
  ocl::Buffer<TerrainRay> rays_;
  ocl::Buffer<TerrainHit> hits_;
};

}  // namespace offing::terrain
