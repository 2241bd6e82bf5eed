// The end of a step of a wake window: back to heights above the mean level, and what its border absorbs.
// In:  pressed [n][n] float2 after ocean/wakes/wake_turn.cl; displaced [n][n] m as ocean/wakes/wake_press.cl had it; kept [n]: share
//      that a column or row of the window keeps in a step.
// Out: state [n][n] float2: height m, second field m.
#include "ocean/wakes/wake_place.clh"

__kernel void wake_settle(WakeGrid grid, __global const float2 *restrict pressed, __global const float *restrict displaced,
                          __global const float *restrict kept, __global float2 *restrict state) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  const size_t place = (size_t)row * grid.size + column;
  const float share = kept[wake_window_place(column, grid.first_column, grid.size)] *
                      kept[wake_window_place(row, grid.first_row, grid.size)];
  state[place] = share * (pressed[place] - (float2)(displaced[place], 0.0f));
}
