// The light of each direction of diffusion.clh in each cell, carried from plane to plane along the axis that it crosses
// fastest, as light_beam.cl carries the suns'. Sky, ground and other clouds shine in from around the box.
// In:  grids, lights; emission of light_emission.cl; the first cloud.
//      leaving [clouds][DIRECTIONS][2][3][RIMMED_CELLS], room for what leaves the cells of the plane before and of this
//      one, in turn, of each colour.
// Out: radiances [clouds][DIRECTIONS][grid.room], kcd/m^2: means over the way through each cell.
// One work-group of GROUP_SIZE a direction (dimension 0) and cloud from the first on (1).
#include "clouds/diffusion.clh"

// What a cell sends in a direction per depth.
static inline float3 sent_at(__global const float4 *restrict emission, int cell, float3 toward) {
  __global const float4 *e = emission + 4 * cell;
  return e[0].xyz + toward.x * e[1].xyz + toward.y * e[2].xyz + toward.z * e[3].xyz;
}

// What a way of depth t lets through, e^-t, its mean along the way, (1 - e^-t) / t, and the mean of what is lost over t,
// (1 - mean) / t; of each colour.
typedef struct {
  float3 kept, mean, rest;
} WayThrough;

// Below this depth little would be left of means in floats: there they are taken as straight lines.
#define LEAST_DEPTH 0.02f

INLINE WayThrough way_through(float3 depth, int channels) {
  WayThrough through;
  if (channels == 1) {
    const float safe = fmax(depth.x, LEAST_DEPTH), less = safe - depth.x, mean = (1.0f - exp(-safe)) / safe;
    through.kept = (float3)(exp(-depth.x));
    through.mean = (float3)(mean + 0.5f * less);
    through.rest = (float3)((1.0f - mean) / safe + less / 6.0f);
    return through;
  }
  const float3 safe = fmax(depth, (float3)(LEAST_DEPTH)), less = safe - depth, mean = (1.0f - exp(-safe)) / safe;
  through.kept = exp(-depth);
  through.mean = mean + 0.5f * less;
  through.rest = (1.0f - mean) / safe + less / 6.0f;
  return through;
}

static inline float3 between(__global const float *from, int colours_apart, int pitch, float share_a, float share_b) {
  float mixed[3];
  for (int colour = 0; colour < 3; ++colour) {
    __global const float *f = from + colour * colours_apart;
    mixed[colour] = mix(mix(f[0], f[1], share_a), mix(f[pitch], f[pitch + 1], share_a), share_b);
  }
  return (float3)(mixed[0], mixed[1], mixed[2]);
}

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void light_sweep(
    __global const CloudGrid *restrict grids, __global const CloudLightParams *restrict lights,
    __global const float4 *restrict emission, int first_cloud, int channels,
    __global float *restrict leaving, __global float4 *restrict radiances) {
  const int direction = (int)get_group_id(0), item = (int)get_local_id(0);
  const size_t number = get_group_id(1), cloud = first_cloud + number;
  const CloudGrid grid = grids[cloud];
  emission += number * 4 * grid.room;
  leaving += (number * DIRECTIONS + direction) * 2 * 3 * RIMMED_CELLS(grid);
  radiances += (number * DIRECTIONS + direction) * grid.room;

  const float3 toward =
      COSINE * (float3)(direction_sign(direction, 0), direction_sign(direction, 1), direction_sign(direction, 2));
  const float3 way = toward / grid_cell(grid);
  const float3 speed = fabs(way);
  const int axis = speed.x > speed.y ? (speed.x > speed.z ? 0 : 2) : (speed.y > speed.z ? 1 : 2);
  const int axis_a = axis == 0 ? 1 : 0, axis_b = axis == 2 ? 1 : 2;
  const int sizes[3] = {grid.size_x, grid.size_y, grid.size_z};
  const int strides[3] = {1, grid.size_x, grid.size_x * grid.size_y};
  const int planes = sizes[axis], size_a = sizes[axis_a], size_b = sizes[axis_b];
  const int stride = strides[axis], stride_a = strides[axis_a], stride_b = strides[axis_b];
  const float metres = 1.0f / component(speed, axis);  // from plane to plane
  const float back_a = -component(way, axis_a) * metres, back_b = -component(way, axis_b) * metres;
  const int left_a = back_a < 0.0f ? -1 : 0, left_b = back_b < 0.0f ? -1 : 0;
  // Not back - (float)left: of the -1 of a condition Oclgrind 21.10 makes 1.
  const float share_a = back_a < 0.0f ? 1.0f + back_a : back_a, share_b = back_b < 0.0f ? 1.0f + back_b : back_b;
  const bool is_rising = component(way, axis) > 0.0f;
  const int pitch = size_a + 2;

  const float outside[3] = {toward.y < 0.0f ? lights[cloud].above_red : lights[cloud].below_red,
                            toward.y < 0.0f ? lights[cloud].above_green : lights[cloud].below_green,
                            toward.y < 0.0f ? lights[cloud].above_blue : lights[cloud].below_blue};
  for (int i = item; i < pitch * (size_b + 2); i += GROUP_SIZE)
    for (int colour = 0; colour < 3; ++colour)
      leaving[colour * RIMMED_CELLS(grid) + i] = leaving[(3 + colour) * RIMMED_CELLS(grid) + i] = outside[colour];
  wait_for_group();

  for (int plane = 0; plane < planes; ++plane) {
    const int start = (is_rising ? plane : planes - 1 - plane) * stride, step = is_rising ? stride : -stride;
    __global const float *before = leaving + plane % 2 * 3 * RIMMED_CELLS(grid) + pitch + 1;
    __global float *after = leaving + (plane + 1) % 2 * 3 * RIMMED_CELLS(grid) + pitch + 1;
    for (int i = item; i < size_a * size_b; i += GROUP_SIZE) {
      const int b = i / size_a, a = i - b * size_a;
      const float3 arriving = between(before + (b + left_b) * pitch + a + left_a, RIMMED_CELLS(grid), pitch, share_a, share_b);
      const int cell = start + a * stride_a + b * stride_b;
      // What is sent grows evenly across the cell, which thick cells need to pass on as much as diffusion does (Olson &
      // Kunasz 1987); it grows as toward the neighbour from which it differs less, not at all at an extreme.
      const float3 middle = sent_at(emission, cell, toward);
      const float3 before_it = plane == 0 ? (float3)(0.0f) : middle - sent_at(emission, cell - step, toward);
      const float3 after_it = plane == planes - 1 ? (float3)(0.0f) : sent_at(emission, cell + step, toward) - middle;
      const float3 growth = 0.5f * (sign(before_it) + sign(after_it)) * fmin(fabs(before_it), fabs(after_it));
      const float3 first = middle - 0.5f * growth;
      const WayThrough through = way_through(
          metres * (float3)(emission[4 * cell].w, emission[4 * cell + 1].w, emission[4 * cell + 2].w), channels);
      const float3 leaves =
          through.kept * arriving + (1.0f - through.kept) * first + (1.0f - through.mean) * growth;
      // The mean of first + growth s - growth / t + (arriving - first + growth / t) e^-ts over s from 0 to 1.
      const float3 mean =
          through.mean * arriving + (1.0f - through.mean) * first + (0.5f - through.rest) * growth;
      radiances[cell] = (float4)(mean, 0.0f);
      __global float *place = after + b * pitch + a;
      place[0] = leaves.x;
      place[RIMMED_CELLS(grid)] = leaves.y;
      place[2 * RIMMED_CELLS(grid)] = leaves.z;
    }
    wait_for_group();
  }
}
