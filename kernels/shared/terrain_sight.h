// Lines of sight from one eye to the posts of a height field, one layout for host and device: 4-byte scalars
// only.
#ifndef OFFING_KERNELS_SHARED_TERRAIN_SIGHT_H
#define OFFING_KERNELS_SHARED_TERRAIN_SIGHT_H

// What is known of a post, a byte each.
#define SIGHT_HIDDEN 0
#define SIGHT_UNDECIDED 1
#define SIGHT_VISIBLE 255

// Up to a share of the last line's distance, 1 / SIGHT_FINE_PARTS, the wedges of terrain/horizon_sweep.cl are so
// many times as wide: it takes as many parts of LANES - 1 wedges a work-item.
#define SIGHT_FINE_PARTS 4

// An eye and the targets that it may see.
typedef struct {
  int cell_x, cell_z;                    // the eye is at cell + fraction
  float fraction_x, fraction_z;          // 0 ... 1
  float eye_m, eye_rest_m;               // their sum is the eye's height
  float eye_above_m;                     // the ground
  float target_above_m;                  // the ground, of every target
  float bend_x_m, bend_z_m;              // how far the Earth falls away at a cell's distance along x, along z
  float radius_share_x, radius_share_z;  // a cell's share of the radius beyond which all is hidden, squared
} TerrainSight;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(TerrainSight) == 48, "no padding");
#endif

#endif
