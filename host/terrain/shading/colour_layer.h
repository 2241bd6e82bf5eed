#pragma once

#include <cstdint>

#include "host/base/colour_map.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "kernels/shared/terrain_look.h"

namespace offing::terrain {

/// A colour map on a device, with its means over 2 x 2 texels, 4 x 4 and so on in linear light, 5.3 bytes a
/// texel: kernels/terrain/colour_layer.clh takes from it what a pixel sees.
class ColourLayer {
 public:
  /// Waits. Throws Error(bad_input) for a map without texels or another number of them than it says, or
  /// without an extent, and what programs and buffers throw.
  ColourLayer(const ocl::Device& device, const ColourMap& map);

  /// [levels][rows][columns], kernels/terrain/colour_texel.clh.
  const ocl::Buffer<std::uint32_t>& colours() const { return colours_; }
  /// Enters the map's size and place.
  void describe(TerrainLook& look) const;

 private:
  TerrainLook look_{};
  ocl::Buffer<std::uint32_t> colours_;
};

}  // namespace offing::terrain
