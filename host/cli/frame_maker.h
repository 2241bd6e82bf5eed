#pragma once

#include <optional>

#include "host/cli/bake_settings.h"
#include "host/cli/baked_frame.h"
#include "host/cli/gerstner_layer.h"
#include "host/ocean/ocean.h"
#include "host/ocl/device.h"
#include "host/scene/sea.h"

namespace offing::cli {

/// What a frame takes of host memory.
std::size_t frame_bytes(const BakeSettings& settings, int size, std::size_t cascades);

/// Simulates frames on one device; confined to one thread.
class FrameMaker {
 public:
  /// Throws what Ocean throws, and Error(out_of_memory) where the frames that are on their way at once do not
  /// fit beside it into host memory.
  FrameMaker(const ocl::Device& device, const scene::Sea& sea, const BakeSettings& settings);

  BakedFrame make(int frame);

 private:
  GridMesh make_mesh();

  const BakeSettings& settings_;
  ocean::Ocean ocean_;
  std::optional<GerstnerLayer> gerstner_;  // where the waves are included and there are any
};

}  // namespace offing::cli
