// One Verlet step of the wave equation on a wake window (O14).
// In:  state [n][n] float2: height h m, and s m with dh/dt = -c a laplacian s, ds/dt = -c/a (h + displaced), a the cell:
//      together d2h/dt2 = c^2 laplacian (h + displaced), waves of one speed c; displaced [n][n] m; kept [n]: share that a column or
//      row of the window keeps; courant = c dt / cell.
// Out: next [n][n] float2. s is half a step behind h, so that h is that of Verlet's scheme: h_2 - 2 h_1 + h_0 =
//      courant^2 D (h_1 + displaced), D the second differences of fourth order: those of second order would slow waves of
//      four cells down by a tenth.
#include "ocean/wakes/wake_differences.clh"

__kernel void wake_verlet(WakeGrid grid, __global const float2 *restrict state, __global const float *restrict displaced,
                          __global const float *restrict kept, float courant, __global float2 *restrict next) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  int places[WAKE_STENCIL];
  wake_stencil(column, row, grid.size, places);
  float second[WAKE_STENCIL];
  for (int i = 0; i < WAKE_STENCIL; ++i) {
    second[i] = state[places[i]].y - courant * (state[places[i]].x + displaced[places[i]]);
  }
  const float share = kept[wake_window_place(column, grid.first_column, grid.size)] *
                      kept[wake_window_place(row, grid.first_row, grid.size)];
  next[places[0]] = share * (float2)(state[places[0]].x - courant * wake_bend(second), second[0]);
}
