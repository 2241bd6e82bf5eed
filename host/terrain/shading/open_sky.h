#pragma once

#include <cstdint>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/terrain/field/height_field.h"
#include "kernels/shared/terrain_look.h"

namespace offing::terrain {

/// How much of the sky's light the ground lets through to each of its posts (ambient occlusion by horizons;
/// Max 1988, Horizon mapping), made once a height field: pictures interpolate it, which costs them a
/// hundredth of what walks for every pixel would. Shares are kept in the folder of compiled programs
/// (DiskCache), 256 MB at most, so that the next program that draws the same map on this device reads them;
/// not on devices with memory of their own.
class OpenSky {
 public:
  /// Of maps of 65,536 shares or more: reads what is kept, or waits and keeps it. Of smaller ones: enqueues.
  /// Of maps of more than 1.1 million posts, every second, fourth ... post gets a share of its own.
  OpenSky(const ocl::Device& device, const HeightField& field);

  /// [rows][columns], 255 for all the light that the post's own slope gets from an open sky.
  const ocl::Buffer<std::uint8_t>& shares() const { return shares_; }
  /// Enters their size and place.
  void describe(TerrainLook& look) const;

 private:
  int stride_ = 1, columns_ = 0, rows_ = 0;
  ocl::Buffer<std::uint8_t> shares_;
};

}  // namespace offing::terrain
