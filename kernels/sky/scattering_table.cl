// Light scattered twice and more, as if it came alike from all sides: Hillaire 2020, eq. 5 to 10. Light
// scattered twice is integrated over the sphere; each further order is taken as the order before times the
// share f of isotropic light that air and ground scatter once more, so that all orders add up to 1 / (1 - f).
// In:  depth of sky/depth_table.cl.
// Out: table [SKY_SCATTERING_ROWS][SKY_SCATTERING_COLUMNS], four wavelengths, 1/sr for sunlight of
// illuminance 1; coordinates of scattering_lookup(). One work-item a texel.
#include "sky/atmosphere.clh"
#include "sky/scattering_lookup.clh"

// Directions: rings of equal solid angle, azimuths of one side only (the other is its mirror image).
#define RINGS 24
#define AZIMUTHS 4
#define STEPS 24

__kernel void scattering_table(const AtmosphereParams air, __global const float4* restrict depth,
                               __global float4* restrict table) {
  const int column = (int)get_global_id(0);
  const int row = (int)get_global_id(1);
  const float fraction = (float)row / (SKY_SCATTERING_ROWS - 1);
  // A metre off either end: there the ray's length would be 0 / 0.
  const float altitude = clamp(air.thickness_m * fraction * fraction, 1.0f, air.thickness_m - 1.0f);
  const float sun_cosine = sun_cosine_of((float)column / (SKY_SCATTERING_COLUMNS - 1));
  const float sun_sine = sqrt(fmax(0.0f, 1.0f - sun_cosine * sun_cosine));
  const float horizon =
      -sky_horizon_distance(air.ground_radius_m, altitude) / (air.ground_radius_m + altitude);
  const float isotropic_phase = 1.0f / (4.0f * SKY_PI);

  float4 second = (float4)(0.0f);    // sum over directions of light scattered once
  float4 returned = (float4)(0.0f);  // of isotropic unit light that is scattered once more
  for (int ring = 0; ring < RINGS; ++ring) {
    const float cosine = 1.0f - 2.0f * (ring + 0.5f) / RINGS;
    const float across = sqrt(1.0f - cosine * cosine) * sun_sine;
    RaySun suns[AZIMUTHS];
    for (int i = 0; i < AZIMUTHS; ++i) {
      suns[i].cosine = sun_cosine;
      suns[i].between = cosine * sun_cosine + across * cos(SKY_PI * (i + 0.5f) / AZIMUTHS);
    }
    Ray ray = ray_from(air, altitude, cosine, cosine < horizon);
    for (int step = 0; step < STEPS; ++step) {
      const Slice slice = next_slice(air, &ray, step, STEPS);
      const float4 scattered = slice.reach * (slice.air.rayleigh_perm + slice.air.aerosol_perm);
      float4 light = (float4)(0.0f);
      for (int i = 0; i < AZIMUTHS; ++i) {
        const float there = sun_cosine_along(air, suns[i], altitude, slice.distance, slice.altitude);
        light += sunlight(air, depth, slice.altitude, there);
      }
      second += scattered * isotropic_phase * light;
      returned += (float)AZIMUTHS * scattered;
    }
    if (ray.meets_ground) {
      const float4 reflected = ray.through * albedo_of_ground(air);
      for (int i = 0; i < AZIMUTHS; ++i) {
        const float ground_sun = sun_cosine_along(air, suns[i], altitude, ray.end, 0.0f);
        second += reflected / SKY_PI * fmax(0.0f, ground_sun) * sunlight(air, depth, 0.0f, ground_sun);
      }
      returned += (float)AZIMUTHS * reflected;
    }
  }
  const float per_direction = 1.0f / (RINGS * AZIMUTHS);
  const float4 all = second * per_direction / (1.0f - returned * per_direction);
  // The first column also stands for all suns below it: night.
  table[row * SKY_SCATTERING_COLUMNS + column] = column == 0 ? (float4)(0.0f) : all;
}
