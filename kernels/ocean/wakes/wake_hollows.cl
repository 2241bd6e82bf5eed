// How deep raindrops press the water of a wake window, added to what presses there already.
// In:    grid; drops of ocean/wakes/wake_rain.cl, and by how much each presses, m.
// Inout: displaced [n][n] m.
#include "ocean/wakes/wake_place.clh"

static float rain_depth(__global const float2 *drops, int column, int row, int size, float depth_m) {
  const int squares = size / WAKE_RAIN_SQUARE;
  float sum = 0.0f;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      const int square_x = column / WAKE_RAIN_SQUARE + i, square_z = row / WAKE_RAIN_SQUARE + j;
      const float2 drop = drops[(square_z & (squares - 1)) * squares + (square_x & (squares - 1))];
      if (drop.x < 0.0f) continue;
      const float x = (float)(square_x * WAKE_RAIN_SQUARE - column) + drop.x;
      const float z = (float)(square_z * WAKE_RAIN_SQUARE - row) + drop.y;
      sum += exp(-(x * x + z * z) / (WAKE_DROP_RADIUS * WAKE_DROP_RADIUS));
    }
  }
  return depth_m * sum;
}

__kernel void wake_hollows(WakeGrid grid, __global const float2 *restrict drops, float drop_m,
                           __global float *restrict displaced) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  displaced[(size_t)row * grid.size + column] += rain_depth(drops, column, row, grid.size, drop_m);
}
