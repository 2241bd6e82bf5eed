// Extinction of each cell of the clouds' grids: each particle's optical mass, spread by a tent along each axis that has
// the variance of h, 0.1041 R^2, or is a cell wide. Mass is kept. A work-item owns rows of cells of one cloud and
// takes particles in their order, so that sums round alike on all devices.
// In:  particles, grids. Global size: items that share the rows, clouds.
// Out: medium [clouds][LEVEL_CELLS] 1/m, the finest level.
#include "clouds/light_grid.clh"
#include "terrain/lane_masks.clh"

// Half width of a tent of variance 0.1041: sqrt(6 * 0.1041).
#define TENT_RADII 0.79f

// A tent along an axis: cells first ... end - 1, whose middles it covers, weights (half_width - distance) * scale of
// sum 1.
typedef struct {
  int first, end;
  float at, half_width, scale;
} Tent;

static inline float tent_height(float at, float half_width, int cell) {
  return fmax(0.0f, half_width - fabs((float)cell + 0.5f - at));
}

FFT_INLINE Tent tent_at(float at, float half_width, int size) {
  Tent tent = {max((int)floor(at - half_width + 0.5f), 0), min((int)ceil(at + half_width - 0.5f), size), at, half_width,
               1.0f};
  // Heights a cell apart of a tent that is two cells wide sum up to 1; the grid is a cell wider than what it holds.
  if (half_width == 1.0f) return tent;
  float sum = 0.0f;
  for (int i = tent.first; i < tent.end; ++i) sum += tent_height(at, half_width, i);
  tent.scale = sum > 0.0f ? 1.0f / sum : 0.0f;
  return tent;
}

static inline float tent_weight(const Tent tent, int cell) {
  return tent.scale * tent_height(tent.at, tent.half_width, cell);
}

__kernel void light_density(__global const CloudParticle *restrict particles, __global const CloudGrid *restrict grids,
                            __global float *restrict medium) {
  const CloudGrid grid = grids[get_global_id(1)];
  __global float *cells = medium + get_global_id(1) * LEVEL_CELLS + FIRST_LEVEL;
  const int rows = grid.size_y * grid.size_z, items = (int)get_global_size(0);
  const int rows_of_item = (rows + items - 1) / items;
  const int first_row = min((int)get_global_id(0) * rows_of_item, rows);
  const int end_row = min(first_row + rows_of_item, rows);
  if (first_row >= end_row) return;
  for (int i = first_row * grid.size_x; i < end_row * grid.size_x; i += LANES)
    store_lanes((lanes)0.0f, cells + i);
  const float3 a_metre = 1.0f / grid_cell(grid), low = (float3)(grid.low_x, grid.low_y, grid.low_z);
  const float a_volume = a_metre.x * a_metre.y * a_metre.z;
  const float first_z = (float)(first_row / grid.size_y), end_z = (float)((end_row - 1) / grid.size_y + 1);
  for (int i = grid.first; i < grid.end; ++i) {
    const float radius = TENT_RADII * particles[i].radius;
    const float at_z = (particles[i].z - low.z) * a_metre.z, half_z = fmax(radius * a_metre.z, 1.0f);
    // What is not a number is in no row.
    if (!(at_z + half_z > first_z && at_z - half_z < end_z)) continue;
    const float at_x = (particles[i].x - low.x) * a_metre.x, at_y = (particles[i].y - low.y) * a_metre.y;
    if (!isfinite(at_x + at_y + particles[i].optical_mass)) continue;
    const Tent z_tent = tent_at(at_z, half_z, grid.size_z);
    const Tent y_tent = tent_at(at_y, fmax(radius * a_metre.y, 1.0f), grid.size_y);
    const Tent x_tent = tent_at(at_x, fmax(radius * a_metre.x, 1.0f), grid.size_x);
    const float amount = particles[i].optical_mass * a_volume * x_tent.scale;
    for (int x = x_tent.first / LANES * LANES; x < x_tent.end; x += LANES) {
      const lanes away = fabs((float)x + 0.5f + LANE_INDEX - x_tent.at);
      const lanes weights = amount * most(x_tent.half_width - away, (lanes)0.0f);
      for (int z = z_tent.first; z < z_tent.end; ++z) {
        const int first = max(y_tent.first, first_row - z * grid.size_y);
        const int end = min(y_tent.end, end_row - z * grid.size_y);
        const float share = tent_weight(z_tent, z);
        for (int y = first; y < end; ++y) {
          __global float *cell = cells + (z * grid.size_y + y) * grid.size_x + x;
          store_lanes(load_lanes(cell) + share * tent_weight(y_tent, y) * weights, cell);
        }
      }
    }
  }
}
