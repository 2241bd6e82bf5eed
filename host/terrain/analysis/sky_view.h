#pragma once

#include <span>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/terrain/analysis/horizons.h"

namespace offing::terrain {

/// The sky-view factors of a map's posts: the light that the ground at a post gets from a sky that is alike
/// everywhere, as a share of what level ground in the open gets. Light counts by the cosine to the ground's
/// normal, which is that of the mean slopes between the post's neighbours: a slope of angle b in the open has
/// (1 + cos b) / 2. Within 1 % of closed forms of planes, walls, cones and bowls
/// (tests/terrain/analysis/sky_view_test.cpp).
class SkyView {
 public:
  /// `horizons` must have all azimuths, and live as long.
  SkyView(const ocl::Device& device, const Horizons& horizons);

  /// The factors [rows][columns] of the band that the horizons were last made for. Waits. Throws
  /// Error(bad_usage) if there is less room.
  void read(const RowBand& band, std::span<float> factors);

 private:
  const Horizons* horizons_;
  ocl::Kernel kernel_;
  ocl::Buffer<float> factors_;
};

}  // namespace offing::terrain
