// Light on terrain and the air before it, one layout for host and device: 4-byte scalars only. Colours are
// linear Rec.709.
#ifndef OFFING_KERNELS_SHARED_TERRAIN_LIGHT_H
#define OFFING_KERNELS_SHARED_TERRAIN_LIGHT_H

#include "kernels/shared/swash_params.h"

// Rays that a pixel needs.
#define TERRAIN_ONE_RAY 0
#define TERRAIN_FEW_RAYS 1  // a quarter of many
#define TERRAIN_MANY_RAYS 2
// Those that need many differ from a neighbour by so many times as much as those that need few.
#define TERRAIN_MANY_CONTRASTS 3.3f

// Sun, sky and air over terrain, and where its cover changes.
typedef struct {
  float sun_red_klx, sun_green_klx, sun_blue_klx;  // on a surface that faces the sun
  float sky_red_klx, sky_green_klx, sky_blue_klx;  // on a level surface, by the sky alone
  // Of light, the share that a metre of air at sea level takes away.
  float rayleigh_red_perm, rayleigh_green_perm, rayleigh_blue_perm;
  float aerosol_perm;
  float rayleigh_scale_height_m, aerosol_scale_height_m;
  // Heights between which the ground's cover changes.
  float sea_level_m;   // ground at or below is water
  float beach_line_m;  // ground below is sand, wet from a metre below the line on
  float tree_line_m;
  float snow_line_m;
  // Variance of the slopes of water in a direction; 0: water is painted like ground.
  float water_slopes;
  SwashParams swash;    // about the point at sea level below the eye
  float still_water_m;  // height of the still sea that the swash washes up from
} TerrainLight;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(TerrainLight) == 244, "no padding");
#endif

#endif
