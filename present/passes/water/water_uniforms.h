// Uniforms of the water passes: one layout for C++ and GLSL (std140). Labels and places are relative to the
// eye.
#ifdef __cplusplus
#pragma once

#include "kernels/shared/gerstner_params.h"
#include "kernels/shared/shoal_params.h"
#include "kernels/shared/swash_params.h"
#include "present/gl/glsl_types.h"

namespace offing::present::glsl {
#endif

const int most_cascades = 4;
const int most_wakes = 16;
const int most_rings = 64;
const int most_hulls = 16;
const int surf_foam_steps = 1000;  // as finely as a pixel keeps foam of breakers
const int most_levels = 13;  // of the mipmap of a cascade's maps, which have at most 4096 samples a side

struct WaveUniforms {
  vec4 cascades[most_cascades];  // 1 / L 1/m; the eye's place on the patch in L, x and z; texels a metre
  vec4 longest_wave_m;           // of each cascade: wavelength; wider texels show nothing of it
  // Cells a metre; the eye's place in cells from the window's first sample; cells along a side.
  vec4 wakes[most_wakes];
  vec4 wake_first[most_wakes];  // column and row of the map that hold that sample, 0, 0
  vec4 shoal_place;             // the eye's place in posts from the first, column and row; posts a metre
  float shoal_deepest_m;        // below it the sea is open
  float swash_setup_m, swash_reach_m,
      swash_period_s;                  // SwashParams of kernels/shared/swash_params.h, about the eye
  vec4 swash_waves[SWASH_WAVES];       // wave vector x and z in rad/m, amplitude m, phase rad
  vec4 swash_omegas[SWASH_WAVES / 4];  // rad/s, of four waves each
  // Of the open sea: direction of travel x and z, mean wavenumber rad/m, significant height m.
  vec4 surf;
};

struct RingUniforms {
  // Two for each ring: centre x and z in m, wavelength m, radius m; amplitude m, phase rad, 0, 0.
  vec4 values[2 * most_rings];
  int count;
};

struct ShoalUniforms {
  // Of each depth: of cascades, of Gerstner waves in four bands from long to short.
  vec4 shares[2 * SHOAL_STEPS];
};

struct ShapeUniforms {
  vec4 waves[GERSTNER_WAVES];       // wave vector x and z in rad/m, amplitude m, sideways shift m
  vec4 phases[GERSTNER_WAVES / 4];  // rad, of four waves each
  vec4 corners[4];                  // of the grid, homogeneous: label x and z, w
  vec3 band_ends;                   // waves in the first, the first two and the first three bands of shoaling
  int wave_count;
  ivec2 cells;  // of the grid: columns and rows
  float eye_height_m;
  float gerstner_mean_square;  // slope of all waves
};

struct SurfaceUniforms {
  mat4 clip_from_eye;
  // Of each hull: column and row in its map, and height in its axes, of (place, 1).
  vec4 hull_planes[3 * most_hulls];
  int hull_count;
};

struct WaterUniforms {
  // Covariance xx, xz, zz that each mip level of a cascade hides.
  vec4 hidden_slopes[most_cascades * most_levels];
  // How longer waves gather the foam of each cascade (host/ocean/surface/foam_onset.h); factor 0: it has
  // none.
  vec4 foam_factor;
  vec4 foam_steepness;
  vec4 foam_variance;  // of the compression by longer waves
  vec3 ripples;        // covariance of the slopes that no map has
  int level_count;
  vec3 gerstner_slopes;  // covariance of the slopes of all Gerstner waves
  float foam_tile_m;     // side of the foam's tile
  vec3 sun_direction;
  float sun_radius_rad;
  vec3 sun_klx;                // on a surface that faces the sun
  vec3 sky_klx;                // on a level surface, by the sky alone
  float views_margin;          // width of the pictures of WaterViews over that of the water's
  vec3 water_of_sky_kcdpm2;    // light from below the surface that came from the sky
  float image_has_clouds;      // 1: the picture of what is mirrored has clouds, 0: the sky's map alone
  vec3 water_of_sun_kcdpm2;    // and from the sun, where no cloud shades it
  float debug_height_m;        // height that is drawn fully red, its negative fully blue
  vec3 attenuation_perm;       // of light in the water
  float gerstner_compression;  // variance of that by Gerstner waves
  vec2 foam_place;             // the eye's place on the foam's tile
  // Of a larger tile that lies along the wind: the eye's place, and how far a metre of x and of z goes on it.
  vec2 streak_place;
  vec2 streak_x;
  vec2 streak_z;
  float streak_share;  // of the pattern of thin foam
};

struct UnderwaterUniforms {
  vec3 attenuation_perm;
  vec3 deep_kcdpm2;  // what the water sends up, just below its surface
};

#ifdef __cplusplus
}  // namespace offing::present::glsl
#endif
