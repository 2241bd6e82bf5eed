// Solves the diffusion of light in each cloud (clouds/diffusion.clh) by multigrid: CYCLES V-cycles, sweeps over every
// other cell, residuals averaged over eight cells, corrections interpolated.
// In:    looks.
// Inout: [clouds][LEVEL_CELLS], of the finest level as light_source.cl left them: medium, faces, sources; fluence, zero
//        before the first level and beyond the last.
// One work-group of GROUP_SIZE a cloud.
#include "clouds/diffusion.clh"

#define CYCLES 4
#define COARSEST_SWEEPS 8

// Light that flows into a cell from its neighbours. Where x, y, z - 1 would be before the first, the cell before in
// memory has no conductance: it is a last one.
static inline float4 flow_into(__global const float4 *restrict faces, __global const float4 *fluence, float4 here,
                               float3 before, int side, int at) {
  const int plane = side * side;
  return here.x * fluence[at + 1] + before.x * fluence[at - 1] + here.y * fluence[at + side] +
         before.y * fluence[at - side] + here.z * fluence[at + plane] + before.z * fluence[at - plane];
}

static inline float3 faces_before(__global const float4 *restrict faces, int side, int at) {
  return (float3)(faces[at - 1].x, faces[at - side].y, faces[at - side * side].z);
}

static inline float4 share_out(float4 absorbed, float medium, float4 here, float3 before) {
  return absorbed * medium + (here.x + before.x + here.y + before.y + here.z + before.z + here.w);
}

static inline void relax(__global const float *restrict medium, __global const float4 *restrict faces,
                         __global const float4 *restrict sources, __global float4 *fluence, float4 absorbed,
                         const Level level, int sweeps) {
  const int side = level.side, half_side = side / 2;
  for (int colour = 0; colour < 2 * sweeps; ++colour) {
    for (int i = (int)get_local_id(0); i < half_side * side * side; i += GROUP_SIZE) {
      const int row = i / half_side;
      const int at = level.start + row * side + 2 * (i % half_side) + (row + row / side + colour) % 2;
      const float4 here = faces[at];
      const float3 before = faces_before(faces, side, at);
      fluence[at] = (sources[at] + flow_into(faces, fluence, here, before, side, at)) /
                    share_out(absorbed, medium[at], here, before);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
  }
}

static inline float4 residual(__global const float *restrict medium, __global const float4 *restrict faces,
                              __global const float4 *restrict sources, __global const float4 *fluence, float4 absorbed,
                              int side, int at) {
  const float4 here = faces[at];
  const float3 before = faces_before(faces, side, at);
  return sources[at] + flow_into(faces, fluence, here, before, side, at) -
         share_out(absorbed, medium[at], here, before) * fluence[at];
}

// The first of the eight cells of the finer level that a cell holds.
static inline int first_child(const Level fine, int side, int i) {
  const int x = i % side, y = i / side % side, z = i / (side * side);
  return fine.start + (2 * z * fine.side + 2 * y) * fine.side + 2 * x;
}

static inline int child_offset(const Level fine, int child) {
  return (child / 4 * fine.side + child / 2 % 2) * fine.side + child % 2;
}

// Between middles of the coarser cells, 3 : 1 along each axis, as far as there are neighbours.
static inline float4 interpolated(__global const float4 *values, const Level coarse, int x, int y, int z) {
  const int near_x = x / 2, near_y = y / 2, near_z = z / 2, last = coarse.side - 1;
  const int far_x = clamp(near_x + 2 * (x % 2) - 1, 0, last), far_y = clamp(near_y + 2 * (y % 2) - 1, 0, last);
  const int far_z = clamp(near_z + 2 * (z % 2) - 1, 0, last);
  float4 planes[2];
  for (int k = 0; k < 2; ++k) {
    __global const float4 *plane = values + coarse.start + (k == 0 ? near_z : far_z) * coarse.side * coarse.side;
    __global const float4 *near_row = plane + near_y * coarse.side, *far_row = plane + far_y * coarse.side;
    planes[k] = mix(mix(near_row[near_x], near_row[far_x], 0.25f), mix(far_row[near_x], far_row[far_x], 0.25f), 0.25f);
  }
  return mix(planes[0], planes[1], 0.25f);
}

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void light_diffuse(
    __global const CloudScattering *restrict looks,
    __global float *restrict medium, __global float4 *restrict faces, __global float4 *restrict sources,
    __global float4 *restrict fluence) {
  const size_t cloud = get_group_id(0);
  const int item = (int)get_local_id(0);
  const CloudScattering look = looks[cloud];
  medium += cloud * LEVEL_CELLS;
  faces += cloud * LEVEL_CELLS;
  sources += cloud * LEVEL_CELLS;
  fluence += cloud * LEVEL_CELLS;
  const float4 absorbed = (float4)(1.0f - look.albedo_red, 1.0f - look.albedo_green, 1.0f - look.albedo_blue, 0.0f);

  int coarsest = 0;
  for (int side = CELLS / 2; side >= 2; side /= 2) {
    const Level fine = level_of(coarsest), level = level_of(++coarsest);
    for (int i = item; i < side * side * side; i += GROUP_SIZE) {
      const int child = first_child(fine, side, i);
      float density = 0.0f;
      float4 sum = (float4)(0.0f);
      for (int k = 0; k < 8; ++k) {
        const int at = child + child_offset(fine, k);
        density += 0.125f * medium[at];
        // Of faces toward the next coarse cell the mean of four: those of the children on that side. Twice the distance
        // makes D / c^2 a quarter.
        const float4 face = faces[at];
        sum += (float4)(k % 2 == 1 ? 0.0625f * face.x : 0.0f, k / 2 % 2 == 1 ? 0.0625f * face.y : 0.0f,
                        k / 4 == 1 ? 0.0625f * face.z : 0.0f, 0.125f * face.w);
      }
      medium[level.start + i] = density;
      faces[level.start + i] = sum;
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
  }
  for (int i = item; i < CELLS_OF_CLOUD; i += GROUP_SIZE) fluence[FIRST_LEVEL + i] = (float4)(0.0f);
  barrier(CLK_GLOBAL_MEM_FENCE);

  for (int cycle = 0; cycle < CYCLES; ++cycle) {
    for (int number = 0; number < coarsest; ++number) {
      const Level fine = level_of(number), level = level_of(number + 1);
      relax(medium, faces, sources, fluence, absorbed, fine, 1);
      for (int i = item; i < level.side * level.side * level.side; i += GROUP_SIZE) {
        const int child = first_child(fine, level.side, i);
        float4 sum = (float4)(0.0f);
        for (int k = 0; k < 8; ++k)
          sum += 0.125f *
                 residual(medium, faces, sources, fluence, absorbed, fine.side, child + child_offset(fine, k));
        sources[level.start + i] = sum;
        fluence[level.start + i] = (float4)(0.0f);
      }
      barrier(CLK_GLOBAL_MEM_FENCE);
    }
    relax(medium, faces, sources, fluence, absorbed, level_of(coarsest), COARSEST_SWEEPS);
    for (int number = coarsest - 1; number >= 0; --number) {
      const Level level = level_of(number), coarse = level_of(number + 1);
      const int side = level.side;
      for (int i = item; i < side * side * side; i += GROUP_SIZE)
        fluence[level.start + i] += interpolated(fluence, coarse, i % side, i / side % side, i / (side * side));
      barrier(CLK_GLOBAL_MEM_FENCE);
      relax(medium, faces, sources, fluence, absorbed, level, 1);
    }
  }
}
