// Where the particles of each cloud lie along the axes that its volume gets.
// In:  particles, grids, the axes: right, up and toward the sun.
// Out: bounds [clouds].
// One work-group of GROUP_SIZE a cloud. Places that are not numbers are left out.
#include "clouds/march/march_volume.clh"

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void march_bounds(
    __global const CloudParticle *restrict particles, __global const CloudGrid *restrict grids,
    const CloudMarchVolume axes, __global CloudMarchBounds *restrict bounds) {
  __local float lows[3 * GROUP_SIZE], highs[3 * GROUP_SIZE], radii[GROUP_SIZE];
  const CloudGrid grid = grids[get_group_id(0)];
  const int item = (int)get_local_id(0);
  float3 low = (float3)(FLT_MAX), high = (float3)(-FLT_MAX);
  float radius_sum = 0.0f;
  for (int i = grid.first + item; i < grid.end; i += GROUP_SIZE) {
    const float3 place = in_volume(axes, (float3)(particles[i].x, particles[i].y, particles[i].z));
    const float radius = particles[i].radius;
    if (!isfinite(place.x + place.y + place.z + radius)) continue;
    low = fmin(low, place - radius);
    high = fmax(high, place + radius);
    radius_sum += radius;
  }
  radii[item] = radius_sum;
  join_bounds(item, lows, highs, &low, &high);
  if (item != 0) return;
  for (int other = 1; other < GROUP_SIZE; ++other) radius_sum += radii[other];
  const bool has_any = low.x < high.x;
  const float3 box = grid_cell(grid) * grid_size(grid);
  const CloudParticle anchor = particles[has_any ? grid.first : 0];
  const CloudMarchBounds found = {low.x, low.y, low.z, high.x, high.y, high.z, grid.first, has_any ? grid.end : grid.first,
                                  cbrt(box.x * box.y * box.z / CLOUD_MARCH_EDGES),
                                  radius_sum / (float)max(grid.end - grid.first, 1), anchor.x, anchor.y, anchor.z, anchor.texture};
  bounds[get_group_id(0)] = found;
}
