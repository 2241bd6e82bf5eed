// Steep waves of a wake window break: turbulence lowers them towards the slope at which breaking begins. It works as an eddy
// viscosity between samples (Tian et al. 2010), which keeps the volume and takes energy. The steepest waves fade at a rate of 1/e
// in a period of deep water, or more slowly where WAKE_MOST_MIXED limits it.
// In:  grid; state [n][n] float2: height h and second field, whose squares add up to that of the local amplitude A; displaced
//      [n][n] m, by hulls alone; gravity, m/s^2; the time from one launch to the next, s.
// Out: next [n][n], as state. Global size: n / RUN, n.
#include "ocean/wakes/wake_slopes.clh"
#include "shared/wake.h"

// What flows from a neighbour, some rows or columns on.
static inline float2 mixed_from(const WakeWater *water, float gravity_mps2, float since_s, int row, int column, int rows,
                                int columns) {
  const float slope = wake_slope(water, row, column, rows, columns);
  if (!(slope > BREAKING_SLOPE)) return (float2)(0.0f);
  const float2 here = water->state[wake_sample(water, row, column)];
  const float2 there = water->state[wake_sample(water, row + rows, column + columns)];
  // A wave of slope k A and period 2 pi / sqrt(g k) fades by k^2 times the viscosity in a second.
  const float length_m = sqrt(0.5f * (dot(here, here) + dot(there, there))) / slope;
  const float viscosity_m2ps =
      ramp(BREAKING_SLOPE, STEEPEST_SLOPE, slope) * sqrt(gravity_mps2 * length_m) * length_m / 6.2831853f;
  return fmin(viscosity_m2ps * since_s / (water->cell_m * water->cell_m), WAKE_MOST_MIXED) * (there - here);
}

__kernel void wake_break(WakeGrid grid, __global const float2 *restrict state, __global const float *restrict displaced,
                         float gravity_mps2, float since_s, __global float2 *restrict next) {
  const int first = (int)get_global_id(0) * RUN, row = (int)get_global_id(1);
  const WakeWater water = {state, (float2)(1.0f), displaced, grid.size, grid.cell_m};
  const int place = row * grid.size + first;
  if (is_calm(&water, row, first)) {
    vstore16(vload16(0, (__global const float *)(state + place)), 0, (__global float *)(next + place));
    vstore16(vload16(1, (__global const float *)(state + place)), 1, (__global float *)(next + place));
    return;
  }
  for (int column = first; column < first + RUN; ++column) {
    next[place + column - first] = state[place + column - first] +
                                   mixed_from(&water, gravity_mps2, since_s, row, column, 0, -1) +
                                   mixed_from(&water, gravity_mps2, since_s, row, column, 0, 1) +
                                   mixed_from(&water, gravity_mps2, since_s, row, column, -1, 0) +
                                   mixed_from(&water, gravity_mps2, since_s, row, column, 1, 0);
  }
}
