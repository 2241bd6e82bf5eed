// Which particles may be seen in each tile of a picture.
// In:  boxes [4][box_pitch] px of kernels/clouds/puff_project.cl.
// Out: first [tiles], seen [tiles]: where a tile's particles begin in `list`, and how many there are, the
// nearest
//      first; list [capacity] places of puffs. inout used: how many entries all tiles need, from 0; what does
//      not fit into the list is not written.
#include "shared/cloud_picture.h"
#include "terrain/lane_masks.clh"

static inline uint lane_of(uint_lanes values, int lane) {
#if LANES == 1
  return values;
#else
  union {
    uint_lanes vector;
    uint lane[LANES];
  } all;
  all.vector = values;
  return all.lane[lane];
#endif
}

__kernel void puff_tiles(__global const float* restrict boxes, CloudPictureParams params, int capacity,
                         __global int* restrict first, __global int* restrict seen,
                         __global uint* restrict list, __global int* restrict used) {
  const int tile = (int)get_global_id(0);
  if (tile >= params.tile_columns * params.tile_rows) return;
  const float left = (float)(tile % params.tile_columns * CLOUD_TILE_PX);
  const float bottom = (float)(tile / params.tile_columns * CLOUD_TILE_PX);
  const float right = left + CLOUD_TILE_PX, top = bottom + CLOUD_TILE_PX;
  int begin = 0, count = 0;
  for (int pass = 0; pass < 2; ++pass) {
    if (pass == 1) {
      begin = atomic_add(used, count);
      first[tile] = begin;
      seen[tile] = begin + count <= capacity ? count : 0;
      if (begin + count > capacity) return;
      count = 0;
    }
    for (int place = 0; place < params.box_pitch; place += LANES) {
      __global const float* box = boxes + place;
      const int_lanes meets = mask_of(load_lanes(box) < right) &
                              mask_of(load_lanes(box + params.box_pitch) > left) &
                              mask_of(load_lanes(box + 2 * params.box_pitch) < top) &
                              mask_of(load_lanes(box + 3 * params.box_pitch) > bottom);
      if (!any_lane(meets)) continue;
      const uint_lanes bits = as_uint_lanes(meets);
      for (int lane = 0; lane < LANES; ++lane) {
        if (lane_of(bits, lane) == 0u) continue;
        if (pass == 1) list[begin + count] = (uint)(place + lane);
        ++count;
      }
    }
  }
}
