// The share of each sun's light that reaches the middle of each cell, scaled: what scatters nearly forward goes on
// (C10). Carried from plane to plane along the axis that the light crosses fastest; between the middles of four cells
// of the plane before it is mixed, which keeps energy.
// In:  grids, looks [clouds], light, extinction.
// Out: beams [clouds][CLOUD_SUNS][CELLS][CELLS][CELLS], those of sun_count suns.
// One work-group of GROUP_SIZE a sun (dimension 0) and cloud (1).
#include "clouds/light_grid.clh"

static inline float component(float3 v, int axis) { return axis == 0 ? v.x : (axis == 1 ? v.y : v.z); }

// Light that leaves the cell of the plane before at (a, b), or the whole sun's beside the grid.
static inline float leaving(__global const float *restrict extinction, __global const float *restrict beam, int start,
                            int a, int b, int stride_a, int stride_b, float half_way) {
  if (a < 0 || b < 0 || a >= CELLS || b >= CELLS) return 1.0f;
  const int cell = start + a * stride_a + b * stride_b;
  return beam[cell] * exp(-half_way * extinction[cell]);
}

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void light_beam(
    __global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
    const CloudLightParams light, __global const float *restrict extinction, __global float *restrict beams) {
  const int cloud = (int)get_group_id(1), sun = (int)get_group_id(0);
  const CloudGrid grid = grids[cloud];
  const CloudSunLight source = light.suns[sun];
  __global const float *density = extinction + (size_t)cloud * CELLS_OF_CLOUD;
  __global float *beam = beams + ((size_t)cloud * CLOUD_SUNS + sun) * CELLS_OF_CLOUD;

  const float3 way = -(float3)(source.x, source.y, source.z) / grid_cell(grid);
  const float3 speed = fabs(way);
  const int axis = speed.x > speed.y ? (speed.x > speed.z ? 0 : 2) : (speed.y > speed.z ? 1 : 2);
  const int axis_a = axis == 0 ? 1 : 0, axis_b = axis == 2 ? 1 : 2;
  const int strides[3] = {1, CELLS, CELLS * CELLS};
  const int stride = strides[axis], stride_a = strides[axis_a], stride_b = strides[axis_b];
  const float metres = 1.0f / component(speed, axis);  // from plane to plane
  const float half_way = 0.5f * metres * (1.0f - forward_albedo(looks[cloud]));
  // From a middle back to the plane before.
  const float back_a = -component(way, axis_a) * metres, back_b = -component(way, axis_b) * metres;
  const int left_a = (int)floor(back_a), left_b = (int)floor(back_b);
  const float share_a = back_a - (float)left_a, share_b = back_b - (float)left_b;
  const bool is_rising = component(way, axis) > 0.0f;

  for (int plane = 0; plane < CELLS; ++plane) {
    const int start = (is_rising ? plane : CELLS - 1 - plane) * stride;
    const int before = start + (is_rising ? -stride : stride);
    for (int i = (int)get_local_id(0); i < CELLS * CELLS; i += GROUP_SIZE) {
      const int a = i % CELLS, b = i / CELLS;
      float arriving = 1.0f;
      if (plane > 0) {
        const int at_a = a + left_a, at_b = b + left_b;
        arriving = mix(mix(leaving(density, beam, before, at_a, at_b, stride_a, stride_b, half_way),
                           leaving(density, beam, before, at_a + 1, at_b, stride_a, stride_b, half_way), share_a),
                       mix(leaving(density, beam, before, at_a, at_b + 1, stride_a, stride_b, half_way),
                           leaving(density, beam, before, at_a + 1, at_b + 1, stride_a, stride_b, half_way), share_a),
                       share_b);
      }
      const int cell = start + a * stride_a + b * stride_b;
      beam[cell] = arriving * exp(-half_way * density[cell]);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
  }
}
