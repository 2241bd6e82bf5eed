// The sun over a block of posts at a moment, one layout for host and device: 4-byte scalars only.
#ifndef OFFING_KERNELS_SHARED_SUN_BLOCKS_H
#define OFFING_KERNELS_SHARED_SUN_BLOCKS_H

// A value that is linear in the posts' places: at the block's middle, and what it grows by a post east, a
// post south.
typedef struct {
  float middle, per_column, per_row;
} BlockPlane;

// Directions are in the map's frame: x along rows, y up, z along columns.
typedef struct {
  BlockPlane tangent;  // of the elevation of what counts as the sun's edge, lifted by refraction
  BlockPlane share;    // 0 ... 1, of the way from one horizon to the next at which its azimuth is
  BlockPlane x, y, z;  // unit vector to the sun
  // Its light on a surface that faces it, kW/m^2: beam_0 + beam_1 h + beam_2 h^2 at h m above the block's
  // middle height.
  float beam_0, beam_1, beam_2;
  float hours;        // since the moment before; 0 where none precedes it
  int horizon, next;  // of horizons, those before and behind the sun's azimuth
} BlockSun;

// A block of posts, for which the sun is known.
typedef struct {
  float middle_column, middle_row, middle_m;
} SunBlock;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(BlockPlane) == 12, "no padding");
static_assert(sizeof(BlockSun) == 84, "no padding");
static_assert(sizeof(SunBlock) == 12, "no padding");
#endif

#endif
