// What is left of waves over shoals, one layout for host and device: 4-byte scalars only, padding written
// out.
#ifndef OFFING_KERNELS_SHARED_SHOALS_H
#define OFFING_KERNELS_SHARED_SHOALS_H

// Bands of waves that shoal alike: four cascades, then Gerstner waves in four bands from long to short.
#define SHOAL_BANDS 8
#define SHOAL_FIRST_GERSTNER 4

// Rows of the table of shares [SHOAL_STEPS][SHOAL_BANDS]: row i is that of the depth deepest (i /
// (SHOAL_STEPS - 1))^2, linear between rows over the root of the depth.
#define SHOAL_STEPS 256

// The sea's bed as waves feel it is nowhere steeper: a slope, along rows and columns of its map. Beyond the
// map's edge it sinks so steeply.
#define SHOAL_STEEPEST 0.5f

// The posts of a map of depths [rows][columns] m, and where it lies: its first post at 64 tile + origin.
typedef struct {
  int tile_x, tile_z;
  float origin_x_m, origin_z_m;
  float columns_per_m, rows_per_m;
  int columns, rows;  // at least 2
  float deepest_m;    // at this depth and below waves are those of the open sea
} ShoalMap;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(ShoalMap) == 36, "no padding");
#endif

#endif
