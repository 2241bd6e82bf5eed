// The share of each sun's light that reaches the middle of each cell, scaled: what scatters nearly forward goes on
// (C10), for each channel. Carried from plane to plane along the axis that the light crosses fastest; between the middles of four cells
// of the plane before it is mixed, which keeps energy.
// Other clouds before this one take their share from all cells of a line alike.
// In:  grids, looks, lights [clouds], medium, absorption; of light_entry.cl entries, which count where there are several
//      clouds.
// Out: beams [clouds][suns][channels][grid.room].
// One work-group of GROUP_SIZE a sun and channel (dimension 0) and cloud (1).
#include "simd/lane_exponents.clh"
#include "clouds/light_entry.clh"

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void light_beam(
    __global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
    __global const CloudLightParams *restrict lights, __global const float *restrict medium,
    __global const float *restrict absorption, __global const float *restrict entries, int clouds, int channels,
    __global float *restrict beams) {
  // What leaves the cells of the plane before and of this one, in turn.
  __local float leaving[2][CLOUD_RIMMED_CELLS(CLOUD_MOST_CELLS)];
  const int cloud = (int)get_group_id(1), item = (int)get_local_id(0);
  const int sun = (int)get_group_id(0) / channels, channel = (int)get_group_id(0) % channels;
  const CloudGrid grid = grids[cloud];
  const CloudScattering look = looks[cloud];
  const CloudLightSource source = lights[cloud].suns[sun];
  const size_t number = (size_t)cloud * get_num_groups(0) + get_group_id(0);
  __global const float *extinction = medium + (size_t)cloud * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid);
  __global const float *absorbing = absorption + ((size_t)cloud * channels + channel) * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid);
  __global float *beam = beams + CLOUD_BEAM_MARGIN + number * grid.room;

  const float3 way = -(float3)(source.x, source.y, source.z) / grid_cell(grid);
  const float3 speed = fabs(way);
  const int axis = speed.x > speed.y ? (speed.x > speed.z ? 0 : 2) : (speed.y > speed.z ? 1 : 2);
  const int axis_a = axis == 0 ? 1 : 0, axis_b = axis == 2 ? 1 : 2;
  const int sizes[3] = {grid.size_x, grid.size_y, grid.size_z};
  const int strides[3] = {1, grid.size_x, grid.size_x * grid.size_y};
  const int planes = sizes[axis], size_a = sizes[axis_a], size_b = sizes[axis_b];
  const int stride = strides[axis], stride_a = strides[axis_a], stride_b = strides[axis_b];
  const float metres = 1.0f / component(speed, axis);  // from plane to plane
  const float half_way = 0.5f * metres;
  // From a middle back to the plane before: a cell at most, as the axis is the fastest.
  const float back_a = -component(way, axis_a) * metres, back_b = -component(way, axis_b) * metres;
  const int left_a = back_a < 0.0f ? -1 : 0, left_b = back_b < 0.0f ? -1 : 0;
  // Not back - (float)left: of the -1 of a condition Oclgrind 21.10 makes 1.
  const float share_a = back_a < 0.0f ? 1.0f + back_a : back_a, share_b = back_b < 0.0f ? 1.0f + back_b : back_b;
  const bool is_rising = component(way, axis) > 0.0f;
  const int pitch = size_a + 2;
  const EntrySquare square = entry_square(grid, (float3)(source.x, source.y, source.z));
  __global const float *shares = entries + number * ENTRY_TEXELS;

  // What half a cell lets through, kept where the light will be.
  const int cells = grid.size_x * grid.size_y * grid.size_z;
  for (int i = item * LANES; i < cells; i += GROUP_SIZE * LANES)
    store_lanes(exp_of(-half_way * scaled_extinction(look, load_lanes(extinction + i), load_lanes(absorbing + i))),
                beam + i);
  for (int i = item; i < pitch * (size_b + 2); i += GROUP_SIZE) leaving[0][i] = leaving[1][i] = 1.0f;
  wait_for_group();

  for (int plane = 0; plane < planes; ++plane) {
    const int start = (is_rising ? plane : planes - 1 - plane) * stride;
    __local const float *before = leaving[plane % 2] + pitch + 1;
    __local float *after = leaving[(plane + 1) % 2] + pitch + 1;
    for (int i = item; i < size_a * size_b; i += GROUP_SIZE) {
      const int b = i / size_a, a = i - b * size_a;
      __local const float *from = before + (b + left_b) * pitch + a + left_a;
      const float arriving =
          mix(mix(from[0], from[1], share_a), mix(from[pitch], from[pitch + 1], share_a), share_b);
      const int cell = start + a * stride_a + b * stride_b;
      const float half_kept = beam[cell];
      float entering = 1.0f;
      if (clouds > 1) {
        const float3 at = (float3)((float)(cell % grid.size_x), (float)(cell / grid.size_x % grid.size_y),
                                   (float)(cell / (grid.size_x * grid.size_y))) + 0.5f;
        entering = entry_share(square, shares, (float3)(grid.low_x, grid.low_y, grid.low_z) + at * grid_cell(grid));
      }
      beam[cell] = entering * arriving * half_kept;
      after[b * pitch + a] = arriving * half_kept * half_kept;
    }
    wait_for_group();
  }
}
