// Steep waves of a wake window break: turbulence lowers them towards the slope at which breaking begins. It works as an eddy
// viscosity between samples (Tian et al. 2010), which keeps the volume and takes energy. The steepest waves fade at a rate of 1/e
// in a period of deep water, or more slowly where WAKE_MOST_MIXED limits it.
// In:  grid; state [n][n] float2: height h and second field, whose squares add up to that of the local amplitude A; displaced
//      [n][n] m, by hulls alone; gravity, m/s^2; the time from one launch to the next, s.
// Out: next [n][n], as state. Global size: n / RUN, n.
#include "ocean/wakes/wake_slopes.clh"
#include "shared/wake.h"

// Samples of a row that a work-item takes.
#define RUN 16

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

static inline float largest(float16 values) {
  const float8 eight = fmax(values.lo, values.hi);
  const float4 four = fmax(eight.lo, eight.hi);
  return fmax(fmax(four.x, four.y), fmax(four.z, four.w));
}

// How much either field changes at most from a sample of a run to a neighbour, m.
static inline float largest_change(const WakeWater *water, int row, int first) {
  __global const float *here = (__global const float *)(water->state + wake_sample(water, row, first));
  __global const float *above = (__global const float *)(water->state + wake_sample(water, row - 1, first));
  __global const float *below = (__global const float *)(water->state + wake_sample(water, row + 1, first));
  const float16 low = vload16(0, here), high = vload16(1, here);
  float16 most = fmax(fmax(fabs(vload16(0, above) - low), fabs(vload16(1, above) - high)),
                      fmax(fabs(vload16(0, below) - low), fabs(vload16(1, below) - high)));
  // From each sample to the next: the first eight, and those up to the last.
  most = fmax(most, fmax(fabs(vload16(0, here + 2) - low), fabs(high - vload16(0, here + 14))));
  const float2 before = fabs(water->state[wake_sample(water, row, first - 1)] - low.s01);
  const float2 behind = fabs(water->state[wake_sample(water, row, first + RUN)] - high.sef);
  return fmax(largest(most), fmax(fmax(before.x, before.y), fmax(behind.x, behind.y)));
}

__kernel void wake_break(WakeGrid grid, __global const float2 *restrict state, __global const float *restrict displaced,
                         float gravity_mps2, float since_s, __global float2 *restrict next) {
  const int first = (int)get_global_id(0) * RUN, row = (int)get_global_id(1);
  const WakeWater water = {state, (float2)(1.0f), displaced, grid.size, grid.cell_m};
  const int place = row * grid.size + first;
  // Most water is calm. Two changes of 0.7 of a limit are together below it: 0.7^2 + 0.7^2 < 1.
  if (largest_change(&water, row, first) < 0.7f * LEAST_ALONG * grid.cell_m) {
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
