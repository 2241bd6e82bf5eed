// How deep a floating hull presses the water of a wake window, added to what presses there already.
// In:    press (shared/bodies.h); bottom [map_rows][map_columns] m: the hull's underside, +inf beside it.
// Inout: displaced [n][n] m, laid out as WakeGrid of shared/wake.h says.
// Launched over the cells around the hull and some more. As in ocean/wakes/wake_displace.cl a cell takes the mean over the square of two cells
// a side around it, weighted by a tent, so that the hull's volume does not jump as it moves.
#include "shared/bodies.h"

#define SAMPLES 4  // along a side of that square

static float depth_at(__global const float *bottom, const HullPress *press, float along, float across) {
  const int column = convert_int_rtn(along + 0.5f), row = convert_int_rtn(across + 0.5f);
  const bool is_on_map = column >= 0 && column < press->map_columns && row >= 0 && row < press->map_rows;
  if (!is_on_map) return 0.0f;
  return fmax(press->level_m - bottom[row * press->map_columns + column], 0.0f);
}

__kernel void hull_press(const HullPress press, __global const float *restrict bottom, __global float *restrict displaced) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  if (column >= press.columns || row >= press.rows) return;
  float sum = 0.0f, weights = 0.0f;
  for (int j = 0; j < SAMPLES; ++j) {
    const float south = (2.0f * (float)j + 1.0f) / (float)SAMPLES - 1.0f;
    for (int i = 0; i < SAMPLES; ++i) {
      const float east = (2.0f * (float)i + 1.0f) / (float)SAMPLES - 1.0f;
      const float weight = (1.0f - fabs(east)) * (1.0f - fabs(south));
      const float x = (float)column + east, z = (float)row + south;
      sum += weight * depth_at(bottom, &press, press.along + x * press.along_by_column + z * press.along_by_row,
                               press.across + x * press.across_by_column + z * press.across_by_row);
      weights += weight;
    }
  }
  if (sum == 0.0f) return;
  const uint mask = (uint)(press.size - 1);
  const uint stored_column = (uint)(press.first_column + column) & mask, stored_row = (uint)(press.first_row + row) & mask;
  displaced[stored_row * (uint)press.size + stored_column] += press.factor * sum / weights;
}
