// The composed sea on a rectangle of rest labels.
// In:  displacement, gradient [cascades][n][n] float4 of ocean/surface_assemble.cl; gerstner_displacement,
//      gerstner_gradient [rows][pitch] float4 of ocean/gerstner_surface.cl, at these samples, unless the pitch is 0;
//      where the samples lie;
//      wake_maps of ocean/wakes/wake_map.cl, wakes and wake_samples (shared/wake.h) of wake_count windows.
// Out: position [rows][columns] float4 (dx, h, dz m, J); shape [rows][columns] float4 (slope x, slope z of the displaced
//      surface, smaller eigenvalue of F, 0). Cascades are bilinear between texels and periodic.
// Displacements, slopes and gradients add over cascades, Gerstner waves and wakes; then F = I + sum grad, slope = F^-T sum s, with |det F| kept
// above 0.05 where the surface is about to fold; or, as in the paper, slope = sum s. Lee & Lee 2007, eq. 7 and section 2.3 (O7, O9).
// The grid is in memory, not an argument by value: Mesa 22.3 crashes on arguments that are indexed by a variable.
#include "ocean/deformation.clh"
#include "ocean/tile_sample.clh"
#include "ocean/wakes/wake_layer.clh"
#include "shared/ocean_params.h"

__kernel void surface_compose(__global const float4 *restrict displacement, __global const float4 *restrict gradient,
                              __global const float4 *restrict gerstner_displacement,
                              __global const float4 *restrict gerstner_gradient,
                              __global const float4 *restrict wake_maps, __global const WakeLayer *restrict wakes,
                              __global const WakeSamples *restrict wake_samples, int wake_count,
                              __global const OceanComposeParams *restrict grid, int size,
                              __global float4 *restrict position, __global float4 *restrict shape) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  float4 moved = (float4)(0.0f), slopes = (float4)(0.0f);
  for (int cascade = 0; cascade < grid->cascade_count; ++cascade) {
    const size_t first = (size_t)cascade * size * size;
    const uint place_x = (uint)grid->origin_column[cascade] + (uint)column * (uint)grid->column_step[cascade];
    const uint place_z = (uint)grid->origin_row[cascade] + (uint)row * (uint)grid->row_step[cascade];
    const TilePlace place = tile_place(size, place_x, place_z);
    moved += TILE_SAMPLE(displacement + first, place);
    slopes += TILE_SAMPLE(gradient + first, place);
  }
  if (grid->gerstner_pitch > 0) {
    const size_t sample = (size_t)row * grid->gerstner_pitch + column;
    moved += gerstner_displacement[sample];
    slopes += gerstner_gradient[sample];
  }
  for (int i = 0; i < wake_count; ++i) {
    const float4 wake = wake_layer_at(wake_maps, wakes + i, wake_samples[i].column + (float)column * wake_samples[i].column_step,
                                      wake_samples[i].row + (float)row * wake_samples[i].row_step);
    moved.y += wake.x;
    slopes.xy += wake.yz;
  }
  const float xx = 1.0f + slopes.z, xz = moved.w, zz = 1.0f + slopes.w;
  const float2 jacobian = deformation_jacobian(xx, xz, zz);
  const float determinant = LIMITED_DETERMINANT(jacobian.x);
  const size_t place = (size_t)row * grid->columns + column;
  position[place] = (float4)(moved.xyz, jacobian.x);
  const float2 of_displaced_surface =
      (float2)(zz * slopes.x - xz * slopes.y, xx * slopes.y - xz * slopes.x) / determinant;
  shape[place] = (float4)(grid->adds_slopes ? slopes.xy : of_displaced_surface, jacobian.y, 0.0f);
}
