#pragma once

#include <glm/vec3.hpp>

#include "host/sky/atmosphere.h"

namespace offing::present {

/// Extinction of the air at the sea, 1/m, for air.glsl.
inline glm::vec3 haze_perm(const sky::Atmosphere& air) {
  const double aerosol_perm = air.aerosol_optical_depth / air.aerosol_scale_height_m;
  const auto at_sea_level = [&](double rayleigh_depth) {
    return static_cast<float>(rayleigh_depth / air.rayleigh_scale_height_m + aerosol_perm);
  };
  const sky::Spectrum& depth = air.rayleigh_optical_depth;
  return {at_sea_level(depth[0]), at_sea_level(0.5 * (depth[1] + depth[2])), at_sea_level(depth[3])};
}

}  // namespace offing::present
