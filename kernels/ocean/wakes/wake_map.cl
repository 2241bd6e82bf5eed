// The map of a wake window that is drawn and asked: its waves, faded to nothing at its border.
// In:  fields [2][n][n] float2 of ocean/wakes/wake_spectrum.cl after the transform, or of ocean/wakes/wake_differences.cl; blend [n]
//      float2: share of a column or row of the window, 0 at its ends, and the share's derivative, 1/m.
// Out: map [n][n] float4 from `first` on: h m, dh/dx, dh/dz, dh/dt m/s; the slopes are those of the faded height.
#include "ocean/wakes/wake_place.clh"

__kernel void wake_map(WakeGrid grid, __global const float2 *restrict fields, __global const float2 *restrict blend,
                       int first, __global float4 *restrict map) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  const size_t place = (size_t)row * grid.size + column;
  const float2 height = fields[place], slope = fields[place + (size_t)grid.size * grid.size];
  const float2 x = blend[wake_window_place(column, grid.first_column, grid.size)];
  const float2 z = blend[wake_window_place(row, grid.first_row, grid.size)];
  const float share = x.x * z.x;
  map[first + place] = (float4)(share * height.x, share * slope.x + x.y * z.x * height.x,
                                share * slope.y + x.x * z.y * height.x, share * height.y);
}
