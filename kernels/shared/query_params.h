// Points, parameters and results of queries of the water (ocean/surface_query.cl), one layout for host and
// device: 4-byte scalars only, padding written out.
#ifndef OFFING_KERNELS_SHARED_SURFACE_QUERY_H
#define OFFING_KERNELS_SHARED_SURFACE_QUERY_H

// Places are whole tiles of this side and a rest, so that floats keep micrometres anywhere on Earth.
#define SURFACE_QUERY_TILE_M 64.0f

// The label under a point is found by at most this many steps X <- X - B (X + d(X) - x): the first has B = 1,
// as fixed-point iteration has it, and d of the Gerstner waves alone where there are any; the others have the
// inverse of the mapping's derivative, whose determinant is taken to be LEAST_DETERMINANT
// (shared/deformation.h) at least.
#define SURFACE_QUERY_MOST_STEPS 24

// Where a query reads the waves of the cascades: the maps of a frame, bilinear; maps made for queries, by
// splines; or the sum over all modes.
#define QUERY_FRAME_MAPS 0
#define QUERY_MAPS 1
#define QUERY_MODES 2

// Fields of the modes for the last two (ocean/mode_fields.cl). With choppiness a and K = (kx, kz):
#define QUERY_SHIFT 0      // a h/k, m^2: its derivatives along x and z are the horizontal displacement
#define QUERY_HEIGHT 1     // h, m
#define QUERY_RISE 2       // vertical velocity, m/s
#define QUERY_HEAD 3       // dynamic pressure over density and gravity, m
#define QUERY_FLOW 4       // m^2/s: its derivatives along x and z are the horizontal velocity
#define QUERY_FLOW_RATE 5  // of that in time, m^2/s^2: the horizontal acceleration
#define QUERY_RISE_RATE 6  // vertical acceleration, m/s^2
#define QUERY_FIELDS 7

// Fields of a map for queries: both derivatives of the first one, and the others. Each is a short times a
// scale. Maps of the surface alone have the first four, of which the last is not read.
#define QUERY_MAP_FIELDS 8
#define QUERY_SURFACE_FIELDS 4
#define QUERY_MAP_LARGEST 32767

// Texels that follow a row's last one: those that begin it, up to half of them, so that those for a place lie
// side by side.
#define QUERY_MAP_HALO 16

// Samples of a map for queries along each axis that count at a place: B-splines of this order.
#define QUERY_TAPS 4

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
  float acceleration_x_mps2, acceleration_y_mps2, acceleration_z_mps2;
  float error_rms_m;  // expected root mean square error of height_m, beside what residual_m adds
} SurfaceQuerySample;

// The first floats of a sample, as far as those go who know no acceleration.
#define SURFACE_QUERY_FIRST_FLOATS 8

// The water at a point, and how far waves have moved it from its place at rest.
typedef struct {
  SurfaceQuerySample water;
  float shift_x_m, shift_z_m;
} SurfaceQueryShifted;

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
  float omega_radps;
  int band;  // of Gerstner waves that shoal alike: row SHOAL_FIRST_GERSTNER + band of shared/shoal_params.h
} SurfaceQueryWave;

// Cascades and what is asked, the same for all points of a query.
typedef struct {
  int tile_step_high[4];  // of each cascade: from tile to tile in 2^-64 of the patch
  int tile_step_low[4];
  float patches_per_m[4];
  float texels_per_m[4];
  int cascade_count;
  int size;  // n of the maps, or rows of the modes
  int wave_count;
  int ring_count;
  int has_flow;          // 0: velocity and pressure are left out
  float depth_m;         // of velocity and pressure below the surface
  float weight_papm;     // density times gravity
  float tolerance_m;     // steps end where the residual is no larger
  float error_rms_m;     // that of SurfaceQuerySample
  int sample_floats;     // of a sample in memory, as many as its type has
  int columns;           // of the modes' planes (shared/mode_layout.h)
  float mode_radius[4];  // of each cascade: modes farther from K = 0, in steps, are 0
  int padding;
  float map_scales[4 * QUERY_MAP_FIELDS];  // of each cascade and field
} SurfaceQueryParams;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(SurfaceQueryPoint) == 16, "no padding");
static_assert(sizeof(SurfaceQuerySample) == 48, "no padding");
static_assert(sizeof(SurfaceQueryShifted) == 56, "no padding");
static_assert(sizeof(SurfaceQueryWave) == 88, "no padding");
static_assert(sizeof(SurfaceQueryParams) == 256, "no padding");
#endif

#endif
