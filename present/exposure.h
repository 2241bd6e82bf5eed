#pragma once

#include "host/base/camera.h"
#include "host/sky/clear_sky.h"

namespace offing::present {

/// Exposure, 1 / (kcd/m2), as a light meter sets it that looks where the camera does, at the sky and at what
/// the water mirrors of it, and `ev` stops above. It depends on sun and camera alone, so that pictures do not
/// flicker with the waves. Waits for the sky's light.
double exposure_for(const sky::ClearSky& sky, const Camera& camera, double ev);

}  // namespace offing::present
