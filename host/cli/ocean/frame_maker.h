#pragma once

#include <optional>
#include <span>

#include "host/cli/ocean/bake_settings.h"
#include "host/cli/ocean/baked_frame.h"
#include "host/cli/ocean/gerstner_layer.h"
#include "host/ocean/surface/ocean.h"
#include "host/ocl/device.h"
#include "host/scene/prepare/sea.h"

namespace offing::cli {

/// What a frame takes of host memory.
std::size_t frame_bytes(const BakeSettings& settings, int size, std::size_t cascades);

/// What a maker's sea takes of its device's memory, to a tenth: waves, maps and past foam. Gerstner waves and
/// meshes take little beside them.
std::size_t sea_bytes(const BakeSettings& settings, const scene::Sea& sea);
/// Throws Error(out_of_memory) where a maker on each of these devices would need more host memory than is
/// free: for all frames that are on their way at once, and for the seas of devices that use the host's
/// memory.
void require_host_room(const BakeSettings& settings, const scene::Sea& sea,
                       std::span<const ocl::DeviceInfo> devices);

/// Simulates frames on one device; confined to one thread.
class FrameMaker {
 public:
  /// Throws what Ocean throws.
  FrameMaker(const ocl::Device& device, const scene::Sea& sea, const BakeSettings& settings);

  BakedFrame make(int frame);

 private:
  GridMesh make_mesh();

  const BakeSettings& settings_;
  ocean::Ocean ocean_;
  std::optional<GerstnerLayer> gerstner_;  // where the waves are included and there are any
};

}  // namespace offing::cli
