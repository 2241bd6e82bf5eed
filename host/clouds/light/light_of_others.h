#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/clouds/shape/cloud_parameters.h"

namespace offing::clouds {

/// A cloud as others see it: an ellipsoid with its mass and moments.
struct CloudExtent {
  glm::dvec3 middle_m{0.0}, half_axes_m{0.0};  ///< of no length where there is no cloud
  double optical_mass_m2 = 0.0;                ///< integral of the extinction over the volume

  bool operator==(const CloudExtent&) const = default;
};

CloudExtent extent_of(std::span<const CloudParticle> particles);

/// What clouds see of each other: the lights with CloudIllumination::clouds_above_kcdpm2 and
/// clouds_below_kcdpm2. A cloud is seen as an ellipsoid that sends out what it takes of the suns, past other
/// clouds, and of sky and ground: a deep one mostly from the side that the light falls on. Light that goes
/// from one cloud to another more than once is left out. One extent, look and light a cloud, with places
/// relative to the same one; means over 64 directions.
std::vector<CloudIllumination> with_light_of_others(std::span<const CloudIllumination> lights,
                                                    std::span<const CloudExtent> extents,
                                                    std::span<const CloudLook> looks);

}  // namespace offing::clouds
