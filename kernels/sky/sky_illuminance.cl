// What the sky and the sun give to a surface at the eye.
// In:  view_table, depth_table of this folder.
// Out: parts [SKY_ILLUMINANCE_RINGS + 1] (r, g, b, 0) klx: for each ring of the upper hemisphere, all of
// equal projected solid angle, its part of the illuminance of a level surface by the sky alone; then the
// illuminance of a surface that faces the sun, by the sun alone. One work-item a part.
#include "sky/clear_sky.clh"

#define AZIMUTHS 64

__kernel void sky_illuminance(const SkyParams sky, __global const float4* restrict view_table,
                              __global const float4* restrict depth_table, __global float4* restrict parts) {
  const int ring = (int)get_global_id(0);
  if (ring == SKY_ILLUMINANCE_RINGS) {
    const float4 share = sky_sun_share(depth_table, sky.ground_radius_m, sky.thickness_m,
                                       sky.sun_angular_radius_rad, sky.eye_altitude_m, sky.sun_direction_y);
    parts[ring] = (float4)(sky_rgb(sky, share), 0.0f);
    return;
  }
  const float sine2 = (ring + 0.5f) / SKY_ILLUMINANCE_RINGS;
  float3 sum = (float3)(0.0f, 0.0f, 0.0f);
  for (int i = 0; i < AZIMUTHS; ++i) {
    const float azimuth = 2.0f * SKY_PI * (i + 0.5f) / AZIMUTHS;
    const float3 direction =
        (float3)(sqrt(sine2) * sin(azimuth), sqrt(1.0f - sine2), -sqrt(sine2) * cos(azimuth));
    sum += sky_radiance(sky, view_table, direction);
  }
  parts[ring] = (float4)(sum * (SKY_PI / (AZIMUTHS * SKY_ILLUMINANCE_RINGS)), 0.0f);
}
