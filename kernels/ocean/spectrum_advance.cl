// The spectrum at time t, first pass of the inverse transform: rows along x, for kz >= 0 only.
// In:  amplitude [cascades][4][rows][n] m and rate [cascades][rows][n] (ocean/spectrum_initial.cl); time; choppiness.
// Out: intermediate [cascades][5][n/16][rows + 1][2][16], rows transformed along x, of the five fields
//        0: h    1: kx h    2: a h/k    3: a kx h/k    4: a kx^2 h/k        a = choppiness
//      Factors of kz commute with a transform along x, so that these five give all eight real fields of the surface,
//      and rows with kz < 0 are conjugates: ocean/surface_assemble.cl makes both.
// Wave K travels toward +K: h = h0(K) e^{-i w t} + conj(h0(-K)) e^{+i w t}. Lee & Lee 2007 eq. 2, corrected (PAPERS O2,
// O6, O7, O10).
#include "ocean/wave_phase.clh"

#define FFT_ROW_KERNEL spectrum_advance
#define FFT_ROW_PARAMETERS                                                                   \
  __global const float *restrict amplitude, __global const uint *restrict rate,             \
      __global const float *restrict wavenumber_step_radpm, uint ticks, float tick_fraction, float choppiness
#define FFT_ROW_FIELDS 5
#define FFT_ROW_STATE                                                 \
  lanes height_re[FFT_SLOTS], height_im[FFT_SLOTS], chop[FFT_SLOTS]; \
  const float step_radpm = wavenumber_step_radpm[batch];

#define FFT_ROW_PREPARE(slot, row, column)                                                                \
  {                                                                                                       \
    const size_t plane = (size_t)SPECTRUM_ROWS * FFT_SIZE;                                                \
    const size_t place = (size_t)(row) * FFT_SIZE + (column);                                             \
    __global const float *source = amplitude + (size_t)batch * 4 * plane + place;                         \
    lanes cosine, sine;                                                                                   \
    wave_phase(load_uint_lanes(rate + (size_t)batch * plane + place), ticks, tick_fraction, &cosine, &sine); \
    height_re[slot] = load_lanes(source) * cosine + load_lanes(source + 2 * plane) * sine;                \
    height_im[slot] = load_lanes(source + plane) * cosine + load_lanes(source + 3 * plane) * sine;        \
    chop[slot] = choppiness * inverse_wavenumber(column_wavenumber(column, step_radpm), (float)(row) * step_radpm); \
  }

#define FFT_ROW_LOAD(field, slot, row, column, re, im)                                       \
  {                                                                                          \
    const lanes kx = column_wavenumber(column, step_radpm);                                  \
    lanes factor = (field) < 2 ? (lanes)1.0f : chop[slot];                                   \
    if ((field) == 1 || (field) == 3) factor *= kx;                                          \
    if ((field) == 4) factor *= kx * kx;                                                     \
    re = factor * height_re[slot];                                                           \
    im = factor * height_im[slot];                                                           \
  }
#include "fft/rows.clh"
