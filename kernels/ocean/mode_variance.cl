// Expected variance of each mode of one cascade.
// In:  table [nk][nd] m^2, T(ln k, theta) = P(K) k^2, direction theta from +x toward +z, periodic.
// Out: variance [n][n] m^2, row-major, K = 0 at [0][0]: the integral of P(K) over the mode's cell of the wavenumber plane
//      (dk x dk around K), as far as it lies in the band k_min <= |K| < k_max. So the sum over all modes keeps the energy
//      of features narrower than a cell, and bands that touch share the cells on their border without overlap.
//      K = 0 and the Nyquist row and column, which have no partner, carry nothing.
// Lee & Lee 2007, eq. 4 and 5, with the cell's size and any spectrum (O4, O5).
#include "shared/ocean_params.h"

// Points along a cell's edge: features of 2 % of k are seen at every k, and cells that the band's edge cuts get at least
// 8 x 8 points, 1 % of their share.
#define POINTS_AT_UNIT_RADIUS 48.0f
#define LEAST_POINTS_ON_EDGE 8

static float table_at(__global const float *table, OceanSpectrumParams params, float kx, float kz, float k_squared) {
  const float wavenumber_place = (0.5f * log(k_squared) - params.log_k_first) / params.log_k_step;
  if (!(wavenumber_place >= 0.0f) || wavenumber_place >= (float)(params.wavenumber_count - 1)) return 0.0f;
  const int i = (int)wavenumber_place;
  const float u = wavenumber_place - (float)i;
  float direction_place = atan2pi(kz, kx) * 0.5f * (float)params.direction_count;
  if (direction_place < 0.0f) direction_place += (float)params.direction_count;
  const float direction_floor = floor(direction_place);
  const float v = direction_place - direction_floor;
  const int j0 = (int)direction_floor % params.direction_count;
  const int j1 = (j0 + 1) % params.direction_count;
  __global const float *row = table + (size_t)i * params.direction_count;
  __global const float *next = row + params.direction_count;
  return mix(mix(row[j0], row[j1], v), mix(next[j0], next[j1], v), u);
}

__kernel void mode_variance(__global const float *restrict table, OceanSpectrumParams params, int size,
                            __global float *restrict variance) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  const int n = column < size / 2 ? column : column - size;
  const int m = row < size / 2 ? row : row - size;
  float sum = 0.0f;
  if ((n != 0 || m != 0) && n != -size / 2 && m != -size / 2) {
    const float step = params.wavenumber_step_radpm;
    const float radius = sqrt((float)(n * n + m * m));
    int points = (int)ceil(POINTS_AT_UNIT_RADIUS / radius);
    const float half_diagonal = 0.7072f * step;
    if (fabs(radius * step - params.k_min_radpm) < half_diagonal ||
        fabs(radius * step - params.k_max_radpm) < half_diagonal) {
      points = max(points, LEAST_POINTS_ON_EDGE);
    }
    const float k_min_squared = params.k_min_radpm * params.k_min_radpm;
    const float k_max_squared = params.k_max_radpm * params.k_max_radpm;
    const float spacing = 1.0f / (float)points;
    for (int i = 0; i < points; ++i) {
      const float kz = ((float)m - 0.5f + ((float)i + 0.5f) * spacing) * step;
      for (int j = 0; j < points; ++j) {
        const float kx = ((float)n - 0.5f + ((float)j + 0.5f) * spacing) * step;
        const float k_squared = kx * kx + kz * kz;
        if (k_squared >= k_min_squared && k_squared < k_max_squared) {
          sum += table_at(table, params, kx, kz, k_squared) / k_squared;
        }
      }
    }
    sum *= step * step * spacing * spacing;
  }
  variance[(size_t)row * size + column] = sum;
}
