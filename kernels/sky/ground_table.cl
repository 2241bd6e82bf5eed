// Light of sun and sky on the level ground.
// In:  depth, scattering: of sky/depth_table.cl and sky/scattering_table.cl.
// Out: table [SKY_SCATTERING_COLUMNS], four wavelengths: illuminance for sunlight of illuminance 1, by the
// sun's zenith cosine as in ground_lookup(). One work-item a texel.
#include "sky/atmosphere.clh"
#include "sky/scattering_lookup.clh"

// Directions: rings of equal projected solid angle, azimuths of one side only.
#define RINGS 24
#define AZIMUTHS 8
#define STEPS 24

__kernel void ground_table(const AtmosphereParams air, float aerosol_asymmetry,
                           __global const float4* restrict depth, __global const float4* restrict scattering,
                           __global float4* restrict table) {
  const int column = (int)get_global_id(0);
  const float sun_cosine = sun_cosine_of((float)column / (SKY_SCATTERING_COLUMNS - 1));
  const float sun_sine = sqrt(fmax(0.0f, 1.0f - sun_cosine * sun_cosine));
  float4 sum = (float4)(0.0f);
  for (int direction = 0; direction < RINGS * AZIMUTHS; ++direction) {
    const float sine2 = (direction / AZIMUTHS + 0.5f) / RINGS;
    const float azimuth = SKY_PI * (direction % AZIMUTHS + 0.5f) / AZIMUTHS;
    const float cosine = sqrt(1.0f - sine2);
    const float between = cosine * sun_cosine + sqrt(sine2) * sun_sine * cos(azimuth);
    const float rayleigh_phase = sky_rayleigh_phase(between);
    const float aerosol_phase = sky_aerosol_phase(aerosol_asymmetry, between);
    const RaySun sun = {sun_cosine, between};
    // A metre above the ground: on it, a level ray's length would be 0 / 0.
    Ray ray = ray_from(air, 1.0f, cosine, false);
    for (int i = 0; i < STEPS; ++i) {
      const Slice slice = next_slice(air, &ray, i, STEPS);
      const float4 once = slice.air.rayleigh_perm * rayleigh_phase + slice.air.aerosol_perm * aerosol_phase;
      const float there = sun_cosine_along(air, sun, ray.altitude, slice.distance, slice.altitude);
      sum += slice.reach *
             (once * sunlight(air, depth, slice.altitude, there) +
              (slice.air.rayleigh_perm + slice.air.aerosol_perm) *
                  scattering_lookup(scattering, air.thickness_m, slice.altitude, there));
    }
  }
  const float4 sky_light = sum * (SKY_PI / (RINGS * AZIMUTHS));
  const float4 sun_light = fmax(0.0f, sun_cosine) * sunlight(air, depth, 0.0f, sun_cosine);
  table[column] = column == 0 ? (float4)(0.0f) : sky_light + sun_light;  // the first is night
}
