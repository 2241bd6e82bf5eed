// How deep hulls and raindrops press the water of a wake window.
// In:  grid; hulls (shared/wake.h); drops of ocean/wakes/wake_rain.cl, and by how much each presses, m, 0 without rain.
// Out: displaced [n][n] m: the pressure on the water over its density and gravity; its integral over a hull is the volume
//      that the hull displaces.
// A hull counts in each cell with the mean over the square of two cells a side around it, weighted by a tent, so that the
// weights of all cells add up to 1 everywhere: neither its volume nor its edge jumps from cell to cell as it moves.
#include "ocean/wakes/wake_place.clh"

#define SAMPLES 6  // along a side of that square

static float hull_depth(__global const WakeHullShape *hull, float x_m, float z_m) {
  const float u = (hull->cosine * x_m + hull->sine * z_m) / hull->half_length_m;
  const float v = (hull->cosine * z_m - hull->sine * x_m) / hull->half_beam_m;
  const float square = u * u + v * v;
  if (hull->shape == WAKE_SHAPE_GAUSSIAN) return hull->draught_m * exp(-square);
  return hull->draught_m * sqrt(fmax(1.0f - square, 0.0f));
}

static float hull_mean(__global const WakeHullShape *hull, float x_m, float z_m, float cell_m) {
  const float reach = hull->shape == WAKE_SHAPE_GAUSSIAN ? WAKE_GAUSSIAN_REACH : 1.0f;
  // A corner of the square is sqrt(2) cells away.
  const float along_m = hull->cosine * x_m + hull->sine * z_m, across_m = hull->cosine * z_m - hull->sine * x_m;
  if (fabs(along_m) > reach * hull->half_length_m + 1.5f * cell_m ||
      fabs(across_m) > reach * hull->half_beam_m + 1.5f * cell_m)
    return 0.0f;
  float sum = 0.0f, weights = 0.0f;
  for (int j = 0; j < SAMPLES; ++j) {
    const float across = (2.0f * (float)j + 1.0f) / (float)SAMPLES - 1.0f;
    for (int i = 0; i < SAMPLES; ++i) {
      const float along = (2.0f * (float)i + 1.0f) / (float)SAMPLES - 1.0f;
      const float weight = (1.0f - fabs(along)) * (1.0f - fabs(across));
      sum += weight * hull_depth(hull, x_m + along * cell_m, z_m + across * cell_m);
      weights += weight;
    }
  }
  return sum / weights;
}

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

__kernel void wake_displace(WakeGrid grid, __global const WakeHullShape *restrict hulls, int hull_count,
                            __global const float2 *restrict drops, float drop_m, __global float *restrict displaced) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  const float x_m = (float)wake_window_place(column, grid.first_column, grid.size) * grid.cell_m;
  const float z_m = (float)wake_window_place(row, grid.first_row, grid.size) * grid.cell_m;
  float depth_m = drop_m == 0.0f ? 0.0f : rain_depth(drops, column, row, grid.size, drop_m);
  for (int i = 0; i < hull_count; ++i) {
    depth_m += hull_mean(hulls + i, x_m - hulls[i].x_m, z_m - hulls[i].z_m, grid.cell_m);
  }
  displaced[(size_t)row * grid.size + column] = depth_m;
}
