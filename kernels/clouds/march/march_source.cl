// What scatters toward the eye in each cell of the light's grid of clouds that are marched: light that was scattered
// before, and that of sky and ground.
// In:  volumes [get_global_size(1)], grids, looks, absorption; glow and drift of light_glow.cl; the eye.
// Out: sources [slots][SOURCE_VALUES][grid.room] in pairs along x: kcd/m^2 per depth of what scatters; of three channels
//      also the share that is absorbed.
#include "clouds/march/march_pairs.clh"
#include "clouds/march/march_source.clh"

// What of a cloud's grid counts, and the eye in its cells.
typedef struct {
  CloudGrid grid;
  __global const float *absorption;
  __global const float4 *glow, *drift;
  float3 eye;
} SourceFields;

static inline void source_of(const SourceFields *fields, int cell, float values[SOURCE_VALUES]) {
  const CloudGrid grid = fields->grid;
  const float3 at = (float3)((float)(cell % grid.size_x), (float)(cell / grid.size_x % grid.size_y),
                             (float)(cell / (grid.size_x * grid.size_y))) + 0.5f;
  const float3 way = (fields->eye - at) * grid_cell(grid);
  const float3 view = way * rsqrt(fmax(dot(way, way), 1e-20f));
  const float4 found = fields->glow[cell];
  float toward_eye[CHANNELS];
  for (int channel = 0; channel < CHANNELS; ++channel)
    toward_eye[channel] = fmax(0.0f, 1.0f + dot(fields->drift[channel * grid.room + cell].xyz, view));
  values[0] = toward_eye[0] * found.x;
  values[1] = toward_eye[CHANNELS / 2] * found.y;
  values[2] = toward_eye[CHANNELS - 1] * found.z;
#if CHANNELS > 1
  for (int channel = 0; channel < CHANNELS; ++channel)
    values[3 + channel] =
        clamp(fields->absorption[channel * MEDIUM_CELLS(grid) + cell] / fmax(found.w, 1e-30f), 0.0f, 1.0f);
#endif
}

__kernel void march_source(__global const CloudMarchVolume *restrict volumes, __global const CloudGrid *restrict grids,
                           __global const float *restrict absorption, __global const float4 *restrict glow,
                           __global const float4 *restrict drift, float eye_x_m, float eye_y_m, float eye_z_m,
                           __global uint *restrict sources) {
  const CloudMarchVolume volume = volumes[get_global_id(1)];
  const size_t cloud = volume.cloud;
  const CloudGrid grid = grids[cloud];
  const SourceFields fields = {grid, absorption + cloud * CHANNELS * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid),
                               glow + cloud * grid.room, drift + cloud * CHANNELS * grid.room,
                               cells_at(grid, (float3)(eye_x_m, eye_y_m, eye_z_m))};
  sources += (size_t)volume.slot * SOURCE_VALUES * grid.room;
  const int cells = grid.size_x * grid.size_y * grid.size_z;
  for (int cell = (int)get_global_id(0); cell < cells; cell += (int)get_global_size(0)) {
    float own[SOURCE_VALUES], next[SOURCE_VALUES];
    source_of(&fields, cell, own);
    source_of(&fields, min(cell + 1, cells - 1), next);
    for (int i = 0; i < SOURCE_VALUES; ++i) sources[i * grid.room + cell] = pair_of(own[i], next[i]);
  }
}
