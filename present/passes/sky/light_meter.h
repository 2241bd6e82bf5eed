#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/base/camera.h"
#include "host/world/world.h"

namespace offing::present {

/// Exposes as a light meter does that looks where the camera does, at the sky and, below the horizon, at what
/// the water mirrors of it, or at level ground where there is no water. Exposures depend on sun, camera and
/// coast alone, so that pictures do not flicker with the waves, nor with the shade under the eye. Where there
/// are meshes and nothing else it measures the light that falls on them, so that white comes out as white.
class LightMeter {
 public:
  /// Exposure, 1 / (kcd/m2), `ev` stops above what is metered, of a world after its at(). Waits for the sky's
  /// light, unless sky and camera are those of the last time.
  double exposure(const world::World& world, const Camera& camera, double ev);

 private:
  // Of the last time.
  std::uint64_t revision_ = 0;
  bool has_water_ = true;
  std::vector<std::array<double, 3>> directions_;
  std::vector<double> land_shares_;
  double mean_stops_ = 0.0;  // of the light there, over 1 kcd/m2
};

}  // namespace offing::present
