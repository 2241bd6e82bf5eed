// Which particles may be seen in each tile of a picture.
// In:  boxes [4][box_pitch] px of kernels/clouds/billboard_project.cl.
// Out: first [tiles], seen [tiles]: where a tile's particles begin in `list`, and how many there are, the nearest
//      first; list [capacity] places of billboards. inout used: how many entries all tiles need, from 0, and MOST_USED if that
//      is more; what does not fit into the list is not written.
#include "shared/cloud_image_params.h"
#include "simd/lane_masks.clh"

// Places that a tile keeps of its first look at the boxes.
#define KEPT 512

// Far above what a list may have, and far below where sums wrap.
#define MOST_USED (1 << 30)

// Adds up to MOST_USED; what there was before.
static inline int take(__global int* used, int count) {
  // Others write it meanwhile: a read that is not atomic would be a race.
  int before, found = atomic_or(used, 0);
  do {
    before = found;
    found = atomic_cmpxchg(used, before, before > MOST_USED - count ? MOST_USED : before + count);
  } while (found != before);
  return before;
}

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

// Not 0 in the lanes whose boxes reach into the tile.
INLINE uint_lanes boxes_that_meet(__global const float* box, int pitch, float left, float right,
                                      float bottom, float top) {
  return as_uint_lanes(mask_of(load_lanes(box) < right) & mask_of(load_lanes(box + pitch) > left) &
                       mask_of(load_lanes(box + 2 * pitch) < top) &
                       mask_of(load_lanes(box + 3 * pitch) > bottom));
}

__kernel void billboard_tiles(__global const float* restrict boxes, CloudImageParams params, int capacity,
                         __global int* restrict first, __global int* restrict seen,
                         __global uint* restrict list, __global int* restrict used) {
  const int tile = (int)get_global_id(0);
  if (tile >= params.tile_columns * params.tile_rows) return;
  const float left = (float)(tile % params.tile_columns * CLOUD_TILE_PX);
  const float bottom = (float)(tile / params.tile_columns * CLOUD_TILE_PX);
  const float right = left + CLOUD_TILE_PX, top = bottom + CLOUD_TILE_PX;
  // What the first pass finds, unless it is more: then a second one looks for all again.
  uint found[KEPT];
  int count = 0;
  for (int place = 0; place < params.box_pitch; place += LANES) {
    const uint_lanes bits = boxes_that_meet(boxes + place, params.box_pitch, left, right, bottom, top);
    if (!any_lane(as_int_lanes(bits))) continue;
    for (int lane = 0; lane < LANES; ++lane) {
      if (lane_of(bits, lane) == 0u) continue;
      if (count < KEPT) found[count] = (uint)(place + lane);
      ++count;
    }
  }
  const int begin = take(used, count);
  const bool fits = count <= capacity - begin;
  first[tile] = begin;
  seen[tile] = fits ? count : 0;
  if (!fits) return;
  if (count <= KEPT) {
    for (int i = 0; i < count; ++i) list[begin + i] = found[i];
    return;
  }
  int next = begin;
  for (int place = 0; place < params.box_pitch; place += LANES) {
    const uint_lanes bits = boxes_that_meet(boxes + place, params.box_pitch, left, right, bottom, top);
    if (!any_lane(as_int_lanes(bits))) continue;
    for (int lane = 0; lane < LANES; ++lane) {
      if (lane_of(bits, lane) != 0u) list[next++] = (uint)(place + lane);
    }
  }
}
