// The sky as seen from one altitude under one sun, by marching along each ray; sky_radiance() reads it.
// In:  depth, scattering, ground: of the kernels ..._table of this folder.
// Out: table [SKY_VIEW_LAYERS][SKY_VIEW_ROWS][SKY_VIEW_COLUMNS] (r, g, b, 0), kcd/m2: layer 0 all light but
// what aerosols scattered once, layer 1 that without its phase function (kcd/m2 sr); coordinates of
// sky_radiance(). One work-item a texel of a layer.
#include "sky/atmosphere.clh"
#include "sky/scattering_lookup.clh"

#define STEPS 32

__kernel void view_table(const AtmosphereParams air, const SkyParams sky,
                         __global const float4* restrict depth, __global const float4* restrict scattering,
                         __global const float4* restrict ground, __global float4* restrict table) {
  const int column = (int)get_global_id(0);
  const int row = (int)get_global_id(1);
  const float horizon = sky_horizon_angle(air.ground_radius_m, sky.eye_altitude_m);
  const bool meets_ground = row >= SKY_VIEW_ROWS_ABOVE;
  const float up = 1.0f - (float)row / (SKY_VIEW_ROWS_ABOVE - 1);
  const float down = (float)(row - SKY_VIEW_ROWS_ABOVE) / (SKY_VIEW_ROWS_BELOW - 1);
  const float angle = meets_ground ? horizon + down * down * (SKY_PI - horizon) : horizon * (1.0f - up * up);
  const float sun_sine = sqrt(fmax(0.0f, 1.0f - sky.sun_direction_y * sky.sun_direction_y));
  const float between = cos(angle) * sky.sun_direction_y +
                        sin(angle) * sun_sine * cos(SKY_PI * column / (SKY_VIEW_COLUMNS - 1));
  const float rayleigh_phase = sky_rayleigh_phase(between);

  const RaySun seen_sun = {sky.sun_direction_y, between};
  Ray ray = ray_from(air, sky.eye_altitude_m, cos(angle), meets_ground);
  float4 light = (float4)(0.0f);
  float4 aerosol_light = (float4)(0.0f);
  for (int i = 0; i < STEPS; ++i) {
    const Slice slice = next_slice(air, &ray, i, STEPS);
    const float sun_cosine = sun_cosine_along(air, seen_sun, sky.eye_altitude_m, slice.distance, slice.altitude);
    const float4 sun = sunlight(air, depth, slice.altitude, sun_cosine);
    light +=
        slice.reach * (slice.air.rayleigh_perm * rayleigh_phase * sun +
                       (slice.air.rayleigh_perm + slice.air.aerosol_perm) *
                           scattering_lookup(scattering, air.thickness_m, slice.altitude, sun_cosine));
    aerosol_light += slice.reach * slice.air.aerosol_perm * sun;
  }
  if (ray.meets_ground) {
    light += ray.through * albedo_of_ground(air) / SKY_PI *
             ground_lookup(ground, sun_cosine_along(air, seen_sun, sky.eye_altitude_m, ray.end, 0.0f));
  }
  const int texel = row * SKY_VIEW_COLUMNS + column;
  table[texel] = (float4)(sky_rgb(sky, light), 0.0f);
  table[SKY_VIEW_ROWS * SKY_VIEW_COLUMNS + texel] = (float4)(sky_rgb(sky, aerosol_light), 0.0f);
}
