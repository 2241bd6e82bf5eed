// Where scattered light arises in the clouds' grids, for light_diffuse.cl: from the suns' beams, and through the box's
// sides from sky and ground.
// In:  grids, looks, light, extinction, beams; cells_per_item. Global size: cell items, clouds.
// Out: of the finest level of each cloud [clouds][LEVEL_CELLS]: medium 1/m, faces, sources.
#include "clouds/diffusion.clh"

static inline float4 sky_of(const CloudLightParams light) {
  return (float4)(light.sky_red, light.sky_green, light.sky_blue, 0.0f);
}
static inline float4 ground_of(const CloudLightParams light) {
  return (float4)(light.ground_red, light.ground_green, light.ground_blue, 0.0f);
}

static inline float4 source_of(const CloudGrid grid, const CloudScattering look, const CloudLightParams light,
                               __global const float *restrict extinction, __global const float *restrict beams, int x,
                               int y, int z) {
  const float scattered = look.albedo_green * (1.0f - look.forward_share);
  const float transport = transport_share(look), empty = empty_extinction(grid);
  const float3 cell = grid_cell(grid);
  const int at = cell_index(x, y, z);
  const int place[3] = {x, y, z}, strides[3] = {1, CELLS, CELLS * CELLS};
  const float sizes[3] = {cell.x, cell.y, cell.z};
  float4 source = (float4)(0.0f);
  for (int sun = 0; sun < light.sun_count; ++sun) {
    __global const float *beam = beams + sun * CELLS_OF_CLOUD;
    const CloudSunLight from = light.suns[sun];
    const float ways[3] = {-from.x, -from.y, -from.z};
    const float speed = fmax(fmax(fabs(from.x) / cell.x, fabs(from.y) / cell.y), fabs(from.z) / cell.z);
    // The mean over a cell of e^-x around its middle is sinh(x) / x there.
    const float half_depth =
        clamp(0.5f * extinction[at] * (1.0f - forward_albedo(look)) / speed, 1e-3f, 40.0f);
    float amount = scattered * extinction[at] * beam[at] * sinh(half_depth) / half_depth;
    for (int axis = 0; axis < 3; ++axis) {
      float across = 0.0f;
      for (int side = -1; side <= 1; side += 2) {
        const int next = place[axis] + side;
        if (next < 0 || next >= CELLS) continue;
        const int neighbour = at + side * strides[axis];
        across += (float)side * extinction[neighbour] * beam[neighbour] / (transport * extinction[neighbour] + empty);
      }
      amount -= 0.5f * scattered * look.scaled_mean_cosine * ways[axis] * across / sizes[axis];
    }
    source += amount * (float4)(from.red, from.green, from.blue, 0.0f);
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side <= 1; ++side) {
      if (place[axis] != side * (CELLS - 1)) continue;
      // Sides see half of each hemisphere; top and bottom one.
      const float above = axis == 1 ? (float)side : 0.5f;
      const float conductance = side_conductance(sizes[axis], transport * extinction[at] + empty);
      source += 4.0f * PI * conductance * mix(ground_of(light), sky_of(light), above);
    }
  }
  return source;
}

// Conductances D / c^2 toward the next cell along x, y and z, 0 at the last, and the sum of those through sides.
static inline float4 faces_of(const CloudGrid grid, const CloudScattering look, __global const float *restrict extinction,
                              int x, int y, int z) {
  const float transport = transport_share(look), empty = empty_extinction(grid);
  const int at = cell_index(x, y, z), last = CELLS - 1;
  const float here = transport * extinction[at] + empty;
  const float3 c = grid_cell(grid);
  float4 faces = (float4)(0.0f);
  if (x < last) faces.x = 2.0f / (3.0f * c.x * c.x * (here + transport * extinction[at + 1] + empty));
  if (y < last) faces.y = 2.0f / (3.0f * c.y * c.y * (here + transport * extinction[at + CELLS] + empty));
  if (z < last) faces.z = 2.0f / (3.0f * c.z * c.z * (here + transport * extinction[at + CELLS * CELLS] + empty));
  if (x == 0 || x == last) faces.w += side_conductance(c.x, here);
  if (y == 0 || y == last) faces.w += side_conductance(c.y, here);
  if (z == 0 || z == last) faces.w += side_conductance(c.z, here);
  return faces;
}

__kernel void light_source(__global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
                           const CloudLightParams light, __global const float *restrict extinction,
                           __global const float *restrict beams, int cells_per_item, __global float *restrict medium,
                           __global float4 *restrict faces, __global float4 *restrict sources) {
  const size_t cloud = get_global_id(1);
  const CloudGrid grid = grids[cloud];
  const CloudScattering look = looks[cloud];
  extinction += cloud * CELLS_OF_CLOUD;
  beams += cloud * CLOUD_SUNS * CELLS_OF_CLOUD;
  __global float *restrict level_medium = medium + cloud * LEVEL_CELLS + FIRST_LEVEL;
  faces += cloud * LEVEL_CELLS + FIRST_LEVEL;
  sources += cloud * LEVEL_CELLS + FIRST_LEVEL;
  const int first = (int)get_global_id(0) * cells_per_item;
  for (int i = first; i < min(first + cells_per_item, CELLS_OF_CLOUD); ++i) {
    const int x = i % CELLS, y = i / CELLS % CELLS, z = i / (CELLS * CELLS);
    level_medium[i] = extinction[i];
    sources[i] = source_of(grid, look, light, extinction, beams, x, y, z);
    faces[i] = faces_of(grid, look, extinction, x, y, z);
  }
}
