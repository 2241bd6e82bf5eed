// Uniforms of the terrain pass: one layout for C++ and GLSL (std140).
#ifdef __cplusplus
#pragma once

#include "present/gl/glsl_types.h"

namespace offing::present::glsl {
#endif

struct TerrainUniforms {
  vec4 step_marks[4];  // r, g, b and the steps of that colour
  int draws_edges;     // 0: pixels that terrain covers, 1: those that it covers in part
};

#ifdef __cplusplus
}  // namespace offing::present::glsl
#endif
