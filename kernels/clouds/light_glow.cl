// What particle_scatter.cl reads of light that was scattered often.
// In:  grids, looks, medium; moments of light_gather.cl, faces and fluence of light_diffuse.cl; the first cloud. Global size:
//      items that share the cells, clouds from it on.
// Out: glow [clouds][grid.room]: light scattered toward any direction, kcd/m^2 per depth of what scatters, and the extinction;
//      drift [clouds][channels][grid.room]: lean 3 g' F / u, by which more goes along the flux.
#include "clouds/diffusion.clh"

__kernel void light_glow(__global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
                         __global const float *restrict medium, __global const float *restrict faces,
                         __global const float *restrict fluence, __global const float4 *restrict moments,
                         int first_cloud, int channels, __global float4 *restrict glow, __global float4 *restrict drift) {
  const size_t number = get_global_id(1), cloud = first_cloud + number;
  const CloudGrid grid = grids[cloud];
  const CloudScattering look = looks[cloud];
  medium += cloud * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid);
  faces += number * channels * 4 * LEVEL_CELLS(grid);
  fluence += number * 3 * LEVEL_CELLS(grid);
  moments += number * 4 * grid.room;
  glow += cloud * grid.room;
  drift += cloud * channels * grid.room;
  const int cells = grid.size_x * grid.size_y * grid.size_z;
  const float shown = (1.0f - look.forward_share) / (4.0f * PI);
  for (int cell = (int)get_global_id(0); cell < cells; cell += (int)get_global_size(0)) {
    const Moments found = with_diffused(moments_at(moments, cell), grid, faces, fluence, channels, cell);
    glow[cell] = (float4)(shown * found.fluence.xyz, medium[cell]);
    for (int channel = 0; channel < channels; ++channel) {
      // One channel is that of all colours.
      const float4 of_channel = channels == 1 ? (float4)(1.0f, 1.0f, 1.0f, 0.0f)
                                              : (float4)(channel == 0, channel == 1, channel == 2, 0.0f);
      const float3 flux = (float3)(dot(found.x, of_channel), dot(found.y, of_channel), dot(found.z, of_channel));
      const float3 lean = 3.0f * look.scaled_mean_cosine / fmax(dot(found.fluence, of_channel), 1e-20f) * flux;
      // Flux cannot exceed what there is to flow.
      drift[channel * grid.room + cell] = (float4)(lean * fmin(1.0f, rsqrt(fmax(dot(lean, lean), 1e-20f))), 0.0f);
    }
  }
}
