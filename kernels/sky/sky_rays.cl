// The sky and the sun's disc along any directions.
// In:  view_table, depth_table of this folder; directions [n] (x, y, z, ignored), unit, away from the
// eye. Out: sky_light, sun_light [n] (r, g, b, 1) kcd/m2, linear Rec.709: what is seen is their sum. One
// work-item a ray.
#include "sky/clear_sky.clh"

__kernel void sky_rays(const SkyParams sky, __global const float4* restrict view_table,
                       __global const float4* restrict depth_table,
                       __global const float4* restrict directions, __global float4* restrict sky_light,
                       __global float4* restrict sun_light) {
  const int ray = (int)get_global_id(0);
  const float3 direction = directions[ray].xyz;
  sky_light[ray] = (float4)(sky_radiance(sky, view_table, direction), 1.0f);
  sun_light[ray] = (float4)(sky_sun_disc(sky, depth_table, direction), 1.0f);
}
