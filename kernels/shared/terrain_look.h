// What lies on terrain beside its light: a map of colours, materials, and the share of the sky that its posts
// see, one layout for host and device: 4-byte scalars only.
#ifndef OFFING_KERNELS_SHARED_TERRAIN_LOOK_H
#define OFFING_KERNELS_SHARED_TERRAIN_LOOK_H

// Where the colours of terrain lie, the sky that its posts see, and heights that are not drawn.
typedef struct {
  // Of the finest level; each further one has half as many, rounded up. No columns: no colours.
  int colour_columns, colour_rows, colour_levels;
  float colour_left, colour_top;  // the edge of the first texel, in cells from the first post
  float colours_a_cell_x, colours_a_cell_z;
  // Shares of the sky stand at every so many posts, and at the last ones. 0: there are none.
  int open_sky_stride;
  int open_sky_columns, open_sky_rows;
  // Ground lower than hidden_below_m, less hidden_bend_perm times the square of its distance, is under water
  // that is drawn over it: it counts as missed, and so does what is several pixels above hidden_above_m.
  float hidden_below_m, hidden_bend_perm, hidden_above_m;
  int material_count;     // of shared/terrain_materials.h
  int sea_goes_on;        // 1: rays that pass by the map meet a sea beyond it
  float finest_detail_m;  // patterns of the ground that are finer show as their mean
} TerrainLook;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(TerrainLook) == 64, "no padding");
#endif

#endif
