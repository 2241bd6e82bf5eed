#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/clouds/shape/cloud_parameters.h"
#include "host/sky/atmosphere.h"
#include "host/sky/clear_sky.h"
#include "host/sky/sun_position.h"
#include "host/world/mesh_parameters.h"
#include "kernels/shared/cloud_light_params.h"

namespace offing::world {

/// What falls on clouds at altitudes in m, one each: the sun through the air above, the mean of the sky, and
/// what the ground below sends back of both. Mixed between multiples of 500 m, each of which takes its own
/// tables of the sky: within 2 % of the light at the altitude itself while the sun is 12 degrees high or more
/// (tests/world/world_clouds_test.cpp). `sky` is theirs to turn: its tables are those of the ground
/// afterwards. Waits for the device.
std::vector<clouds::CloudIllumination> cloud_illumination(sky::ClearSky& sky,
                                                          const sky::Atmosphere& atmosphere,
                                                          const sky::Sun& sun,
                                                          std::span<const double> altitudes_m);

/// Of the lights beside the sun, the first so many light clouds.
inline constexpr std::size_t most_lights_on_clouds = CLOUD_SUNS - 1;

/// The light that falls on clouds, with the lights besides the sun. A light at a place lights a whole cloud
/// from one direction, seen from the cloud's middle (`places_m`, one a cloud), and is equally bright at any
/// distance, as on meshes. The sun stays the first one, dark where there is none.
std::vector<clouds::CloudIllumination> with_lights(std::vector<clouds::CloudIllumination> illumination,
                                                   std::span<const Light> lights,
                                                   std::span<const glm::dvec3> places_m);

}  // namespace offing::world
