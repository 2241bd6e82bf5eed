// Particle velocity and pressure head at time t, first pass of the inverse transform: columns along z, for kx >= 0 only.
// In:  amplitude, rate as in ocean/spectrum_advance.cl; time; the depth below the surface and the water's depth.
// Out: intermediate [cascades][4][n][2][FFT_PITCH]: 0: dh/dt   1: u/k   2: kz u/k, with u the horizontal speed   3: the head,
//      the dynamic pressure over density and gravity.
// Linear theory at z = -d under the surface (Wheeler stretching: d is measured from the instantaneous surface):
//   vertical sinh k(D-d) / sinh kD, horizontal cosh k(D-d) / sinh kD, head cosh k(D-d) / cosh kD, all e^{-kd} in deep
//   water.
#include "ocean/mode_grid.clh"
#include "ocean/wave_phase.clh"

#define FFT_COLUMN_KERNEL velocity_advance
#define FFT_COLUMN_PARAMETERS                                                                                \
  __global const float *restrict amplitude, __global const uint *restrict rate,                             \
      __global const float *restrict wavenumber_step_radpm, uint ticks, float tick_fraction, float radps_per_rate, \
      float depth_below_surface_m, float water_depth_m
#define FFT_COLUMN_FIELDS 4
#define FFT_COLUMN_STATE                                                                                     \
  lanes rise_re[FFT_SLOTS], rise_im[FFT_SLOTS], vertical[FFT_SLOTS], horizontal[FFT_SLOTS];                 \
  lanes head_re[FFT_SLOTS], head_im[FFT_SLOTS];                                                              \
  const float step_radpm = wavenumber_step_radpm[batch];

// dh/dt = w (Q cos - P sin); the horizontal velocity is i K/k times that, each with its depth factor.
#define FFT_COLUMN_PREPARE(slot, row, column)                                                             \
  {                                                                                                       \
    const size_t place = mode_place(row, column, FFT_SIZE);                                               \
    __global const float *source = amplitude + (size_t)batch * 4 * MODE_PLANE + place;                    \
    const uint_lanes rates = load_uint_lanes(rate + (size_t)batch * MODE_PLANE + place);                  \
    const lanes inverse_k = inverse_wavenumber(column, row_wavenumber(row, step_radpm), step_radpm);      \
    const lanes k = 1.0f / inverse_k;                                                                     \
    const lanes above_bed = exp(-2.0f * k * fmax(water_depth_m - depth_below_surface_m, 0.0f));           \
    const lanes at_bed = exp(-2.0f * k * water_depth_m), attenuation = exp(-k * depth_below_surface_m);   \
    const lanes decay = attenuation / fmax(1.0f - at_bed, (lanes)1e-6f);                                  \
    const lanes pressure = attenuation * (1.0f + above_bed) / (1.0f + at_bed);                            \
    lanes cosine, sine;                                                                                   \
    wave_phase(rates, ticks, tick_fraction, &cosine, &sine);                                              \
    const lanes omega = convert_lanes(rates) * radps_per_rate;                                            \
    const lanes p_re = load_lanes(source), p_im = load_lanes(source + MODE_PLANE);                        \
    const lanes q_re = load_lanes(source + 2 * MODE_PLANE), q_im = load_lanes(source + 3 * MODE_PLANE);   \
    rise_re[slot] = omega * (q_re * cosine - p_re * sine);                                                \
    rise_im[slot] = omega * (q_im * cosine - p_im * sine);                                                \
    head_re[slot] = pressure * (p_re * cosine + q_re * sine);                                             \
    head_im[slot] = pressure * (p_im * cosine + q_im * sine);                                             \
    vertical[slot] = decay * (1.0f - above_bed);                                                          \
    horizontal[slot] = decay * (1.0f + above_bed) * inverse_k;                                            \
  }

#define FFT_COLUMN_LOAD(field, slot, row, column, re, im)                                                 \
  {                                                                                                       \
    const float kz = (field) == 2 ? row_wavenumber(row, step_radpm) : 1.0f;                               \
    const lanes factor = (field) == 0 ? vertical[slot] : kz * horizontal[slot];                           \
    re = (field) == 3 ? head_re[slot] : factor * rise_re[slot];                                           \
    im = (field) == 3 ? head_im[slot] : factor * rise_im[slot];                                           \
  }
#include "fft/columns.clh"
