#pragma once

#include <array>

#include "host/clouds/cloud_parameters.h"
#include "host/sky/atmosphere.h"
#include "host/sky/clear_sky.h"

namespace offing::world {

/// The sun as clouds see it.
struct CloudSunlight {
  std::array<double, 3> direction{0.0, 1.0, 0.0};  ///< unit, toward it
  double distance_au = 1.0;
};

/// What falls on clouds at an altitude: the sun through the air above, the mean of the sky, and what the
/// ground below sends back of both. `sky` is theirs to turn: its tables are those of the ground afterwards.
/// Waits for the device.
clouds::CloudIllumination cloud_illumination(sky::ClearSky& sky, const sky::Atmosphere& atmosphere,
                                             const CloudSunlight& sun, double altitude_m);

}  // namespace offing::world
