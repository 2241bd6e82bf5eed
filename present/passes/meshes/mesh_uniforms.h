// Uniforms of the mesh passes: one layout for C++ and GLSL (std140).
#ifdef __cplusplus
#pragma once

#include "present/gl/glsl_types.h"

namespace offing::present::glsl {
#endif

const int most_lights = 64;  // the sun among them

struct LightUniforms {
  // Two for each light: the direction toward it and 0, or its place and 1; what it sends on a surface that
  // faces it, klx.
  vec4 lights[2 * most_lights];
  vec3 sky_klx;  // on a level surface that looks up, by the sky alone
  int count;
  vec3 ground_klx;  // on one that looks down, by what lies below
  int sun;          // which of them clouds shade; -1: none
};

struct MeshMatrices {
  mat4 to_clip;
  mat4 to_eye;  // relative to the eye, in the world's axes
  float cut_m;  // height over the eye's below which nothing is drawn
};

struct MeshUniforms {
  vec3 colour;
  float specular;
  float shininess;
  int cartoon_steps;
  int has_ramp;
  float length_of_mesh_m;
};

// Outlines, strokes, boxes.
struct PlainUniforms {
  vec4 light;  // kcd/m2, premultiplied, and coverage
  vec2 half_image_px;
  float outline_px;
};

struct HighlightUniforms {
  mat4 to_box;  // of the projector: -1 ... 1 in x and y
  vec3 colour;  // of the artist
  float opacity;
  vec3 light_kcdpm2;  // of a white highlight
  float softness;     // in half widths
  vec3 box_right;     // unit, in the world's axes
  float shape_depth;  // in half widths
  vec3 box_light;
  int shows_box;  // 1: all of the box, 2: all of the region, in plain colour
};

struct MeshEndUniforms {
  int sample_count;
  float exposure;  // 1 / (kcd/m2)
  int is_layer;    // 1: samples are premultiplied light with alpha, over nothing
};

#ifdef __cplusplus
}  // namespace offing::present::glsl
#endif
