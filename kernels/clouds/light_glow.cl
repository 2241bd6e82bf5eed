// What particle_scatter.cl reads of light that was scattered often.
// In:  grids, looks, light, medium, beams; of light_diffuse.cl faces and fluence. Global size: items that share the cells,
//      clouds.
// Out: glow [clouds][CELLS]: light scattered toward any direction, kcd/m^2 per optical depth, and the extinction; drift
//      [clouds][CELLS]: LEAN g' F / u, by which more goes along the flux.
#include "clouds/diffusion.clh"

// By P1 it is 3, as deep inside. Of the surface, which the eye sees, that makes the side away from the sun too bright and
// the side toward it too dark: fitted (host/clouds/particle_light.cpp).
#define LEAN 1.5f

// Mean of the colours' fluence.
static inline lanes fluence_at(__global const float *fluence, int at) {
  return (load_lanes(fluence + at) + load_lanes(fluence + LEVEL_CELLS + at) +
          load_lanes(fluence + 2 * LEVEL_CELLS + at)) * (1.0f / 3.0f);
}

// Mean of the flows through both faces across an axis: conductance times cell is D / c.
static inline lanes flux_along(__global const float *faces, __global const float *fluence, int at, int step, float cell) {
  const lanes here = fluence_at(fluence, at);
  return -0.5f * cell * (load_lanes(faces + at) * (fluence_at(fluence, at + step) - here) -
                         load_lanes(faces + at - step) * (fluence_at(fluence, at - step) - here));
}

__kernel void light_glow(__global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
                         const CloudLightParams light, __global const float *restrict medium,
                         __global const float *restrict beams, __global const float *restrict faces,
                         __global const float *restrict fluence, __global float4 *restrict glow,
                         __global float4 *restrict drift) {
  const size_t cloud = get_global_id(1);
  const CloudGrid grid = grids[cloud];
  const CloudScattering look = looks[cloud];
  medium += cloud * LEVEL_CELLS;
  beams += FIRST_BEAM + cloud * CLOUD_SUNS * CELLS;
  faces += cloud * 4 * LEVEL_CELLS;
  fluence += cloud * 3 * LEVEL_CELLS;
  __global float *glow_cells = (__global float *)(glow + cloud * CELLS);
  __global float *drift_cells = (__global float *)(drift + cloud * CELLS);
  const Level level = finest_level(grid);
  const float transport = transport_share(look), empty = empty_extinction(grid);
  const float scattered = look.albedo_green * (1.0f - look.forward_share);
  const float shown = (1.0f - look.forward_share) / (4.0f * PI);
  for (int i = (int)get_global_id(0); i < level_pieces(level); i += (int)get_global_size(0)) {
    const int at = piece_of(level, i).at, cell = at - FIRST_LEVEL;
    const lanes extinction = load_lanes(medium + at);
    lanes x = flux_along(faces + FACES_X, fluence, at, 1, grid.cell_x);
    lanes y = flux_along(faces + FACES_Y, fluence, at, level.pitch, grid.cell_y);
    lanes z = flux_along(faces + FACES_Z, fluence, at, level.pitch * level.size_y, grid.cell_z);
    for (int sun = 0; sun < light.sun_count; ++sun) {
      const CloudSunLight from = light.suns[sun];
      const lanes strength = scattered * look.scaled_mean_cosine * (from.red + from.green + from.blue) / 3.0f * extinction *
                             load_lanes(beams + sun * CELLS + cell) / transport_extinction(extinction, transport, empty);
      x -= strength * from.x;
      y -= strength * from.y;
      z -= strength * from.z;
    }
    const lanes scale = LEAN * look.scaled_mean_cosine / most(fluence_at(fluence, at), (lanes)1e-20f);
    x *= scale;
    y *= scale;
    z *= scale;
    // Where diffusion fails, flux would exceed what there is to flow.
    const lanes limit = least((lanes)1.0f, 1.0f / sqrt(most(x * x + y * y + z * z, (lanes)1e-20f)));
    store_interleaved_4(x * limit, y * limit, z * limit, (lanes)0.0f, drift_cells + 4 * cell);
    const lanes red = most(load_lanes(fluence + at), (lanes)0.0f);
    const lanes green = most(load_lanes(fluence + LEVEL_CELLS + at), (lanes)0.0f);
    const lanes blue = most(load_lanes(fluence + 2 * LEVEL_CELLS + at), (lanes)0.0f);
    store_interleaved_4(look.albedo_red * shown * red, look.albedo_green * shown * green,
                        look.albedo_blue * shown * blue, extinction, glow_cells + 4 * cell);
  }
}
