// Extinction of each cell of the clouds' grids: each particle's optical mass, spread by a tent along each axis that has
// the variance of h, 0.1041 R^2, or is a cell wide. Mass is kept. A work-item owns rows of cells of one cloud and
// takes particles in their order, so that sums round alike on all devices.
// In:  particles, grids; rows_per_item. Global size: row items, clouds.
// Out: extinction [clouds][CELLS][CELLS][CELLS] 1/m.
#include "clouds/light_grid.clh"

// Half width of a tent of variance 0.1041: sqrt(6 * 0.1041).
#define TENT_RADII 0.79f
// A tent over all cells has this many weights at most.
#define MOST_WEIGHTS (CELLS + 2)

// Weights, of sum 1, of cells from *first to *end for a particle at `at` cells with a tent of this half width.
static inline void tent_weights(float at, float half_width, int *first, int *end, float *weights) {
  *first = max((int)floor(at - half_width), 0);
  *end = min((int)ceil(at + half_width), CELLS);
  float sum = 0.0f;
  for (int i = *first; i < *end; ++i) {
    const float weight = fmax(0.0f, half_width - fabs((float)i + 0.5f - at));
    weights[i - *first] = weight;
    sum += weight;
  }
  for (int i = *first; i < *end; ++i) weights[i - *first] /= sum;
}

__kernel void light_density(__global const CloudParticle *restrict particles, __global const CloudGrid *restrict grids,
                            int rows_per_item, __global float *restrict extinction) {
  const CloudGrid grid = grids[get_global_id(1)];
  __global float *cells = extinction + (size_t)get_global_id(1) * CELLS_OF_CLOUD;
  const int first_row = (int)get_global_id(0) * rows_per_item;
  const int end_row = min(first_row + rows_per_item, CELLS * CELLS);
  for (int i = first_row * CELLS; i < end_row * CELLS; ++i) cells[i] = 0.0f;
  const float volume = grid.cell_x * grid.cell_y * grid.cell_z;
  const int first_z = first_row / CELLS, end_z = (end_row - 1) / CELLS + 1;
  float x_weights[MOST_WEIGHTS], y_weights[MOST_WEIGHTS], z_weights[MOST_WEIGHTS];
  for (int i = grid.first; i < grid.end; ++i) {
    const float3 at = cells_at(grid, (float3)(particles[i].x, particles[i].y, particles[i].z));
    const float3 half_width = fmax(TENT_RADII * particles[i].radius / grid_cell(grid), 1.0f);
    // What is not a number is in no row.
    if (!(at.z + half_width.z > (float)first_z && at.z - half_width.z < (float)end_z)) continue;
    if (!isfinite(at.x + at.y + particles[i].optical_mass)) continue;
    int x0, x1, y0, y1, z0, z1;
    tent_weights(at.z, half_width.z, &z0, &z1, z_weights);
    tent_weights(at.y, half_width.y, &y0, &y1, y_weights);
    tent_weights(at.x, half_width.x, &x0, &x1, x_weights);
    const float amount = particles[i].optical_mass / volume;
    for (int z = max(z0, first_z); z < min(z1, end_z); ++z) {
      for (int y = y0; y < y1; ++y) {
        const int row = z * CELLS + y;
        if (row < first_row || row >= end_row) continue;
        const float share = amount * z_weights[z - z0] * y_weights[y - y0];
        for (int x = x0; x < x1; ++x) cells[row * CELLS + x] += share * x_weights[x - x0];
      }
    }
  }
}
