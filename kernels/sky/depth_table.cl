// Optical depth from a point to the end of the air, along rays that miss the ground. Depth and not
// transmittance, because it is nearly straight between texels: toward the horizon, transmittance interpolated
// over the rows of Bruneton's table is 3 % off, this 0.1 %.
// Out: table [SKY_DEPTH_ROWS][SKY_DEPTH_COLUMNS], four wavelengths; coordinates of sky_transmittance(). One
// work-item a texel. The midpoint rule in the root of the distance: 3 m at the beginning, where densities
// vary over 1 km, at most 18 km in the middle of the longest ray, where over 120 km: within 1e-3 of the
// integral.
#include "sky/atmosphere.clh"

#define STEPS 256

__kernel void depth_table(const AtmosphereParams air, __global float4* restrict table) {
  const int column = (int)get_global_id(0);
  const int row = (int)get_global_id(1);
  // The inverse of the coordinates.
  const float longest = sky_horizon_distance(air.ground_radius_m, air.thickness_m);
  const float horizon = longest * row / (SKY_DEPTH_ROWS - 1);
  const float radius = sqrt(horizon * horizon + air.ground_radius_m * air.ground_radius_m);
  const float altitude = fmin(air.thickness_m, horizon * horizon / (radius + air.ground_radius_m));
  const float nearest = air.thickness_m - altitude;
  const float distance = nearest + (horizon + longest - nearest) * column / (SKY_DEPTH_COLUMNS - 1);
  const float chord = nearest * (2.0f * air.ground_radius_m + air.thickness_m + altitude);
  const float cosine =
      distance > 0.0f ? clamp((chord - distance * distance) / (2.0f * radius * distance), -1.0f, 1.0f) : 1.0f;

  // Densities times the lengths of their slices, of every fourth slice.
  float4 rayleigh = (float4)(0.0f), aerosol = (float4)(0.0f), ozone = (float4)(0.0f);
  for (int i = 0; i < STEPS; i += 4) {
    const float4 share = (i + (float4)(0.5f, 1.5f, 2.5f, 3.5f)) / STEPS;
    const float4 there = altitudes_along(air, altitude, cosine, distance * share * share);
    const float4 lengths = share * (2.0f * distance / STEPS);
    rayleigh += RAYLEIGH_DENSITY(air, there) * lengths;
    aerosol += AEROSOL_DENSITY(air, there) * lengths;
    ozone += OZONE_DENSITY(air, there) * lengths;
  }
  const float4 each = (float4)(1.0f);
  const float4 depth = dot(rayleigh, each) * rayleigh_scattering(air) +
                       dot(aerosol, each) * air.aerosol_extinction_perm +
                       dot(ozone, each) * ozone_absorption(air);
  table[row * SKY_DEPTH_COLUMNS + column] = depth;
}
