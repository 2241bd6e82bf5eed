// What particle_scatter.cl reads of light that was scattered often.
// In:  grids, looks, light, extinction, beams; of light_diffuse.cl faces and fluence; cells_per_item. Global size: cell
//      items, clouds.
// Out: glow [clouds][cells]: light scattered toward any direction, kcd/m^2 per optical depth, and the extinction; drift:
//      3 g' F / u, by which more goes along the flux.
#include "clouds/diffusion.clh"

__kernel void light_glow(__global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
                         const CloudLightParams light, __global const float *restrict extinction,
                         __global const float *restrict beams, __global const float4 *restrict faces,
                         __global const float4 *restrict fluence, int cells_per_item, __global float4 *restrict glow,
                         __global float4 *restrict drift) {
  const size_t cloud = get_global_id(1);
  const CloudGrid grid = grids[cloud];
  const CloudScattering look = looks[cloud];
  extinction += cloud * CELLS_OF_CLOUD;
  beams += cloud * CLOUD_SUNS * CELLS_OF_CLOUD;
  glow += cloud * CELLS_OF_CLOUD;
  drift += cloud * CELLS_OF_CLOUD;
  faces += cloud * LEVEL_CELLS;
  fluence += cloud * LEVEL_CELLS;
  const float4 albedo = (float4)(look.albedo_red, look.albedo_green, look.albedo_blue, 1.0f);
  const float transport = transport_share(look), empty = empty_extinction(grid);
  const float scattered = look.albedo_green * (1.0f - look.forward_share);
  const int first = (int)get_global_id(0) * cells_per_item;
  for (int i = first; i < min(first + cells_per_item, CELLS_OF_CLOUD); ++i) {
    const int at = FIRST_LEVEL + i;
    const float4 next = faces[at];
    const float3 before = (float3)(faces[at - 1].x, faces[at - CELLS].y, faces[at - CELLS * CELLS].z);
    const float4 here = fluence[at];
    const float4 third = (float4)(1.0f / 3.0f, 1.0f / 3.0f, 1.0f / 3.0f, 0.0f);
    // Mean of the flows through both faces: conductance times cell is D / c.
    float3 flux = -0.5f * grid_cell(grid) *
                  (float3)(dot(third, next.x * (fluence[at + 1] - here) - before.x * (fluence[at - 1] - here)),
                           dot(third, next.y * (fluence[at + CELLS] - here) - before.y * (fluence[at - CELLS] - here)),
                           dot(third, next.z * (fluence[at + CELLS * CELLS] - here) -
                                          before.z * (fluence[at - CELLS * CELLS] - here)));
    for (int sun = 0; sun < light.sun_count; ++sun) {
      const CloudSunLight from = light.suns[sun];
      const float strength = scattered * look.scaled_mean_cosine * extinction[i] * beams[sun * CELLS_OF_CLOUD + i] /
                             (transport * extinction[i] + empty) * (from.red + from.green + from.blue) / 3.0f;
      flux -= strength * (float3)(from.x, from.y, from.z);
    }
    const float3 lean = 3.0f * look.scaled_mean_cosine * flux / fmax(dot(third, here), 1e-20f);
    // Where diffusion fails, flux would exceed what there is to flow.
    drift[i] = (float4)(lean * fmin(1.0f, rsqrt(fmax(dot(lean, lean), 1e-20f))), 0.0f);
    const float4 light_here = fmax(here, 0.0f) * albedo * (1.0f - look.forward_share) / (4.0f * PI);
    glow[i] = (float4)(light_here.xyz, extinction[i]);
  }
}
