// What pictures show of a camera's hits beside their light, a plane each: their depth, and the work they took (T11 of
// docs/sources.md).
// In:  hits [height_px][width_px] of terrain/quadtree_cast.cl, as one row of `count`.
// Out: planes [2][height_px][width_px]: distance along the unit ray, m, +inf for misses; steps.
#include "shared/terrain.h"

__kernel void hit_planes(__global const TerrainHit *restrict hits, int count, __global float *restrict planes) {
  const int pixel = (int)get_global_id(0);
  if (pixel >= count) return;
  planes[pixel] = hits[pixel].distance_m;
  planes[count + pixel] = (float)hits[pixel].steps;
}
