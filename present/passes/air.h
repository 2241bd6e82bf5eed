#pragma once

#include "host/sky/atmosphere.h"
#include "present/gl/shader_program.h"

namespace offing::present {

/// Sets the uniforms of air.glsl on a program in use; `environment` is the map of SkyPass.
inline void set_air(const ShaderProgram& program, const sky::Atmosphere& air, GLuint environment,
                    int environment_unit) {
  const double aerosol_perm = air.aerosol_optical_depth / air.aerosol_scale_height_m;
  const auto at_sea_level = [&](double rayleigh_depth) {
    return static_cast<float>(rayleigh_depth / air.rayleigh_scale_height_m + aerosol_perm);
  };
  const sky::Spectrum& depth = air.rayleigh_optical_depth;
  program.set("haze_perm", glm::vec3(at_sea_level(depth[0]), at_sea_level(0.5 * (depth[1] + depth[2])),
                                     at_sea_level(depth[3])));
  bind_sampler(program, "environment", environment_unit, environment);
}

}  // namespace offing::present
