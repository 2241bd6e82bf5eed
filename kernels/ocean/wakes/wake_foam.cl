// Foam of a wake window: faded, spread, and made anew by hulls and breaking waves.
// In:  grid; state [n][n] float2, with the height h in x; displaced [n][n] m, by hulls alone; growth [n][n] m/s, of that depth by
//      the motion of hulls in the water around them; foam [n][n] 0 ... 1; `second`: 1 if slopes are of the second field too, else
//      0; the share of foam that stays; the share of a cell that each neighbour takes.
// Out: next [n][n], as foam. Global size: n / RUN, n.
// Hulls make foam where their surface pushes water away or leaves it behind fast: at the bow and behind the stern. With d the depth
// that they displace, their surface moves along its normal at (dd/dt) / sqrt(1 + |grad d|^2). Turbulence draws in air from about
// 1 m/s on (Chanson 1996). Waves make foam where they break.
#include "ocean/wakes/wake_place.clh"
#include "ocean/wakes/wake_slopes.clh"

#define QUIET_MPS 0.8f
#define TURBULENT_MPS 2.0f

// Foam of the sample at a place, from all around it.
static inline float foam_of_sample(const WakeGrid *grid, const WakeWater *water, __global const float *growth, __global const float *foam,
                                   float kept, float spread, int row, int column) {
  const int size = grid->size, mask = size - 1, place = row * size + column;
  const int left = wake_window_place(column, grid->first_column, size), top = wake_window_place(row, grid->first_row, size);
  float fastest_mps = 0.0f, shallowest_m = water->displaced[place], deepest_m = shallowest_m;
  float around = 0.0f, steepest = 0.0f;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      // Beyond an edge lies the other side of the window.
      if (left + i != (left + i & mask) || top + j != (top + j & mask)) continue;
      const int other = ((row + j) & mask) * size + ((column + i) & mask);
      fastest_mps = fmax(fastest_mps, fabs(growth[other]));
      shallowest_m = fmin(shallowest_m, water->displaced[other]);
      deepest_m = fmax(deepest_m, water->displaced[other]);
      if ((i == 0) == (j == 0)) continue;
      around += foam[other] - foam[place];
      steepest = fmax(steepest, wake_slope(water, row, column, j, i));
    }
  }
  const float hull_slope = (deepest_m - shallowest_m) / (2.0f * grid->cell_m);
  const float speed_mps = fastest_mps / sqrt(1.0f + hull_slope * hull_slope);
  const float of_hulls = ramp(QUIET_MPS, TURBULENT_MPS, speed_mps);
  const float made = fmax(of_hulls, ramp(BREAKING_SLOPE, STEEPEST_SLOPE, steepest));
  return fmax(kept * (foam[place] + spread * around), made);
}

// The same of a run, where nothing makes foam.
static inline float16 foam_that_spreads(const WakeGrid *grid, __global const float *foam, float kept, float spread, int row, int first) {
  const int size = grid->size, mask = size - 1, place = row * size + first;
  const int16 lane = (int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  const int16 left = (wake_window_place(first, grid->first_column, size) + lane) & mask;
  const int top = wake_window_place(row, grid->first_row, size);
  const float16 here = vload16(0, foam + place), none = (float16)(0.0f);
  const float16 before = (float16)(foam[row * size + ((first - 1) & mask)], here.s012, here.s3456, here.s789a, here.sbcde);
  const float16 behind = (float16)(here.s123, here.s4567, here.s89ab, here.scdef, foam[row * size + ((first + RUN) & mask)]);
  float16 around = none;
  if (top != 0) around += vload16(0, foam + ((row - 1) & mask) * size + first) - here;
  around += select(none, before - here, left != 0);
  around += select(none, behind - here, left != mask);
  if (top != mask) around += vload16(0, foam + ((row + 1) & mask) * size + first) - here;
  return fmax(kept * (here + spread * around), none);
}

// Whether hulls move at a run or beside it.
static inline bool has_growth(__global const float *growth, int size, int row, int first) {
  const int mask = size - 1;
  float16 most = (float16)(0.0f);
  float beside = 0.0f;
  for (int j = -1; j <= 1; ++j) {
    __global const float *line = growth + ((row + j) & mask) * size;
    most = fmax(most, fabs(vload16(0, line + first)));
    beside = fmax(beside, fmax(fabs(line[(first - 1) & mask]), fabs(line[(first + RUN) & mask])));
  }
  return largest(most) > 0.0f || beside > 0.0f;
}

__kernel void wake_foam(WakeGrid grid, __global const float2 *restrict state, __global const float *restrict displaced,
                        __global const float *restrict growth, __global const float *restrict foam, float second, float kept, float spread,
                        __global float *restrict next) {
  const int first = (int)get_global_id(0) * RUN, row = (int)get_global_id(1), place = row * grid.size + first;
  const WakeWater water = {state, (float2)(1.0f, second), displaced, grid.size, grid.cell_m};
  if (!has_growth(growth, grid.size, row, first) && is_calm(&water, row, first)) {
    vstore16(foam_that_spreads(&grid, foam, kept, spread, row, first), 0, next + place);
    return;
  }
  for (int i = 0; i < RUN; ++i) {
    next[place + i] = foam_of_sample(&grid, &water, growth, foam, kept, spread, row, first + i);
  }
}
