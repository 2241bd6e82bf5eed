// What each cell of the clouds' grids sends on in each direction, of the suns' beams and of the light that is known there.
// In:    grids, looks, lights, medium, absorption, beams; faces and fluence of light_diffuse.cl; the first cloud; whether
//        these are the first sweeps. Global size: items that share the cells, clouds from it on.
// Inout: moments [clouds][grid.room][4] of diffusion.clh: of the last sweeps, if there are any, then with what was
//        diffused.
// Out:   emission [clouds][grid.room][4]: radiance toward d is e0 + e1 d.x + e2 d.y + e3 d.z, kcd/m^2 per depth in the scaled
//        medium; e0.w, e1.w and e2.w are the scaled extinction of red, green and blue, 1/m.
#include "clouds/diffusion.clh"

// The mean over a cell of e^-x around its middle is sinh(x) / x there.
static inline float4 mean_of_beam(float4 half_depth, int channels) {
  if (channels == 1) {
    const float x = clamp(half_depth.x, 1e-2f, 40.0f), grown = exp(x);
    return (float4)((grown - 1.0f / grown) / (2.0f * x));
  }
  const float4 x = clamp(half_depth, 1e-2f, 40.0f), grown = exp(x);
  return (grown - 1.0f / grown) / (2.0f * x);
}

// transport_extinction() of each colour.
static inline float4 transport_of(const CloudScattering look, float empty, float4 extinction, float4 absorption) {
  const float g = look.forward_share + (1.0f - look.forward_share) * look.scaled_mean_cosine;
  const float4 transport = (1.0f - g) * extinction + g * absorption;
  return sqrt(transport * transport + empty * empty);
}

__kernel void light_emission(__global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
                             __global const CloudLightParams *restrict lights, __global const float *restrict medium,
                             __global const float *restrict absorption, __global const float *restrict beams,
                             __global const float *restrict faces, __global const float *restrict fluence,
                             int first_cloud, int channels, int is_first, __global float4 *restrict moments,
                             __global float4 *restrict emission) {
  const size_t number = get_global_id(1), cloud = first_cloud + number;
  const CloudGrid grid = grids[cloud];
  const CloudScattering look = looks[cloud];
  __global const CloudLightParams *light = lights + cloud;
  medium += cloud * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid);
  absorption += cloud * channels * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid);
  beams += CLOUD_BEAM_MARGIN + cloud * light->sun_count * channels * grid.room;
  faces += number * channels * 4 * LEVEL_CELLS(grid);
  fluence += number * 3 * LEVEL_CELLS(grid);
  moments += number * 4 * grid.room;
  emission += number * 4 * grid.room;
  const int cells = grid.size_x * grid.size_y * grid.size_z;
  const float empty = empty_extinction(grid), lean = 3.0f * look.scaled_mean_cosine;
  for (int cell = (int)get_global_id(0); cell < cells; cell += (int)get_global_size(0)) {
    const float4 extinction = (float4)(medium[cell]), absorbed = colours_at(absorption, channels, MEDIUM_CELLS(grid), cell);
    const float4 scattered = (1.0f - look.forward_share) * (extinction - absorbed);
    const float4 scaled = scaled_extinction(look, extinction, absorbed);
    Moments found = {(float4)(0.0f), (float4)(0.0f), (float4)(0.0f), (float4)(0.0f)};
    if (!is_first) found = moments_at(moments, cell);
    found = with_diffused(found, grid, faces, fluence, channels, cell);
    Moments lit_by_suns = {(float4)(0.0f), (float4)(0.0f), (float4)(0.0f), (float4)(0.0f)};
    for (int sun = 0; sun < light->sun_count; ++sun) {
      const CloudLightSource from = light->suns[sun];
      const float speed =
          fmax(fmax(fabs(from.x) / grid.cell_x, fabs(from.y) / grid.cell_y), fabs(from.z) / grid.cell_z);
      const float4 lit = colours_at(beams + sun * channels * grid.room, channels, grid.room, cell) *
                         (float4)(from.red, from.green, from.blue, 0.0f) * mean_of_beam(0.5f / speed * scaled, channels);
      lit_by_suns.fluence += lit;
      lit_by_suns.x -= from.x * lit;
      lit_by_suns.y -= from.y * lit;
      lit_by_suns.z -= from.z * lit;
    }
    if (is_first) {
      // What leans along the beams is part of the flux of what is diffused.
      const float4 leaning = look.scaled_mean_cosine * scattered / transport_of(look, empty, extinction, absorbed);
      found.x += leaning * lit_by_suns.x;
      found.y += leaning * lit_by_suns.y;
      found.z += leaning * lit_by_suns.z;
    }
    store_moments(found, moments, cell);
    found.fluence += lit_by_suns.fluence;
    found.x += lit_by_suns.x;
    found.y += lit_by_suns.y;
    found.z += lit_by_suns.z;
    const float4 share = scattered / fmax(scaled, (float4)(1e-20f)) / (4.0f * PI);
    emission[4 * cell] = (float4)((share * found.fluence).xyz, scaled.x);
    emission[4 * cell + 1] = (float4)((lean * share * found.x).xyz, scaled.y);
    emission[4 * cell + 2] = (float4)((lean * share * found.y).xyz, scaled.z);
    emission[4 * cell + 3] = lean * share * found.z;
  }
}
