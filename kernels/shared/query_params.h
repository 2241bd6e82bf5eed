// Points, parameters and results of ocean/surface_query.cl, one layout for host and device: 4-byte scalars
// only, padding written out.
#ifndef OFFING_KERNELS_SHARED_SURFACE_QUERY_H
#define OFFING_KERNELS_SHARED_SURFACE_QUERY_H

// Places are whole tiles of this side and a rest, so that floats keep micrometres anywhere on Earth.
#define SURFACE_QUERY_TILE_M 64.0f

// The label under a point is found by at most this many steps X <- X - B (X + d(X) - x): the first has B = 1,
// as fixed-point iteration has it, and d of the Gerstner waves alone where there are any; the others have the
// inverse of the mapping's derivative, whose determinant is taken to be LEAST_DETERMINANT
// (shared/deformation.h) at least.
#define SURFACE_QUERY_MOST_STEPS 24

// A point of the world: 64 tile + rest.
typedef struct {
  int tile_x, tile_z;
  float x_m, z_m;  // -32 ... 32, but more does no harm
} SurfaceQueryPoint;

// The water there.
typedef struct {
  float height_m;
  float slope_x, slope_z;  // of the displaced surface: its normal is (-slope_x, 1, -slope_z), normalised
  float residual_m;        // horizontal distance of what was found from the point
  float velocity_x_mps, velocity_y_mps, velocity_z_mps;
  float pressure_pa;  // above that of the air
} SurfaceQuerySample;

// A Gerstner wave with its phase at the corner of tile (0, 0) at time 0. Turns are in 2^-32, so that sums
// that overflow lose whole ones, and nothing else.
typedef struct {
  int phase;
  int tile_step_x, tile_step_z;    // from tile to tile
  float tile_rest_x, tile_rest_z;  // what these are off, -0.5 ... 0.5
  int rate;                        // cycles per 2^32 ticks, as in ocean/wave_phase.clh
  float turns_x_perm, turns_z_perm;
  float height_m;                                // times the cosine of the phase, as are the gradients
  float gradient_xx, gradient_xz, gradient_zz;   // GERSTNER_GRADIENT_XX ... in shared/gerstner_params.h
  float shift_x_m, shift_z_m, slope_x, slope_z;  // times the sine
  float velocity_x_mps, velocity_z_mps, head_m;  // times the cosine, at the depth that is asked for
  float velocity_y_mps;                          // times the sine
  int band;  // of Gerstner waves that shoal alike: row SHOAL_FIRST_GERSTNER + band of shared/shoal_params.h
} SurfaceQueryWave;

// Cascades and what is asked, the same for all points of a query.
typedef struct {
  int tile_step_high[4];  // of each cascade: from tile to tile in 2^-64 of the patch
  int tile_step_low[4];
  float patches_per_m[4];
  float texels_per_m[4];
  int cascade_count;
  int size;  // n
  int wave_count;
  int ring_count;
  int has_flow;       // 0: velocity and pressure are left out
  float depth_m;      // of velocity and pressure below the surface
  float weight_papm;  // density times gravity
  float tolerance_m;  // steps end where the residual is no larger
} SurfaceQueryParams;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(SurfaceQueryPoint) == 16, "no padding");
static_assert(sizeof(SurfaceQuerySample) == 32, "no padding");
static_assert(sizeof(SurfaceQueryWave) == 84, "no padding");
static_assert(sizeof(SurfaceQueryParams) == 96, "no padding");
#endif

#endif
