// The raindrops of one step of a wake window.
// In:  grid; seed; the number of the step; how likely a drop is on a square of WAKE_RAIN_SQUARE cells in a step.
// Out: drops [n/8][n/8] float2, of each square of memory: where its drop falls, in cells from the square's corner;
//      x < 0: none falls.
// Drops are of the square of the world and of the step: they fall wherever the window lies.
#include "ocean/wakes/wake_place.clh"
#include "shared/random.h"

__kernel void wake_rain(WakeGrid grid, uint2 seed, uint step, float probability, __global float2 *restrict drops) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  const int x = grid.first_column + wake_window_place(column * WAKE_RAIN_SQUARE, grid.first_column, grid.size);
  const int z = grid.first_row + wake_window_place(row * WAKE_RAIN_SQUARE, grid.first_row, grid.size);
  const PhiloxBlock block =
      philox_block(seed.x, seed.y, OFFING_STREAM_WAKE_RAIN, x >> 3, z >> 3, step);
  const float square = (float)WAKE_RAIN_SQUARE;
  const bool falls = uniform_open01(block.v[0]) < probability;
  drops[row * (grid.size / WAKE_RAIN_SQUARE) + column] =
      falls ? square * (float2)(uniform_open01(block.v[1]), uniform_open01(block.v[2])) : (float2)(-1.0f);
}
