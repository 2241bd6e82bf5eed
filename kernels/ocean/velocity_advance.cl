// Particle velocity at time t, first pass of the inverse transform: rows along x, for kz >= 0 only.
// In:  amplitude, rate as in ocean/spectrum_advance.cl; time; the depth below the surface and the water's depth.
// Out: intermediate [cascades][3][n/16][rows + 1][2][16]: 0: dh/dt   1: kx u   2: u, with u the horizontal speed over k.
// Linear theory at z = -d under the surface (Wheeler stretching: d is measured from the instantaneous surface):
//   vertical sinh k(D-d) / sinh kD, horizontal cosh k(D-d) / sinh kD, both e^{-kd} in deep water. As exponentials that
//   cannot overflow, with E(x) = e^{-2x} - 1: e^{-kd} E(k(D-d)) / E(kD) and e^{-kd} (2 + E(k(D-d))) / -E(kD).
#include "ocean/wave_phase.clh"

#define FFT_ROW_KERNEL velocity_advance
#define FFT_ROW_PARAMETERS                                                                              \
  __global const float *restrict amplitude, __global const uint *restrict rate,                         \
      __global const float *restrict wavenumber_step_radpm, uint ticks, float tick_fraction, float radps_per_rate, \
      float depth_below_surface_m, float water_depth_m
#define FFT_ROW_FIELDS 3
#define FFT_ROW_STATE                                                                                   \
  lanes rise_re[FFT_SLOTS], rise_im[FFT_SLOTS], vertical[FFT_SLOTS], horizontal[FFT_SLOTS];             \
  const float step_radpm = wavenumber_step_radpm[batch];

// dh/dt = w (Q cos - P sin); the horizontal velocity is i K/k times that, times the ratio of the depth factors.
#define FFT_ROW_PREPARE(slot, row, column)                                                              \
  {                                                                                                     \
    const size_t plane = (size_t)SPECTRUM_ROWS * FFT_SIZE;                                              \
    const size_t place = (size_t)(row) * FFT_SIZE + (column);                                           \
    __global const float *source = amplitude + (size_t)batch * 4 * plane + place;                       \
    const uint_lanes rates = load_uint_lanes(rate + (size_t)batch * plane + place);                     \
    const lanes inverse_k =                                                                             \
        inverse_wavenumber(column_wavenumber(column, step_radpm), (float)(row) * step_radpm);           \
    const lanes k = 1.0f / inverse_k;                                                                   \
    const lanes above_bed = expm1(-2.0f * k * (water_depth_m - depth_below_surface_m));                 \
    const lanes decay = exp(-k * depth_below_surface_m) / expm1(-2.0f * k * water_depth_m);             \
    lanes cosine, sine;                                                                                 \
    wave_phase(rates, ticks, tick_fraction, &cosine, &sine);                                            \
    const lanes omega = convert_lanes(rates) * radps_per_rate;                                          \
    rise_re[slot] = omega * (load_lanes(source + 2 * plane) * cosine - load_lanes(source) * sine);      \
    rise_im[slot] = omega * (load_lanes(source + 3 * plane) * cosine - load_lanes(source + plane) * sine); \
    vertical[slot] = above_bed * decay;                                                                 \
    horizontal[slot] = -(2.0f + above_bed) * decay * inverse_k;                                         \
  }

#define FFT_ROW_LOAD(field, slot, row, column, re, im)                                                  \
  {                                                                                                     \
    lanes factor = (field) == 0 ? vertical[slot] : horizontal[slot];                                    \
    if ((field) == 1) factor *= column_wavenumber(column, step_radpm);                                  \
    re = factor * rise_re[slot];                                                                        \
    im = factor * rise_im[slot];                                                                        \
  }
#include "fft/rows.clh"
