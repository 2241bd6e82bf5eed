// What disturbs a wake window and where the window lies, one layout for host and device: 4-byte scalars only,
// padding written out.
#ifndef OFFING_KERNELS_SHARED_WAKE_H
#define OFFING_KERNELS_SHARED_WAKE_H

// Shapes of WakeHullShape.shape, with u and v the place along and across in half lengths and half beams:
#define WAKE_SHAPE_ELLIPSOID 0  // depth = draught sqrt(1 - u^2 - v^2)
#define WAKE_SHAPE_GAUSSIAN 1   // depth = draught exp(-u^2 - v^2)

// Beyond this many half lengths nothing is left of a Gaussian: e^-16.
#define WAKE_GAUSSIAN_REACH 4.0f

// What turbulence mixes between neighbours at most in one launch: explicit diffusion is stable up to a
// quarter.
#define WAKE_MOST_MIXED 0.2f

// Rain falls at most once a step on each square of this many cells a side.
#define WAKE_RAIN_SQUARE 8
// Radius of what a drop presses, in cells: the shortest waves that a window shows well.
#define WAKE_DROP_RADIUS 1.5f

// A hull, its middle relative to the window's sample (0, 0).
typedef struct {
  float x_m, z_m;
  float cosine, sine;  // of its heading, from +x toward +z
  float half_length_m, half_beam_m, draught_m;
  int shape;
} WakeHullShape;

// Where a window lies. Its samples are stored by their place in the world, not in the window: column X of the
// world, at X * cell_m, lies in column X modulo n, so that a window that scrolls moves nothing.
typedef struct {
  int size;                     // n, a power of two
  int first_column, first_row;  // of the world, of the window's first sample
  float cell_m;
} WakeGrid;

// A window as ocean/surface_compose.cl and ocean/surface_query.cl read it.
typedef struct {
  int tile_x, tile_z;            // of SURFACE_QUERY_TILE_M, of the window's sample (0, 0)
  float origin_x_m, origin_z_m;  // that sample from the tile's corner
  float cells_per_m;
  int size;
  int first_column, first_row;  // in memory: 0 ... n - 1
  int first_texel;              // of this window in the array of all windows' maps
  float decay_radpm;            // wavenumber by which heights fade below the surface
} WakeLayer;

// Where the samples of ocean/surface_compose.cl lie in a window, in cells from its first sample.
typedef struct {
  float column, row;            // of sample (0, 0)
  float column_step, row_step;  // between neighbouring samples
} WakeSamples;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(WakeSamples) == 16, "no padding");
static_assert(sizeof(WakeHullShape) == 32, "no padding");
static_assert(sizeof(WakeGrid) == 16, "no padding");
static_assert(sizeof(WakeLayer) == 40, "no padding");
#endif

#endif
