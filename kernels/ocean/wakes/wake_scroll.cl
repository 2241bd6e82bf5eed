// A wake window that has scrolled by whole cells: what has come in is calm water, all else stays where it lies in memory.
// In:    grid as it is now; the columns and rows that it has moved by, of either sign.
// Inout: state [n][n] float2; foam [n][n] of ocean/wakes/wake_foam.cl: 0 where the window was not before.
#include "ocean/wakes/wake_place.clh"

__kernel void wake_scroll(WakeGrid grid, int columns, int rows, __global float2 *restrict state,
                          __global float *restrict foam) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  const int before_x = wake_window_place(column, grid.first_column, grid.size) + columns;
  const int before_z = wake_window_place(row, grid.first_row, grid.size) + rows;
  const bool was_inside = before_x >= 0 && before_x < grid.size && before_z >= 0 && before_z < grid.size;
  if (was_inside) return;
  const size_t place = (size_t)row * grid.size + column;
  state[place] = (float2)(0.0f);
  foam[place] = 0.0f;
}
