// Uniforms of a view, for all passes: one layout for C++ and GLSL (std140).
#ifdef __cplusplus
#pragma once

#include "present/gl/glsl_types.h"

namespace offing::present::glsl {
#endif

struct ViewUniforms {
  vec3 ray_forward;  // through the picture's middle, a unit vector
  float near_m;      // depth is this over the distance along the line of sight
  vec3 ray_right;    // what a step of 1 in clip coordinates adds to the ray
  float eye_height_m;
  vec3 ray_up;
  float white_kcdpm2;  // luminance that the picture shows as white
  vec3 haze_perm;      // extinction of the air at the sea
};

#ifdef __cplusplus
}  // namespace offing::present::glsl
#endif
