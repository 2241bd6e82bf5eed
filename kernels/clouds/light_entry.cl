// What of each sun's light reaches the box of each cloud past the clouds before it, scaled as in light_beam.cl: over a
// square across the light around the box's middle. Of clouds whose boxes meet, what lies in both shades neither.
// In:  grids, looks, lights [clouds], medium, absorption.
// Out: entries [clouds][suns][channels][CLOUD_ENTRY_SIZE][CLOUD_ENTRY_SIZE].
// One work-group of GROUP_SIZE a sun and channel (dimension 0) and cloud (1).
#include "clouds/light_entry.clh"

// Steps of the way through another cloud: two a cell of a heap.
#define STEPS_THROUGH 32
#define TEXELS_OF_ITEM (ENTRY_TEXELS / GROUP_SIZE)

// Distances at which a line enters and leaves a box, in metres; none where the first is not below the second.
static inline float2 way_through(const CloudGrid grid, float3 from, float3 way) {
  const float3 safe = select(way, (float3)(1e-12f), fabs(way) < 1e-12f);
  const float3 low = ((float3)(grid.low_x, grid.low_y, grid.low_z) - from) / safe;
  const float3 high = low + grid_box(grid) / safe;
  const float3 enters = fmin(low, high), leaves = fmax(low, high);
  return (float2)(fmax(enters.x, fmax(enters.y, enters.z)), fmin(leaves.x, fmin(leaves.y, leaves.z)));
}

// In the scaled medium.
static inline float depth_through(const CloudGrid grid, const CloudScattering look,
                                  __global const float *restrict extinction, __global const float *restrict absorbing,
                                  float3 from, float3 way, float first, float last) {
  const float piece = (last - first) / (float)STEPS_THROUGH;
  float sum = 0.0f;
  for (int step = 0; step < STEPS_THROUGH; ++step) {
    const GridSample sample = grid_sample(grid, cells_at(grid, from + (first + ((float)step + 0.5f) * piece) * way));
    sum += scaled_extinction(look, sample_scalar(extinction, sample), sample_scalar(absorbing, sample));
  }
  return piece * sum;
}

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void light_entry(
    __global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
    __global const CloudLightParams *restrict lights, __global const float *restrict medium,
    __global const float *restrict absorption, int clouds, int channels, __global float *restrict entries) {
  const int cloud = (int)get_group_id(1), item = (int)get_local_id(0);
  const int sun = (int)get_group_id(0) / channels, channel = (int)get_group_id(0) % channels;
  const CloudGrid grid = grids[cloud];
  const CloudLightSource source = lights[cloud].suns[sun];
  const float3 way = (float3)(source.x, source.y, source.z);
  const EntrySquare square = entry_square(grid, way);
  float depths[TEXELS_OF_ITEM];
  for (int i = 0; i < TEXELS_OF_ITEM; ++i) depths[i] = 0.0f;
  for (int other = 0; other < clouds; ++other) {
    const CloudGrid before = grids[other];
    if (other == cloud || before.first == before.end) continue;
    // Beside the light, or behind.
    const float3 between = grid_middle(before) - square.middle;
    const float along = dot(between, way), reach = square.half_width + 0.5f * length(grid_box(before));
    if (along < -reach || dot(between, between) - along * along > reach * reach) continue;
    __global const float *extinction = medium + (size_t)other * MEDIUM_CELLS(before) + FIRST_LEVEL(before);
    __global const float *absorbing = absorption + ((size_t)other * channels + channel) * MEDIUM_CELLS(before) + FIRST_LEVEL(before);
    for (int i = 0; i < TEXELS_OF_ITEM; ++i) {
      const float3 from = entry_place(square, item * TEXELS_OF_ITEM + i);
      const float2 own = way_through(grid, from, way), through = way_through(before, from, way);
      const float first = fmax(through.x, own.x < own.y ? own.y : 0.0f);
      if (first < through.y)
        depths[i] += depth_through(before, looks[other], extinction, absorbing, from, way, first, through.y);
    }
  }
  const size_t number = (size_t)cloud * get_num_groups(0) + get_group_id(0);
  __global float *shares = entries + number * ENTRY_TEXELS + item * TEXELS_OF_ITEM;
  for (int i = 0; i < TEXELS_OF_ITEM; ++i) shares[i] = exp(-depths[i]);
}
