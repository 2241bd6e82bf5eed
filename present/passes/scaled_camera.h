#pragma once

#include <algorithm>
#include <cmath>

#include "host/base/camera.h"

namespace offing::present {

/// The same view on a picture so many times as wide and high, of at least a pixel.
inline Camera scaled_camera(Camera camera, double scale) {
  const auto scaled = [scale](int side_px) {
    return std::max(1, static_cast<int>(std::lround(side_px * scale)));
  };
  camera.width_px = scaled(camera.width_px);
  camera.height_px = scaled(camera.height_px);
  return camera;
}

}  // namespace offing::present
