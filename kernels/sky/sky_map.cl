// The sky in all directions, without the sun's disc.
// In:  view_table of sky/view_table.cl.
// Out: map [rows][columns] (r, g, b, 1) kcd/m2, linear Rec.709. Row 0 looks up, the last row down, at the
// middle
//      of each texel; columns turn clockwise from north (-z) through east (+x). One work-item a texel.
#include "sky/clear_sky.clh"

__kernel void sky_map(const SkyParams sky, __global const float4* restrict view_table, int columns, int rows,
                      __global float4* restrict map) {
  const int column = (int)get_global_id(0);
  const int row = (int)get_global_id(1);
  const float azimuth = 2.0f * SKY_PI * (column + 0.5f) / columns;
  const float zenith_angle = SKY_PI * (row + 0.5f) / rows;
  const float3 direction =
      (float3)(sin(zenith_angle) * sin(azimuth), cos(zenith_angle), -sin(zenith_angle) * cos(azimuth));
  map[row * columns + column] = (float4)(sky_radiance(sky, view_table, direction), 1.0f);
}
