// Uniforms of the sky passes: one layout for C++ and GLSL (std140).
#ifdef __cplusplus
#pragma once

#include "present/gl/glsl_types.h"

namespace offing::present::glsl {
#endif

struct SkyNodesUniforms {
  float step_px;  // between neighbours
};

struct CloudySkyUniforms {
  float reach;  // of the face's picture over the face
};

#ifdef __cplusplus
}  // namespace offing::present::glsl
#endif
