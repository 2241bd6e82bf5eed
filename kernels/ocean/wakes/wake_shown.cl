// A wake window as it is drawn: its map with foam in place of dh/dt.
// In:  grid; map [n][n] float4 of ocean/wakes/wake_map.cl and shown, both from `first` on; foam [n][n] of
//      ocean/wakes/wake_foam.cl; the share of it that is left; blend [n] float2 as of ocean/wakes/wake_map.cl.
// Out: shown [n][n] float4: h m, dh/dx, dh/dz, foam 0 ... 1.
#include "ocean/wakes/wake_place.clh"

__kernel void wake_shown(WakeGrid grid, __global const float4 *restrict map, __global const float *restrict foam, float left,
                         __global const float2 *restrict blend, int first, __global float4 *restrict shown) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1), place = row * grid.size + column;
  const float share = blend[wake_window_place(column, grid.first_column, grid.size)].x *
                      blend[wake_window_place(row, grid.first_row, grid.size)].x;
  shown[first + place] = (float4)(map[first + place].xyz, left * share * foam[place]);
}
