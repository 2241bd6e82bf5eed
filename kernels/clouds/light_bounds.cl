// The grid of each cloud: a box around its particles, a cell wider on each side, in cells as nearly cubes as powers of
// two make them: a flat cloud has more across than from top to bottom.
// In:  particles [count], those of a cloud side by side, clouds in rising order; room for cells, how many of them a heap
//      has, and a flat cloud at most.
// Out: grids [clouds]; an empty cloud's particles end where they begin.
// One work-group of GROUP_SIZE a cloud. Places that are not numbers are left out.
#include "clouds/light_grid.clh"

// A flat cloud has more cells than a heap as long as its cells are this much longer than high.
#define LONGEST_CELLS 2.5f

static inline float3 cell_of(float3 extent, int size_x, int size_y, int size_z) {
  return extent / (float3)((float)(size_x - 2), (float)(size_y - 2), (float)(size_z - 2));
}

// The first particle of this cloud or a later one.
static inline int first_of(__global const CloudParticle *restrict particles, int count, uint cloud) {
  int low = 0, high = count;
  while (low < high) {
    const int middle = (low + high) / 2;
    if (particles[middle].cloud < cloud)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void light_bounds(
    __global const CloudParticle *restrict particles, int count, int room, int cells_of_heap, int cells_of_flat,
    __global CloudGrid *restrict grids) {
  __local float lows[3 * GROUP_SIZE], highs[3 * GROUP_SIZE];
  const uint cloud = (uint)get_group_id(0);
  const int item = (int)get_local_id(0);
  const int first = first_of(particles, count, cloud), end = first_of(particles, count, cloud + 1u);
  float3 low = (float3)(FLT_MAX), high = (float3)(-FLT_MAX);
  for (int i = first + item; i < end; i += GROUP_SIZE) {
    const float3 place = (float3)(particles[i].x, particles[i].y, particles[i].z);
    const float radius = particles[i].radius;
    // fmin and fmax drop what is not a number; without end it would make the cells endless.
    if (!isfinite(place.x + place.y + place.z + radius)) continue;
    low = fmin(low, place - radius);
    high = fmax(high, place + radius);
  }
  join_bounds(item, lows, highs, &low, &high);
  if (item != 0) return;
  if (!(low.x < high.x)) low = (float3)(0.0f), high = (float3)(1.0f);
  int size_x = CLOUD_LEAST_CELLS, size_y = CLOUD_LEAST_CELLS, size_z = CLOUD_LEAST_CELLS;
  for (;;) {
    const float3 cell = cell_of(high - low, size_x, size_y, size_z);
    const float longest = fmax(cell.x, fmax(cell.y, cell.z)), shortest = fmin(cell.x, fmin(cell.y, cell.z));
    const int cells = size_x * size_y * size_z;
    if (cells >= (longest > LONGEST_CELLS * shortest ? cells_of_flat : cells_of_heap)) break;
    if (cell.x == longest)
      size_x *= 2;
    else if (cell.y == longest)
      size_y *= 2;
    else
      size_z *= 2;
  }
  const float3 cell = cell_of(high - low, size_x, size_y, size_z);
  low -= cell;
  const CloudGrid grid = {low.x, low.y, low.z, cell.x, cell.y, cell.z, first, end, size_x, size_y, size_z, room};
  grids[cloud] = grid;
}
