// Gerstner waves and rings on a regular grid of rest labels.
// In:  waves, rings and grid (shared/trochoids.h), at one time.
// Out: displacement [rows][pitch] float4 (dx m, h m, dz m, d dx/dz),
//      gradient     [rows][pitch] float4 (dh/dx, dh/dz, d dx/dx, d dz/dz), row = z, column = x, at rest labels: the layout
//      of ocean/surface_assemble.cl, so that both parts of the sea add before F is taken (O9).
// With phase p = K X - w t of each wave: h = A cos p, (dx, dz) = -Q A K/k sin p, which sharpens crests. Lee & Lee 2007,
// eq. 8, up to phase (O8). Phases are whole numbers of 2^-32 turns, stepped exactly from sample to sample.
// On a CPU (LANES > 1) a work-item computes a row, LANES columns at a time, and dimension 0 has one work-item; on a GPU
// (LANES = 1) it computes one sample.
#include "ocean/wave_phase.clh"
#include "shared/trochoids.h"

typedef struct {
  lanes shift_x, height, shift_z;
  lanes slope_x, slope_z;
  lanes gradient_xx, gradient_xz, gradient_zz;
} Sums;

FFT_INLINE void add_wave(__global const TrochoidWave *wave, uint row, uint column, Sums *sums) {
  const uint column_step = as_uint(wave->column_step);
  const uint first = as_uint(wave->phase) + row * as_uint(wave->row_step) + column * column_step;
  lanes cosine, sine;
  cosine_sine_of_turns(first + convert_uint_lanes(LANE_INDEX) * column_step, &cosine, &sine);
  sums->height += wave->amplitude_m * cosine;
  sums->slope_x -= wave->slope_x * sine;
  sums->slope_z -= wave->slope_z * sine;
  sums->shift_x -= wave->shift_x_m * sine;
  sums->shift_z -= wave->shift_z_m * sine;
  sums->gradient_xx -= wave->gradient_xx * cosine;
  sums->gradient_xz -= wave->gradient_xz * cosine;
  sums->gradient_zz -= wave->gradient_zz * cosine;
}

// A ring of waves moves the surface up and down only. With r the distance from its centre, rounded off within a
// quarter of a wavelength l so that the middle is smooth, and u = r - ring radius:
//   h = A sqrt(l / (l + r)) exp(-(u / 2 l)^2) cos(2 pi u / l + phase)
FFT_INLINE void add_ring(__global const TrochoidRing *ring, lanes x_m, lanes z_m, Sums *sums) {
  const float wavelength_m = ring->wavelength_m, per_wavelength = 1.0f / wavelength_m;
  const float rounding_m = 0.25f * wavelength_m;
  const lanes x = x_m - ring->centre_x_m, z = z_m - ring->centre_z_m;
  const lanes hypotenuse = sqrt(x * x + z * z + rounding_m * rounding_m);
  const lanes distance = (hypotenuse - rounding_m) * per_wavelength;
  // Beyond 15 wavelengths from the ring nothing is left (e^-56), and its phase is not wanted.
  const lanes u = clamp(distance - ring->ring_radius_m * per_wavelength, (lanes)-15.0f, (lanes)15.0f);
  const lanes envelope = ring->amplitude_m * rsqrt(1.0f + distance) * exp(-0.25f * u * u);
  lanes cosine, sine;
  // 2^27 = 2^32 / 32: whole turns, 16 of them here, leave through the high bits.
  const uint_lanes turns = convert_uint_lanes((u + 16.0f) * 134217728.0f) << 5;
  cosine_sine_of_turns(turns + as_uint(ring->phase), &cosine, &sine);
  const float two_pi = 6.2831853072f;
  const lanes slope = envelope * per_wavelength *
                      ((-0.5f / (1.0f + distance) - 0.5f * u) * cosine - two_pi * sine) / hypotenuse;
  sums->height += envelope * cosine;
  sums->slope_x += slope * x;
  sums->slope_z += slope * z;
}

__kernel void trochoid_surface(__global const TrochoidWave *restrict waves, __global const TrochoidRing *restrict rings,
                               TrochoidGrid grid, __global float *restrict displacement,
                               __global float *restrict gradient) {
  const int row = (int)get_global_id(1);
  const int stride = (int)get_global_size(0) * LANES;
  for (int first = (int)get_global_id(0) * LANES; first < grid.pitch; first += stride) {
    // The last vector of a row moves back to end with it: some samples are computed twice, by the same work-item.
    const int column = min(first, grid.pitch - LANES);
    const lanes zero = (lanes)0.0f;
    Sums sums = {zero, zero, zero, zero, zero, zero, zero, zero};
    for (int i = 0; i < grid.wave_count; ++i) add_wave(waves + i, (uint)row, (uint)column, &sums);
    const lanes x_m = ((float)column + LANE_INDEX) * grid.spacing_x_m;
    const lanes z_m = (lanes)((float)row * grid.spacing_z_m);
    for (int i = 0; i < grid.ring_count; ++i) add_ring(rings + i, x_m, z_m, &sums);
    const size_t place = ((size_t)row * grid.pitch + column) * 4;
    store_interleaved_4(sums.shift_x, sums.height, sums.shift_z, sums.gradient_xz, displacement + place);
    store_interleaved_4(sums.slope_x, sums.slope_z, sums.gradient_xx, sums.gradient_zz, gradient + place);
  }
}
