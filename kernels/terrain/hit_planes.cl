// What pictures show of a camera's hits beside their light: their distances, and the work they took (T11 of docs/sources.md).
// In:  hits [height_px][width_px] of terrain/quadtree_cast.cl, as one row of `count`.
// Out: distances_m [height_px][width_px] along the unit rays, +inf for misses; the second of planes [2][height_px][width_px],
//      steps. terrain/edge_distances.cl writes the first.
#include "shared/terrain.h"

__kernel void hit_planes(__global const TerrainHit *restrict hits, int count, __global float *restrict distances_m,
                         __global float *restrict planes) {
  const int pixel = (int)get_global_id(0);
  if (pixel >= count) return;
  distances_m[pixel] = hits[pixel].distance_m;
  planes[count + pixel] = (float)hits[pixel].steps;
}
