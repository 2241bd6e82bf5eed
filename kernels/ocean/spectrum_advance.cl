// The spectrum at time t, first pass of the inverse transform: columns along z, for kx >= 0 only.
// In:  amplitude [cascades][4][columns/16][n][16] m and rate [cascades][columns/16][n][16] (ocean/spectrum_initial.cl); time;
//      choppiness a.
// Out: intermediate [cascades][5][n][2][FFT_PITCH], columns transformed along z, of the five fields
//        0: h    1: kz h    2: a h/k    3: a kz h/k    4: a kz^2 h/k
//      Factors of kx commute with a transform along z, so that these five give all eight real fields of the surface, and
//      columns with kx < 0 are conjugates: ocean/surface_assemble.cl makes both.
// Wave K travels toward +K: h = h0(K) e^{-i w t} + conj(h0(-K)) e^{+i w t}. Lee & Lee 2007,
// eq. 2, corrected, 6, 7 and 9 (O2, O6, O7, O10).
#include "ocean/mode_grid.clh"
#include "ocean/wave_phase.clh"

#define FFT_COLUMN_KERNEL spectrum_advance
#define FFT_COLUMN_PARAMETERS                                                                \
  __global const float *restrict amplitude, __global const uint *restrict rate,             \
      __global const float *restrict wavenumber_step_radpm, uint ticks, float tick_fraction, float choppiness
#define FFT_COLUMN_FIELDS 5
#define FFT_COLUMN_STATE                                              \
  lanes height_re[FFT_SLOTS], height_im[FFT_SLOTS], chop[FFT_SLOTS]; \
  const float step_radpm = wavenumber_step_radpm[batch];

#define FFT_COLUMN_PREPARE(slot, row, column)                                                                  \
  {                                                                                                            \
    const size_t place = mode_place(row, column, FFT_SIZE);                                                    \
    __global const float *source = amplitude + (size_t)batch * 4 * MODE_PLANE + place;                         \
    lanes cosine, sine;                                                                                        \
    wave_phase(load_uint_lanes(rate + (size_t)batch * MODE_PLANE + place), ticks, tick_fraction, &cosine, &sine); \
    height_re[slot] = load_lanes(source) * cosine + load_lanes(source + 2 * MODE_PLANE) * sine;                \
    height_im[slot] = load_lanes(source + MODE_PLANE) * cosine + load_lanes(source + 3 * MODE_PLANE) * sine;   \
    chop[slot] = choppiness * inverse_wavenumber(column, row_wavenumber(row, step_radpm), step_radpm);         \
  }

#define FFT_COLUMN_LOAD(field, slot, row, column, re, im)                         \
  {                                                                               \
    const float kz = row_wavenumber(row, step_radpm);                             \
    const float power = (field) == 1 || (field) == 3 ? kz : (field) == 4 ? kz * kz : 1.0f; \
    const lanes factor = (field) < 2 ? (lanes)power : power * chop[slot];         \
    re = factor * height_re[slot];                                                \
    im = factor * height_im[slot];                                                \
  }
#include "fft/columns.clh"
