// Relief between the posts of a map, near the eye, one layout for host and device: 4-byte scalars only. The drawn ground is
// laid there in levels of posts around the eye, each level within the next one.
#ifndef OFFING_KERNELS_SHARED_TERRAIN_RELIEF_H
#define OFFING_KERNELS_SHARED_TERRAIN_RELIEF_H

// At most so many levels.
#define TERRAIN_RELIEF_LEVELS 3
// A level has at most so many cells a side, and its posts are spaced four times as far as those of the level before.
#define TERRAIN_RELIEF_CELLS 256
#define TERRAIN_RELIEF_POSTS 257
#define TERRAIN_RELIEF_RATIO_LOG2 2
// Levels of the pyramid of maxima over one, and how many nodes they have.
#define TERRAIN_RELIEF_TOP_LEVEL 8
#define TERRAIN_RELIEF_NODES 21845

// Slopes of the relief of turf, stones, rock and sand, deviations of each octave: noise with cells of 1/64 m ... 64 m.
#define TERRAIN_RELIEF_OCTAVES 13
#define TERRAIN_TURF_SLOPES \
  0.15f, 0.15f, 0.14f, 0.12f, 0.1f, 0.075f, 0.065f, 0.055f, 0.05f, 0.05f, 0.05f, 0.05f, 0.05f
#define TERRAIN_STONE_SLOPES \
  0.08f, 0.13f, 0.19f, 0.24f, 0.24f, 0.19f, 0.14f, 0.11f, 0.09f, 0.08f, 0.07f, 0.06f, 0.06f
#define TERRAIN_ROCK_SLOPES \
  0.06f, 0.08f, 0.11f, 0.15f, 0.19f, 0.22f, 0.24f, 0.24f, 0.22f, 0.18f, 0.14f, 0.11f, 0.09f
#define TERRAIN_SAND_SLOPES \
  0.085f, 0.085f, 0.085f, 0.095f, 0.1f, 0.075f, 0.05f, 0.036f, 0.03f, 0.02f, 0.02f, 0.02f, 0.02f

// The ground is as the map has it under what stands there: a disc about a place, beside which relief begins.
typedef struct {
  float east_m, south_m;  // of the eye
  float radius_m, ramp_m;
  float share;  // 1: level, 0: as elsewhere
} TerrainReliefDisc;

// Heights are [levels][257][257], of which the first cells + 1 posts of a row are of use; maxima [levels][21845] as those of a
// map of 256 x 256 cells. Levels are TERRAIN_RELIEF_LEVELS here.
typedef struct {
  int levels;       // 0: the ground is drawn as the map has it
  int finest_log2;  // the first level has 2^finest_log2 steps to a cell of the map
  int middle_x, middle_z;  // of all levels: the eye's place in steps of the first, rounded down
  int eye_cell_x, eye_cell_z;  // the eye is at cell + fraction of the map
  float eye_fraction_x, eye_fraction_z, eye_height_m;
  float strength;  // of the relief: 1 is that of the light on it
  float reach_m;   // there is none farther from the eye
  // Heights between which the ground's cover changes; there is no relief at or below shore_m.
  float shore_m, tree_line_m, snow_line_m;
  int discs;
} TerrainRelief;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(TerrainRelief) == 60, "no padding");
static_assert(sizeof(TerrainReliefDisc) == 20, "no padding");
#endif

#endif
