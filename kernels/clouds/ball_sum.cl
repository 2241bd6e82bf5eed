// Sum of h (C1) of each ball over the middles of the cells of a grid: what normalises it, so that its cells
// hold its mass to the last digit that a float has.
// In: balls [n], places relative to the corner of the grid, m. Out: sums [n], each >= 0.
// Cells beyond the grid count as well: each cell's middle is at (i + 1/2) cell_m.
#include "clouds/metaball.clh"
#include "shared/clouds.h"

__kernel void ball_sum(__global const CloudBall* restrict balls, const float cell_m, __global float* restrict sums) {
  const size_t number = get_global_id(0);
  const CloudBall ball = balls[number];
  // In cells from the middle of cell (low, low, low), so that places lose no digits far from the corner.
  const float radius = ball.radius / cell_m;
  const float low_x = floor(ball.x / cell_m - radius), low_y = floor(ball.y / cell_m - radius);
  const float low_z = floor(ball.z / cell_m - radius);
  const float x = ball.x / cell_m - low_x - 0.5f, y = ball.y / cell_m - low_y - 0.5f;
  const float z = ball.z / cell_m - low_z - 0.5f;
  const int cells = (int)(2.0f * radius) + 2;
  const float per_square = 1.0f / (radius * radius);
  const float8 steps = (float8)(0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f);
  float total = 0.0f;
  for (int k = 0; k < cells; ++k) {
    float8 slice = 0.0f;  // summed apart, so that small parts are not lost in large sums
    for (int j = 0; j < cells; ++j) {
      const float dy = (float)j - y, dz = (float)k - z;
      const float across = (dy * dy + dz * dz) * per_square;
      if (across >= 1.0f) continue;
      for (int i = 0; i < cells; i += 8) {
        const float8 dx = steps + (float)i - x;
        slice += ball_profile8(dx * dx * per_square + across);
      }
    }
    const float4 half_slice = slice.lo + slice.hi;
    total += half_slice.x + half_slice.y + half_slice.z + half_slice.w;
  }
  sums[number] = total;
}
