// Extinction of each cell of the clouds' grids, and the share of it that absorbs: each particle's optical mass, spread by a
// tent along each axis that has the variance of h, 0.1041 R^2, or is a cell wide. Mass is kept. A work-item owns rows of
// cells of one cloud and takes particles in their order, so that sums round alike on all devices.
// In:  particles, grids, looks. Global size: items that share the rows, clouds.
// Out: medium [clouds][MEDIUM_CELLS], absorption [clouds][channels][MEDIUM_CELLS], 1/m: of one channel by the look's
//      albedo, of three by each particle's.
#include "clouds/light_grid.clh"
#include "simd/lane_masks.clh"

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

INLINE Tent tent_at(float at, float half_width, int size) {
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

static inline void add_lanes(lanes value, __global float *cells) { store_lanes(load_lanes(cells) + value, cells); }

static inline float absorbed_share(float albedo) { return 1.0f - clamp(albedo, 0.0f, 1.0f); }

__kernel void light_density(__global const CloudParticle *restrict particles, __global const CloudGrid *restrict grids,
                            __global const CloudScattering *restrict looks, int channels,
                            __global float *restrict medium, __global float *restrict absorption) {
  const CloudGrid grid = grids[get_global_id(1)];
  __global float *cells = medium + get_global_id(1) * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid);
  __global float *absorbing = absorption + get_global_id(1) * channels * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid);
  const int rows = grid.size_y * grid.size_z, items = (int)get_global_size(0);
  const int rows_of_item = (rows + items - 1) / items;
  const int first_row = min((int)get_global_id(0) * rows_of_item, rows);
  const int end_row = min(first_row + rows_of_item, rows);
  if (first_row >= end_row) return;
  const int first_cell = first_row * grid.size_x, end_cell = end_row * grid.size_x;
  for (int i = first_cell; i < end_cell; i += LANES) store_lanes((lanes)0.0f, cells + i);
  if (channels > 1) {
    for (int channel = 0; channel < channels; ++channel)
      for (int i = first_cell; i < end_cell; i += LANES)
        store_lanes((lanes)0.0f, absorbing + channel * MEDIUM_CELLS(grid) + i);
  }
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
    const float red = absorbed_share(particles[i].red), green = absorbed_share(particles[i].green),
                blue = absorbed_share(particles[i].blue);
    for (int x = x_tent.first / LANES * LANES; x < x_tent.end; x += LANES) {
      const lanes away = fabs((float)x + 0.5f + LANE_INDEX - x_tent.at);
      const lanes weights = amount * most(x_tent.half_width - away, (lanes)0.0f);
      for (int z = z_tent.first; z < z_tent.end; ++z) {
        const int first = max(y_tent.first, first_row - z * grid.size_y);
        const int end = min(y_tent.end, end_row - z * grid.size_y);
        const float share = tent_weight(z_tent, z);
        for (int y = first; y < end; ++y) {
          const int cell = (z * grid.size_y + y) * grid.size_x + x;
          const lanes here = share * tent_weight(y_tent, y) * weights;
          add_lanes(here, cells + cell);
          if (channels == 1) continue;
          add_lanes(red * here, absorbing + cell);
          add_lanes(green * here, absorbing + MEDIUM_CELLS(grid) + cell);
          add_lanes(blue * here, absorbing + 2 * MEDIUM_CELLS(grid) + cell);
        }
      }
    }
  }
  if (channels > 1) return;
  const float absorbed = looks[get_global_id(1)].absorbed_share;
  for (int i = first_cell; i < end_cell; i += LANES) store_lanes(absorbed * load_lanes(cells + i), absorbing + i);
}
