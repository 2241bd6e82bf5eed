// Arrays and parameters of ocean/gerstner_surface.cl, one layout for host and device: 4-byte scalars only,
// padding written out.
#ifndef OFFING_KERNELS_SHARED_GERSTNERS_H
#define OFFING_KERNELS_SHARED_GERSTNERS_H

// Waves at most.
#define GERSTNER_WAVES 128

// Vectors of columns on each side of a block's middle. In simd shape a row has at least one block.
#define GERSTNER_HALF_VECTORS 2

// Rows of turns [4][pitch of waves], in 2^-32 turns: sums that overflow lose whole turns, and nothing else.
#define GERSTNER_PHASE 0        // at the first sample, time 0
#define GERSTNER_COLUMN_STEP 1  // from column to column
#define GERSTNER_ROW_STEP 2
#define GERSTNER_RATE 3  // cycles per 2^32 ticks, as in ocean/wave_phase.clh
#define GERSTNER_TURNS 4

// Rows of amplitudes [8][pitch of waves]: what each field is times the cosine or the sine of the phase. With
// A the amplitude, (kx, kz) = K and Q the scale of the horizontal displacement:
#define GERSTNER_HEIGHT 0       // cosine, A
#define GERSTNER_GRADIENT_XX 1  // cosine, -Q A kx kx / k
#define GERSTNER_GRADIENT_XZ 2  // cosine, -Q A kx kz / k
#define GERSTNER_GRADIENT_ZZ 3  // cosine, -Q A kz kz / k
#define GERSTNER_SHIFT_X 4      // sine, -Q A kx / k
#define GERSTNER_SHIFT_Z 5      // sine, -Q A kz / k
#define GERSTNER_SLOPE_X 6      // sine, -A kx
#define GERSTNER_SLOPE_Z 7      // sine, -A kz
#define GERSTNER_FIELDS 8
#define GERSTNER_COSINE_FIELDS 4  // the first ones

// One ring of waves around a point.
typedef struct {
  float centre_x_m, centre_z_m;  // from the first sample
  float wavelength_m;
  float ring_radius_m;  // where the ring is
  float amplitude_m;    // at this time, at the centre
  int phase;            // at the ring's crest, 2^-32 turns
} GerstnerRing;

// A ring whose centre is relative to the corner of a tile (shared/query_params.h).
typedef struct {
  int tile_x, tile_z;
  GerstnerRing ring;
} GerstnerRingInTile;

// The samples and how many waves and rings move them.
typedef struct {
  float spacing_x_m, spacing_z_m;
  int rows;
  int pitch;  // samples from row to row in memory, at least a block of the kernel
  int wave_count;
  int wave_pitch;  // waves from row to row of turns and amplitudes, a multiple of the device's lanes
  int ring_count;
  int padding;
} GerstnerGrid;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(GerstnerRing) == 24, "no padding");
static_assert(sizeof(GerstnerRingInTile) == 32, "no padding");
static_assert(sizeof(GerstnerGrid) == 32, "no padding");
#endif

#endif
