// Uniforms of the cloud pass: one layout for C++ and GLSL (std140).
#ifdef __cplusplus
#pragma once

#include "present/gl/glsl_types.h"

namespace offing::present::glsl {
#endif

struct CloudUniforms {
  vec3 rayleigh_depth;  // optical depth of all air above the sea
  float aerosol_depth;
  vec2 scale_heights_m;  // of air and of aerosol
  float airless_m;       // height that rays rise through without air
};

#ifdef __cplusplus
}  // namespace offing::present::glsl
#endif
