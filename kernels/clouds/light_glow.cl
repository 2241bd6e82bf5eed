// What particle_scatter.cl reads of light that was scattered often.
// In:  grids, looks, lights, medium, absorption, beams; of light_diffuse.cl faces and fluence. Global size: items that share
//      the cells, clouds.
// Out: glow [clouds][CELLS]: light scattered toward any direction, kcd/m^2 per depth of what scatters, and the extinction;
//      drift [clouds][channels][CELLS]: lean g' F / u, by which more goes along the flux.
#include "clouds/diffusion.clh"

// By P1 it is 3, as deep inside, or where light that was scattered once is soon absorbed. Of the surface of what scatters
// all, which the eye sees, that makes the side away from the sun too bright and the side toward it too dark: half of it,
// fitted (host/clouds/light/particle_light.cpp); between these by the albedo of the scaled medium.
#define LEAN_OF_ONCE 3.0f
#define LEAN_LOST 1.5f

// Sum of `colours` fluences from one on: those of all colours, where one channel stands for them.
static inline lanes fluence_at(__global const float *fluence, int colours, int at) {
  lanes sum = load_lanes(fluence + at);
  for (int colour = 1; colour < colours; ++colour) sum += load_lanes(fluence + colour * LEVEL_CELLS + at);
  return sum;
}

// Mean of the flows through both faces across an axis: conductance times cell is D / c.
static inline lanes flux_along(__global const float *faces, __global const float *fluence, int colours, int at, int step,
                               float cell) {
  const lanes here = fluence_at(fluence, colours, at);
  return -0.5f * cell * (load_lanes(faces + at) * (fluence_at(fluence, colours, at + step) - here) -
                         load_lanes(faces + at - step) * (fluence_at(fluence, colours, at - step) - here));
}

__kernel void light_glow(__global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
                         __global const CloudLightParams *restrict lights, __global const float *restrict medium,
                         __global const float *restrict absorption, __global const float *restrict beams,
                         __global const float *restrict faces, __global const float *restrict fluence, int channels,
                         __global float4 *restrict glow, __global float4 *restrict drift) {
  const size_t cloud = get_global_id(1);
  const CloudGrid grid = grids[cloud];
  const CloudScattering look = looks[cloud];
  const CloudLightParams light = lights[cloud];
  medium += cloud * MEDIUM_CELLS;
  absorption += cloud * channels * MEDIUM_CELLS;
  beams += CLOUD_BEAM_MARGIN + cloud * light.sun_count * channels * CELLS;
  faces += cloud * channels * 4 * LEVEL_CELLS;
  fluence += cloud * 3 * LEVEL_CELLS;
  __global float *glow_cells = (__global float *)(glow + cloud * CELLS);
  __global float *drift_cells = (__global float *)(drift + cloud * channels * CELLS);
  const Level level = finest_level(grid);
  const float empty = empty_extinction(grid);
  const float shown = (1.0f - look.forward_share) / (4.0f * PI);
  const int colours = channels == 1 ? 3 : 1;
  for (int i = (int)get_global_id(0); i < level_pieces(level); i += (int)get_global_size(0)) {
    const int at = piece_of(level, i).at, cell = at - FIRST_LEVEL;
    const lanes extinction = load_lanes(medium + at);
    for (int channel = 0; channel < channels; ++channel) {
      __global const float *ways = faces + channel * 4 * LEVEL_CELLS, *of_channel = fluence + channel * LEVEL_CELLS;
      lanes x = flux_along(ways + FACES_X, of_channel, colours, at, 1, grid.cell_x);
      lanes y = flux_along(ways + FACES_Y, of_channel, colours, at, level.pitch, grid.cell_y);
      lanes z = flux_along(ways + FACES_Z, of_channel, colours, at, level.pitch * level.size_y, grid.cell_z);
      const lanes absorbed = load_lanes(absorption + channel * MEDIUM_CELLS + at);
      const lanes scattered = (1.0f - look.forward_share) * (extinction - absorbed);
      const lanes beside = look.scaled_mean_cosine * scattered / transport_extinction(look, empty, extinction, absorbed);
      for (int sun = 0; sun < light.sun_count; ++sun) {
        const CloudLightSource from = light.suns[sun];
        const float rgb[3] = {from.red, from.green, from.blue};
        const lanes strength = (channels == 1 ? from.red + from.green + from.blue : rgb[channel]) * beside *
                               load_lanes(beams + (sun * channels + channel) * CELLS + cell);
        x -= strength * from.x;
        y -= strength * from.y;
        z -= strength * from.z;
      }
      const lanes lean = LEAN_OF_ONCE - LEAN_LOST * scattered / most(scattered + absorbed, (lanes)1e-20f);
      const lanes scale =
          lean * look.scaled_mean_cosine / most(fluence_at(of_channel, colours, at), (lanes)1e-20f);
      x *= scale;
      y *= scale;
      z *= scale;
      // Where diffusion fails, flux would exceed what there is to flow.
      const lanes limit = least((lanes)1.0f, 1.0f / sqrt(most(x * x + y * y + z * z, (lanes)1e-20f)));
      store_interleaved_4(x * limit, y * limit, z * limit, (lanes)0.0f, drift_cells + 4 * (channel * CELLS + cell));
    }
    const lanes red = load_lanes(fluence + at), green = load_lanes(fluence + LEVEL_CELLS + at),
                blue = load_lanes(fluence + 2 * LEVEL_CELLS + at);
    store_interleaved_4(shown * most(red, (lanes)0.0f), shown * most(green, (lanes)0.0f),
                        shown * most(blue, (lanes)0.0f), extinction, glow_cells + 4 * cell);
  }
}
