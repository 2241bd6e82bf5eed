// Foam of a wake window: faded, spread, and made anew by hulls and breaking waves.
// In:  grid; state [n][n] float2, with the height h in x; displaced [n][n] m, by hulls alone; growth [n][n] m/s, of that depth by
//      the motion of hulls in the water around them; foam [n][n] 0 ... 1; `second`: 1 if slopes are of the second field too, else
//      0; the share of foam that stays; the share of a cell that each neighbour takes.
// Out: next [n][n], as foam.
// Hulls make foam where their surface pushes water away or leaves it behind fast: at the bow and behind the stern. With d the depth
// that they displace, their surface moves along its normal at (dd/dt) / sqrt(1 + |grad d|^2). Turbulence draws in air from about
// 1 m/s on (Chanson 1996). Waves make foam where they break.
#include "ocean/wakes/wake_place.clh"
#include "ocean/wakes/wake_slopes.clh"

#define QUIET_MPS 0.8f
#define TURBULENT_MPS 2.0f

__kernel void wake_foam(WakeGrid grid, __global const float2 *restrict state, __global const float *restrict displaced,
                        __global const float *restrict growth, __global const float *restrict foam, float second, float kept, float spread,
                        __global float *restrict next) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1), size = grid.size, mask = size - 1;
  const int place = row * size + column;
  const int left = wake_window_place(column, grid.first_column, size), top = wake_window_place(row, grid.first_row, size);
  const WakeWater water = {state, (float2)(1.0f, second), displaced, size, grid.cell_m};
  float fastest_mps = 0.0f, shallowest_m = displaced[place], deepest_m = shallowest_m;
  float around = 0.0f, steepest = 0.0f;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      // Beyond an edge lies the other side of the window.
      if (left + i != (left + i & mask) || top + j != (top + j & mask)) continue;
      const int other = ((row + j) & mask) * size + ((column + i) & mask);
      fastest_mps = fmax(fastest_mps, fabs(growth[other]));
      shallowest_m = fmin(shallowest_m, displaced[other]);
      deepest_m = fmax(deepest_m, displaced[other]);
      if ((i == 0) == (j == 0)) continue;
      around += foam[other] - foam[place];
      steepest = fmax(steepest, wake_slope(&water, row, column, j, i));
    }
  }
  const float hull_slope = (deepest_m - shallowest_m) / (2.0f * grid.cell_m);
  const float speed_mps = fastest_mps / sqrt(1.0f + hull_slope * hull_slope);
  const float of_hulls = ramp(QUIET_MPS, TURBULENT_MPS, speed_mps);
  const float made = fmax(of_hulls, ramp(BREAKING_SLOPE, STEEPEST_SLOPE, steepest));
  next[place] = fmax(kept * (foam[place] + spread * around), made);
}
