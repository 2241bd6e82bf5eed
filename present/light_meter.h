#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/base/camera.h"
#include "host/sky/clear_sky.h"

namespace offing::present {

/// Exposes as a light meter does that looks where the camera does, at the sky and at what the water mirrors
/// of it. Exposures depend on sun and camera alone, so that pictures do not flicker with the waves.
class LightMeter {
 public:
  /// Exposure, 1 / (kcd/m2), `ev` stops above what is metered. Waits for the sky's light, unless sky and
  /// camera are those of the last time.
  double exposure(const sky::ClearSky& sky, const Camera& camera, double ev);

 private:
  // Of the last time.
  std::uint64_t revision_ = 0;
  std::vector<std::array<double, 3>> directions_;
  double mean_stops_ = 0.0;  // of the light there, over 1 kcd/m2
};

}  // namespace offing::present
