#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "host/base/camera.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/terrain/lakes/lake.h"
#include "kernels/shared/lakes.h"
#include "kernels/shared/terrain.h"

namespace offing::terrain {

class HeightField;
class TiledField;

/// What a lake looks like at one time, from one place.
struct LakeLook {
  LakeWater water{};  ///< ripples and colours; LakeLayer fills in the rest
  std::vector<LakeWave> waves;
};

/// Lakes on a device, as kernels/terrain/lakes draws them over the ground that rays hit.
class LakeLayer {
 public:
  /// Throws what programs and buffers throw. One lake at least.
  LakeLayer(const ocl::Device& device, const std::vector<std::shared_ptr<const Lake>>& lakes);

  /// Sets what they look like from now on, in their order.
  void set_looks(std::span<const LakeLook> looks);

  int count() const { return static_cast<int>(boxes_.size()); }
  const ocl::Buffer<LakeWater>& waters() const { return waters_; }
  const ocl::Buffer<std::uint8_t>& cells() const { return cells_; }
  const ocl::Buffer<LakeWave>& waves() const { return waves_; }

  /// Replaces the distances of a camera's hits [height_px][width_px] by those of lakes in front; enqueued.
  void stand_before(const HeightField& field, const Camera& camera, const ocl::Buffer<TerrainHit>& hits,
                    ocl::Buffer<float>& distances_m) const;
  /// The same with the tiles of the field's last look().
  void stand_before(const TiledField& field, const Camera& camera, const ocl::Buffer<TerrainHit>& hits,
                    ocl::Buffer<float>& distances_m) const;

 private:
  void stand_before(const TerrainField& field, const TerrainView& view, const ocl::Buffer<TerrainHit>& hits,
                    ocl::Buffer<float>& distances_m) const;

  ocl::Device device_;
  ocl::Kernel planes_kernel_;
  std::vector<LakeWater> boxes_;  // with level and box alone
  ocl::Buffer<LakeWater> waters_;
  ocl::Buffer<std::uint8_t> cells_;
  ocl::Buffer<LakeWave> waves_;
};

}  // namespace offing::terrain
