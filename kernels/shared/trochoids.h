// Arrays and parameters of ocean/trochoid_surface.cl, one layout for host and device: 4-byte scalars only,
// padding written out.
#ifndef OFFING_KERNELS_SHARED_TROCHOIDS_H
#define OFFING_KERNELS_SHARED_TROCHOIDS_H

// Waves at most.
#define TROCHOID_WAVES 128

// Rows of turns [4][pitch of waves], in 2^-32 turns: sums that overflow lose whole turns, and nothing else.
#define TROCHOID_PHASE 0        // at the first sample, time 0
#define TROCHOID_COLUMN_STEP 1  // from column to column
#define TROCHOID_ROW_STEP 2
#define TROCHOID_RATE 3  // cycles per 2^32 ticks, as in ocean/wave_phase.clh
#define TROCHOID_TURNS 4

// Rows of amplitudes [8][pitch of waves]: what each field is times the cosine or the sine of the phase. With
// A the amplitude, (kx, kz) = K and Q the scale of the horizontal displacement:
#define TROCHOID_HEIGHT 0       // cosine, A
#define TROCHOID_GRADIENT_XX 1  // cosine, -Q A kx kx / k
#define TROCHOID_GRADIENT_XZ 2  // cosine, -Q A kx kz / k
#define TROCHOID_GRADIENT_ZZ 3  // cosine, -Q A kz kz / k
#define TROCHOID_SHIFT_X 4      // sine, -Q A kx / k
#define TROCHOID_SHIFT_Z 5      // sine, -Q A kz / k
#define TROCHOID_SLOPE_X 6      // sine, -A kx
#define TROCHOID_SLOPE_Z 7      // sine, -A kz
#define TROCHOID_FIELDS 8
#define TROCHOID_COSINE_FIELDS 4  // the first ones

// One ring of waves around a point.
typedef struct {
  float centre_x_m, centre_z_m;  // from the first sample
  float wavelength_m;
  float ring_radius_m;  // where the ring is
  float amplitude_m;    // at this time, at the centre
  int phase;            // at the ring's crest, 2^-32 turns
} TrochoidRing;

// A ring whose centre is relative to the corner of a tile (shared/surface_query.h).
typedef struct {
  int tile_x, tile_z;
  TrochoidRing ring;
} TrochoidRingInTile;

// The samples and how many waves and rings move them.
typedef struct {
  float spacing_x_m, spacing_z_m;
  int rows;
  int pitch;  // samples from row to row in memory, at least a block of the kernel
  int wave_count;
  int wave_pitch;  // waves from row to row of turns and amplitudes, a multiple of the device's lanes
  int ring_count;
  int padding;
} TrochoidGrid;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(TrochoidRing) == 24, "no padding");
static_assert(sizeof(TrochoidRingInTile) == 32, "no padding");
static_assert(sizeof(TrochoidGrid) == 32, "no padding");
#endif

#endif
