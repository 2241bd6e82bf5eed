// Parameters of ocean/trochoid_surface.cl, one layout for host and device: 4-byte scalars only, padding
// written out. Phases are in 2^-32 turns, in two's complement: sums that overflow lose whole turns, and
// nothing else.
#ifndef OFFING_KERNELS_SHARED_TROCHOIDS_H
#define OFFING_KERNELS_SHARED_TROCHOIDS_H

// One wave A cos(phase), with (kx, kz) = K and Q the scale of the horizontal displacement.
typedef struct {
  int phase;        // at the first sample
  int column_step;  // from column to column
  int row_step;
  float amplitude_m;
  float slope_x, slope_z;                       // A kx, A kz
  float shift_x_m, shift_z_m;                   // Q A kx / k, Q A kz / k
  float gradient_xx, gradient_xz, gradient_zz;  // Q A kx kx / k, Q A kx kz / k, Q A kz kz / k
  int padding;
} TrochoidWave;

// One ring of waves around a point.
typedef struct {
  float centre_x_m, centre_z_m;  // from the first sample
  float wavelength_m;
  float ring_radius_m;  // where the ring is
  float amplitude_m;    // at this time, at the centre
  int phase;            // at the ring's crest
} TrochoidRing;

// The samples and how many waves and rings move them.
typedef struct {
  float spacing_x_m, spacing_z_m;
  int pitch;  // samples from row to row in memory, at least as many as a vector has lanes
  int wave_count;
  int ring_count;
  int padding;
} TrochoidGrid;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(TrochoidWave) == 48, "no padding");
static_assert(sizeof(TrochoidRing) == 24, "no padding");
static_assert(sizeof(TrochoidGrid) == 24, "no padding");
#endif

#endif
