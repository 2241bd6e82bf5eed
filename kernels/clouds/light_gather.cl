// The moments of the light of all directions, and what one more scattering adds to them: sources of light_diffuse.cl.
// In:    grids, looks, medium, absorption; radiances of light_sweep.cl; the first cloud. Global size: items that share the
//        cells, clouds from it on.
// Inout: moments [clouds][grid.room][4]: those that the sweeps began with, then of their light.
// Out:   of the finest level of each of these clouds, sources [clouds][3][LEVEL_CELLS].
#include "clouds/diffusion.clh"

// Scaled depths of a cell between which sweeps give way to diffusion: across thick cells diffusion is right, and sweeps
// are not.
#define THIN_DEPTH 1.5f
#define THICK_DEPTH 5.0f

// How far the light of each colour in a cell is that of sweeps, 0 ... 1.
static inline float4 swept_share(const CloudGrid grid, const CloudScattering look, float4 extinction, float4 absorption) {
  const float longest = fmax(grid.cell_x, fmax(grid.cell_y, grid.cell_z));
  const float4 depth = longest * scaled_extinction(look, extinction, absorption);
  return 1.0f - smoothstep((float4)(THIN_DEPTH), (float4)(THICK_DEPTH), depth);
}

__kernel void light_gather(__global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
                           __global const float *restrict medium, __global const float *restrict absorption,
                           __global const float4 *restrict radiances, int first_cloud, int channels,
                           __global float4 *restrict moments, __global float *restrict sources) {
  const size_t number = get_global_id(1), cloud = first_cloud + number;
  const CloudGrid grid = grids[cloud];
  const CloudScattering look = looks[cloud];
  medium += cloud * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid);
  absorption += cloud * channels * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid);
  radiances += number * DIRECTIONS * grid.room;
  moments += number * 4 * grid.room;
  sources += number * 3 * LEVEL_CELLS(grid) + FIRST_LEVEL(grid);
  const int cells = grid.size_x * grid.size_y * grid.size_z;
  const float solid_angle = 4.0f * PI / (float)DIRECTIONS;
  for (int cell = (int)get_global_id(0); cell < cells; cell += (int)get_global_size(0)) {
    Moments found = {(float4)(0.0f), (float4)(0.0f), (float4)(0.0f), (float4)(0.0f)};
    for (int direction = 0; direction < DIRECTIONS; ++direction) {
      const float4 light = solid_angle * radiances[direction * grid.room + cell];
      found.fluence += light;
      found.x += COSINE * direction_sign(direction, 0) * light;
      found.y += COSINE * direction_sign(direction, 1) * light;
      found.z += COSINE * direction_sign(direction, 2) * light;
    }
    const float4 absorbed = colours_at(absorption, channels, MEDIUM_CELLS(grid), cell), extinction = (float4)(medium[cell]);
    const float4 share = swept_share(grid, look, extinction, absorbed);
    const Moments before = moments_at(moments, cell);
    found.fluence = mix(before.fluence, found.fluence, share);
    found.x = mix(before.x, found.x, share);
    found.y = mix(before.y, found.y, share);
    found.z = mix(before.z, found.z, share);
    const float4 more = (1.0f - look.forward_share) * (extinction - absorbed) * (found.fluence - before.fluence);
    store_moments(found, moments, cell);
    sources[cell] = more.x;
    sources[LEVEL_CELLS(grid) + cell] = more.y;
    sources[2 * LEVEL_CELLS(grid) + cell] = more.z;
  }
}
