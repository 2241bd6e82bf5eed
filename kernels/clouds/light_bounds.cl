// The grid of each cloud: a box around its particles, a cell wider on each side, in CELLS cells a side.
// In:  particles [count], those of a cloud side by side, clouds in rising order.
// Out: grids [clouds]; an empty cloud's particles end where they begin.
// One work-group of GROUP_SIZE a cloud. Places that are not numbers are left out.
#include "clouds/light_grid.clh"

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
    __global const CloudParticle *restrict particles, int count, __global CloudGrid *restrict grids) {
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
  lows[item] = low.x, lows[GROUP_SIZE + item] = low.y, lows[2 * GROUP_SIZE + item] = low.z;
  highs[item] = high.x, highs[GROUP_SIZE + item] = high.y, highs[2 * GROUP_SIZE + item] = high.z;
  barrier(CLK_LOCAL_MEM_FENCE);
  if (item != 0) return;
  for (int other = 1; other < GROUP_SIZE; ++other) {
    low = fmin(low, (float3)(lows[other], lows[GROUP_SIZE + other], lows[2 * GROUP_SIZE + other]));
    high = fmax(high, (float3)(highs[other], highs[GROUP_SIZE + other], highs[2 * GROUP_SIZE + other]));
  }
  if (!(low.x < high.x)) low = (float3)(0.0f), high = (float3)(1.0f);
  const float3 cell = (high - low) / (float)(CELLS - 2);
  low -= cell;
  const CloudGrid grid = {low.x, low.y, low.z, cell.x, cell.y, cell.z, first, end};
  grids[cloud] = grid;
}
