// Uniforms of the tone pass: one layout for C++ and GLSL (std140).
#ifdef __cplusplus
#pragma once

#include "present/gl/glsl_types.h"

namespace offing::present::glsl {
#endif

struct ToneUniforms {
  float exposure;  // 1 / (kcd/m2)
  int is_filmic;
};

#ifdef __cplusplus
}  // namespace offing::present::glsl
#endif
