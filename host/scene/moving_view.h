#pragma once

#include "host/scene/ocean_scene.h"

namespace offing::scene {

/// The view of a scene at one time, whatever was asked before: keyframes at their values of that time, and
/// the sun where its date says, lifted by refraction, at sun_azimuth_rad and sun_elevation_rad. Throws
/// Error(bad_input) for a time beyond 1e8 s, and where the sun's clock leaves the years 1900 ... 2100.
ViewScene view_at(const OceanScene& scene, double time_s);

}  // namespace offing::scene
