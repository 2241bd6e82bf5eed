// The long waves of a sea: its modes without those beyond a wavenumber.
// In:  amplitude [cascades][4][columns/16][n][16] m of ocean/spectrum_initial.cl; wavenumber_step_radpm [cascades].
// Out: filtered, laid out alike: 0 where |K| > k_max.
#include "shared/mode_layout.h"

__kernel void mode_filter(__global const float *restrict amplitude, __global const float *restrict wavenumber_step_radpm,
                          int columns, int size, float k_max_radpm, __global float *restrict filtered) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1), cascade = (int)get_global_id(2);
  const float z = (float)(row < size / 2 ? row : row - size), x = (float)column;
  const float k_radpm = sqrt(x * x + z * z) * wavenumber_step_radpm[cascade];
  const size_t plane = mode_plane_size(columns, size);
  for (int part = 0; part < 4; ++part) {
    const size_t place = ((size_t)cascade * 4 + part) * plane + mode_place(row, column, size);
    filtered[place] = k_radpm > k_max_radpm ? 0.0f : amplitude[place];
  }
}
