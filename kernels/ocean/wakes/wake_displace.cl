// How deep a hull presses the water of a wake window, added to what presses there already.
// In:    grid; hull (shared/wake.h); the first column and row of the window that it may reach; samples along a side of the
//        square of a cell, even. Launched over the cells that it may reach.
//        The factor to take it by.
// Inout: displaced [n][n] m: the pressure on the water over its density and gravity; its integral over a hull is the volume
//        that the hull displaces.
// A hull counts in each cell with the mean over the square of two cells a side around it, weighted by a tent, so that the
// weights of all cells add up to 1 everywhere: neither its volume nor its edge jumps from cell to cell as it moves.
#include "ocean/wakes/wake_place.clh"

static float hull_depth(const WakeHullShape *hull, float x_m, float z_m) {
  const float u = (hull->cosine * x_m + hull->sine * z_m) / hull->half_length_m;
  const float v = (hull->cosine * z_m - hull->sine * x_m) / hull->half_beam_m;
  const float square = u * u + v * v;
  if (hull->shape == WAKE_SHAPE_GAUSSIAN) return hull->draught_m * exp(-square);
  return hull->draught_m * sqrt(fmax(1.0f - square, 0.0f));
}

__kernel void wake_displace(WakeGrid grid, WakeHullShape hull, int first_column, int first_row, int samples,
                            float factor, __global float *restrict displaced) {
  const int column = first_column + (int)get_global_id(0), row = first_row + (int)get_global_id(1);
  const float x_m = (float)column * grid.cell_m - hull.x_m, z_m = (float)row * grid.cell_m - hull.z_m;
  float sum = 0.0f, weights = 0.0f;
  for (int j = 0; j < samples; ++j) {
    const float across = (2.0f * (float)j + 1.0f) / (float)samples - 1.0f;
    for (int i = 0; i < samples; ++i) {
      const float along = (2.0f * (float)i + 1.0f) / (float)samples - 1.0f;
      const float weight = (1.0f - fabs(along)) * (1.0f - fabs(across));
      sum += weight * hull_depth(&hull, x_m + along * grid.cell_m, z_m + across * grid.cell_m);
      weights += weight;
    }
  }
  const uint mask = (uint)(grid.size - 1);
  const uint stored_column = (uint)(grid.first_column + column) & mask, stored_row = (uint)(grid.first_row + row) & mask;
  displaced[stored_row * (uint)grid.size + stored_column] += factor * sum / weights;
}
