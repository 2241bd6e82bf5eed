// What scatters toward the eye in each cell of the light's grid of clouds that are marched: light that was scattered
// before, and that of sky and ground.
// In:  volumes [get_global_size(1)], grids, looks, absorption; glow and drift of light_glow.cl; the eye.
// Out: sources [slots][grid.room][SOURCE_VECTORS]: kcd/m^2 per depth of what scatters; of three channels also their albedo.
#include "clouds/march/march_source.clh"

__kernel void march_source(__global const CloudMarchVolume *restrict volumes, __global const CloudGrid *restrict grids,
                           __global const float *restrict absorption, __global const float4 *restrict glow,
                           __global const float4 *restrict drift, float eye_x_m, float eye_y_m, float eye_z_m,
                           __global float4 *restrict sources) {
  const CloudMarchVolume volume = volumes[get_global_id(1)];
  const size_t cloud = volume.cloud;
  const CloudGrid grid = grids[cloud];
  absorption += cloud * CHANNELS * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid);
  glow += cloud * grid.room;
  drift += cloud * CHANNELS * grid.room;
  sources += (size_t)volume.slot * SOURCE_VECTORS * grid.room;
  const int cells = grid.size_x * grid.size_y * grid.size_z;
  const float3 eye = cells_at(grid, (float3)(eye_x_m, eye_y_m, eye_z_m)), cell_m = grid_cell(grid);
  for (int cell = (int)get_global_id(0); cell < cells; cell += (int)get_global_size(0)) {
    const float3 at = (float3)((float)(cell % grid.size_x), (float)(cell / grid.size_x % grid.size_y),
                               (float)(cell / (grid.size_x * grid.size_y))) + 0.5f;
    const float3 way = (eye - at) * cell_m;
    const float3 view = way * rsqrt(fmax(dot(way, way), 1e-20f));
    const float4 found = glow[cell];
    float toward_eye[CHANNELS];
    for (int channel = 0; channel < CHANNELS; ++channel)
      toward_eye[channel] = fmax(0.0f, 1.0f + dot(drift[channel * grid.room + cell].xyz, view));
#if CHANNELS == 1
    sources[cell] = (float4)(toward_eye[0] * found.xyz, 0.0f);
#else
    sources[2 * cell] = (float4)((float3)(toward_eye[0], toward_eye[1], toward_eye[2]) * found.xyz, 0.0f);
    const float3 absorbed = (float3)(absorption[cell], absorption[MEDIUM_CELLS(grid) + cell], absorption[2 * MEDIUM_CELLS(grid) + cell]);
    sources[2 * cell + 1] = (float4)(clamp(1.0f - absorbed / fmax(found.w, 1e-30f), 0.0f, 1.0f), 0.0f);
#endif
  }
}
