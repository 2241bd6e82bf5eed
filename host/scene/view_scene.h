#pragma once

#include "host/base/camera.h"

namespace offing::scene {

/// What a scene says about its pictures: eye, sun and exposure.
struct ViewScene {
  Camera camera{.eye_m = {0.0, 5.0, 0.0}, .pitch_rad = -0.035, .vertical_field_of_view_rad = 0.785};
  double sun_azimuth_rad = 0.785;   ///< clockwise from north (-z)
  double sun_elevation_rad = 0.52;  ///< above the horizon
  double exposure_ev = 0.0;         ///< stops above the exposure that the light at the eye asks for
};

}  // namespace offing::scene
