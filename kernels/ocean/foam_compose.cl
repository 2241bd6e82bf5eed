// Foam of the composed sea on a rectangle of rest labels.
// In:  foam [cascades][n][n] of ocean/foam_decay.cl; gradient [cascades][n][n] float4 of ocean/surface_assemble.cl;
//      gerstner_gradient [rows][pitch] float4 of ocean/gerstner_surface.cl,
//      at these samples, unless the pitch is 0; gathering [cascades] float2, factor and steepness
//      (host/ocean/surface/foam_onset.h); wake_shown of ocean/wakes/wake_shown.cl, wakes and wake_samples (shared/wake.h) of
//      wake_count windows; where the samples lie.
// Out: composed [rows][columns], 0 ... 1: 1 - product over the cascades of 1 - min(1, factor exp(steepness p) foam), p
//      the compression by Gerstner waves and longer cascades, -(d dx/dx + d dz/dz), and over the wakes of 1 - foam.
#include "ocean/tile_sample.clh"
#include "ocean/wakes/wake_layer.clh"
#include "shared/ocean_params.h"

__kernel void foam_compose(__global const float *restrict foam, __global const float4 *restrict gradient,
                           __global const float4 *restrict gerstner_gradient,
                           __global const float2 *restrict gathering, __global const float4 *restrict wake_shown,
                           __global const WakeLayer *restrict wakes, __global const WakeSamples *restrict wake_samples,
                           int wake_count, __global const OceanComposeParams *restrict grid,
                           int size, __global float *restrict composed) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  float compression = 0.0f;
  if (grid->gerstner_pitch > 0) {
    const float4 gradient = gerstner_gradient[(size_t)row * grid->gerstner_pitch + column];
    compression = -(gradient.z + gradient.w);
  }
  float bare = 1.0f;
  for (int cascade = 0; cascade < grid->cascade_count; ++cascade) {
    const size_t first = (size_t)cascade * size * size;
    const TilePlace place =
        tile_place(size, (uint)grid->origin_column[cascade] + (uint)column * (uint)grid->column_step[cascade],
                   (uint)grid->origin_row[cascade] + (uint)row * (uint)grid->row_step[cascade]);
    const float more = gathering[cascade].x * exp(gathering[cascade].y * compression);
    bare *= 1.0f - fmin(more * TILE_SAMPLE(foam + first, place), 1.0f);
    const float4 here = TILE_SAMPLE(gradient + first, place);
    compression -= here.z + here.w;
  }
  for (int i = 0; i < wake_count; ++i) {
    const float foam = wake_layer_at(wake_shown, wakes + i, wake_samples[i].column + (float)column * wake_samples[i].column_step,
                                     wake_samples[i].row + (float)row * wake_samples[i].row_step).w;
    bare *= 1.0f - foam;
  }
  composed[(size_t)row * grid->columns + column] = 1.0f - bare;
}
