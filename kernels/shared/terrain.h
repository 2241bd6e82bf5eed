// Height fields, rays and hits of terrain/*.cl, one layout for host and device: 4-byte scalars only, padding
// written out. Places on a map are in cells: posts are at whole numbers, x grows with the column, z with the
// row.
#ifndef OFFING_KERNELS_SHARED_TERRAIN_H
#define OFFING_KERNELS_SHARED_TERRAIN_H

// How a ray ended.
#define TERRAIN_MISS 0
#define TERRAIN_SURFACE 1  // on the surface, from above
#define TERRAIN_SIDE 2     // on the map's edge, below the surface: ground is solid
#define TERRAIN_INSIDE 3   // it starts on or below the surface

// When a ray that has passed over a node goes up a level.
#define TERRAIN_UP_NEVER 0
#define TERRAIN_UP_ALWAYS 1
#define TERRAIN_UP_WITH_PARENT 2  // when it has left the parent too

// A height field with its maximum mipmap.
typedef struct {
  int columns;             // posts in a row
  int cells_x, cells_z;    // a post less than columns and rows
  int padded_x, padded_z;  // cells, up to whole nodes of the top level
  int top_level;           // levels 1 ... top_level are stored; level L has nodes of 2^L x 2^L cells
  int first_level;         // of rays that come from outside; of all, where starts_at_origin is 0
  int starts_at_origin;    // 1: other rays start at the lowest level whose maximum is above their origin
  float highest_m;         // of all heights
  float largest_m;         // of their magnitudes
  float cells_per_m_x, cells_per_m_z;
} TerrainField;

// A picture's rays: forward + clip_x right + clip_y up, not normalised, clip coordinates from -1 to 1.
typedef struct {
  int cell_x, cell_z;             // the eye is at cell + fraction
  float fraction_x, fraction_z;   // 0 ... 1
  float height_m, height_rest_m;  // their sum is the eye's height
  float forward_x, forward_y, forward_z;
  float right_x, right_y, right_z;
  float up_x, up_y, up_z;
  int width_px, height_px;
} TerrainView;

// The rests are what the numbers before them lose as floats.
typedef struct {
  int cell_x, cell_z;  // the origin, as that of a view
  float fraction_x, fraction_z;
  float height_m, height_rest_m;
  float along_x, along_z;  // cells a metre
  float along_x_rest, along_z_rest;
  float rise;     // metres a metre
  float limit_m;  // hits beyond are misses
} TerrainRay;

// What a ray hits first.
typedef struct {
  float distance_m;    // +inf is a miss; then all but steps is 0
  int kind;            // TERRAIN_MISS ...
  int cell_x, cell_z;  // where it hit: at cell + (u, v)
  float u, v;          // 0 ... 1
  float normal_x, normal_y, normal_z;
  int steps;  // iterations of the walk; of those shared by many rays, a ray's share, rounded up
} TerrainHit;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(TerrainField) == 48, "no padding");
static_assert(sizeof(TerrainView) == 68, "no padding");
static_assert(sizeof(TerrainRay) == 48, "no padding");
static_assert(sizeof(TerrainHit) == 40, "no padding");
#endif

#endif
