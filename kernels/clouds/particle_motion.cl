// Where the particles of a cloud are at a time (C4, C15), from where they are at rest: no step needs the one
// before.
// In: rest [n]: particles in the cloud's axes. Out: moved [n], from first on.
//  1. Warm air lifts them, each by its own share; below the level of condensation they have no mass.
//  2. Eddies sway them: noise of four dimensions along each axis.
//  3. Wind shear leans them, and the wind drags the thin ones ahead (C4: F = beta v); all drift.
//  4. Around a sphere they follow the streamlines of potential flow.
#include "clouds/noise_lattice.clh"
#include "shared/cloud_motion.h"
#include "shared/clouds.h"

// Octaves of the noise that density has no use for (CLOUD_OCTAVES_MOST), one an axis.
#define SWAY_OCTAVE 13u

// How far an eddy sways a place along an axis, in deviations. at: in wavelengths.
static float sway(const CloudMotionParams* params, uint axis, float3 at) {
  return noise_at(params->seed_low, params->seed_high, SWAY_OCTAVE + axis, params->sway_layer,
                  params->sway_fraction, at) /
         0.169f;
}

// Where the streamline that comes from (x far ahead, across0 from the axis) is at x, in radii of the sphere:
// Stokes' function across^2 (1 - 1 / r^3) keeps its value. The time lost in front of the sphere is left out.
static float streamline(float x, float across0) {
  float low = fmax(across0, sqrt(fmax(0.0f, 1.0f - x * x))), high = sqrt(across0 * across0 + 1.0f);
  for (int step = 0; step < 26; ++step) {  // 2^-26 of one radius: below a float's last digit
    const float middle = 0.5f * (low + high);
    const float square = middle * middle, r2 = x * x + square;
    if (square * (1.0f - 1.0f / (r2 * sqrt(r2))) < across0 * across0) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return high;
}

__kernel void particle_motion(__global const CloudParticle* restrict rest, const CloudMotionParams params,
                              const uint first, __global CloudParticle* restrict moved) {
  const size_t number = get_global_id(0);
  CloudParticle particle = rest[number];
  float3 place = (float3)(particle.x, particle.y, particle.z);

  if (params.condensing > 0.0f) {
    const PhiloxBlock block = philox_block(params.seed_low, params.seed_high, OFFING_STREAM_CLOUD_PARTICLES, 2, 0,
                                           particle.id);
    const float excess = 1.0f + params.spread * (2.0f * uniform_open01(block.v[0]) - 1.0f);
    place.y += excess * params.lift;
    const float condensed = clamp((place.y - params.condensation) / params.condensing, 0.0f, 1.0f);
    particle.optical_mass *= condensed * condensed * (3.0f - 2.0f * condensed);
  }
  if (params.sway > 0.0f) {
    const float3 at = (float3)(particle.x, particle.y, particle.z) * params.sway_per_m;
    place += params.sway * (float3)(sway(&params, 0, at), sway(&params, 1, at), sway(&params, 2, at));
  }
  const float3 along = (float3)(params.along_x, params.along_y, params.along_z);
  const float thin = 1.0f - rest[number].optical_mass / (particle.radius * particle.radius * params.densest);
  place += along * (params.lean * place.y + params.run * clamp(thin, 0.0f, 1.0f));
  place += (float3)(params.drift_x, params.drift_y, params.drift_z);

  if (params.sphere_radius > 0.0f) {
    const float3 middle = (float3)(params.sphere_x, params.sphere_y, params.sphere_z);
    const float3 from = (place - middle) / params.sphere_radius;
    const float3 flow = (float3)(params.flow_x, params.flow_y, params.flow_z);
    const float x = dot(from, flow);
    const float3 across = from - x * flow;
    const float across0 = length(across);
    // On the axis there is no direction to yield to: up.
    const float3 yield = across0 > 1e-6f ? across / across0 : (float3)(0.0f, 1.0f, 0.0f);
    place = middle + params.sphere_radius * (x * flow + streamline(x, across0) * yield);
  }

  particle.x = place.x;
  particle.y = place.y;
  particle.z = place.z;
  particle.cloud = params.cloud;
  moved[first + number] = particle;
}
