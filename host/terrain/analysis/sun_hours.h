#pragma once

#include <cstdint>
#include <span>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/terrain/analysis/horizons.h"
#include "kernels/shared/sun_blocks.h"

namespace offing::terrain {

/// Where the sun is over a band of rows: for blocks of columns side by side, in order of time.
struct SunsOfBand {
  int block_columns = 0;  ///< a multiple of the widest vector
  std::span<const SunBlock> blocks;
  std::span<const BlockSun> suns;  ///< [blocks][moments]
};

/// How long the sun shines on a map's posts, how much direct light they get of it, and where it shines at a
/// moment. It shines where its edge is above the horizon, which is linear between two azimuths; between two
/// moments, what it stands above the horizon is linear in time.
class SunHours {
 public:
  /// `horizons` must live as long.
  SunHours(const ocl::Device& device, const Horizons& horizons);

  /// For the band that the horizons were last made for, [rows][columns]: hours, and kWh a square metre of the
  /// ground, inclined as it is. Waits. Throws Error(bad_usage) for sizes that do not fit each other.
  void read(const RowBand& band, const SunsOfBand& suns, std::span<float> hours, std::span<float> energy_kwh);
  /// 255 where the sun shines at a moment of the suns that were last read, else 0.
  void read_mask(const RowBand& band, const SunsOfBand& suns, int moment, std::span<std::uint8_t> lit);

 private:
  ocl::Device device_;
  const Horizons* horizons_;
  ocl::Kernel hours_kernel_, mask_kernel_;
  ocl::Buffer<float> hours_, energy_;
  ocl::Buffer<std::uint8_t> lit_;
  ocl::Buffer<SunBlock> blocks_;
  ocl::Buffer<BlockSun> suns_;
};

}  // namespace offing::terrain
