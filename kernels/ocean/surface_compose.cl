// The composed sea on a rectangle of rest labels.
// In:  displacement, gradient [cascades][n][n] float4 of ocean/surface_assemble.cl; where the samples lie.
// Out: position [rows][columns] float4 (dx, h, dz m, J); shape [rows][columns] float4 (slope x, slope z of the displaced
//      surface, smaller eigenvalue of F, 0). Cascades are bilinear between texels and periodic.
// Displacements, slopes and gradients add over cascades; then F = I + sum grad, slope = F^-T sum s, with |det F| kept
// above 0.05 where the surface is about to fold. Lee & Lee 2007, eq. 7 and section 2.3 (O7, O9).
// The grid is in memory, not an argument by value: Mesa 22.3 crashes on arguments that are indexed by a variable.
#include "ocean/deformation.clh"
#include "shared/ocean_params.h"

static float4 bilinear(__global const float4 *map, int size, float column, float row) {
  const float column_floor = floor(column), row_floor = floor(row);
  const int mask = size - 1;
  const int x0 = (int)column_floor & mask, x1 = (x0 + 1) & mask;
  const int z0 = (int)row_floor & mask, z1 = (z0 + 1) & mask;
  const float4 u = (float4)(column - column_floor), v = (float4)(row - row_floor);
  return mix(mix(map[z0 * size + x0], map[z0 * size + x1], u), mix(map[z1 * size + x0], map[z1 * size + x1], u), v);
}

__kernel void surface_compose(__global const float4 *restrict displacement, __global const float4 *restrict gradient,
                              __global const OceanComposeParams *restrict grid, int size,
                              __global float4 *restrict position, __global float4 *restrict shape) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  float4 moved = (float4)(0.0f), slopes = (float4)(0.0f);
  for (int cascade = 0; cascade < grid->cascade_count; ++cascade) {
    const size_t first = (size_t)cascade * size * size;
    const float texel_column = grid->origin_column[cascade] + (float)column * grid->column_step[cascade];
    const float texel_row = grid->origin_row[cascade] + (float)row * grid->row_step[cascade];
    moved += bilinear(displacement + first, size, texel_column, texel_row);
    slopes += bilinear(gradient + first, size, texel_column, texel_row);
  }
  const float xx = 1.0f + slopes.z, xz = moved.w, zz = 1.0f + slopes.w;
  const float2 jacobian = deformation_jacobian(xx, xz, zz);
  const float smallest_determinant = 0.05f;
  const float determinant = copysign(fmax(fabs(jacobian.x), smallest_determinant), jacobian.x);
  const size_t place = (size_t)row * grid->columns + column;
  position[place] = (float4)(moved.xyz, jacobian.x);
  shape[place] = (float4)((zz * slopes.x - xz * slopes.y) / determinant, (xx * slopes.y - xz * slopes.x) / determinant,
                          jacobian.y, 0.0f);
}
