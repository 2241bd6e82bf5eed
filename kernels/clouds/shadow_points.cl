// Share of light that reaches places along a direction through all particles: exact chords, no map.
// In:  places [places_count][3] m, particles [count]; (x, y, z) the unit way toward the light.
// Out: shares [places_count], exp(-optical depth).
#include "clouds/chord.clh"
#include "shared/clouds.h"

__kernel void shadow_points(__global const float *restrict places, int place_count, int places_per_item,
                            __global const CloudParticle *restrict particles, int count, float x, float y, float z,
                            __global float *restrict shares) {
  const int first = (int)get_global_id(0) * places_per_item;
  for (int p = first; p < min(first + places_per_item, place_count); ++p) {
    const float px = places[3 * p], py = places[3 * p + 1], pz = places[3 * p + 2];
    float depth = 0.0f;
    for (int i = 0; i < count; ++i) {
      const float radius = particles[i].radius;
      const float dx = (particles[i].x - px) / radius, dy = (particles[i].y - py) / radius,
                  dz = (particles[i].z - pz) / radius;
      const float along = dx * x + dy * y + dz * z;
      const float ax = dx - along * x, ay = dy - along * y, az = dz - along * z;
      const float beside2 = ax * ax + ay * ay + az * az;
      if (!(beside2 < 1.0f)) continue;
      // From the place on, if it lies inside the ball.
      const float half_way = sqrt(1.0f - beside2), before = clamp(along, -half_way, half_way);
      const float chord = cloud_half_chord(beside2, half_way) + cloud_half_chord(beside2, before);
      depth += cloud_depth(particles[i].optical_mass, radius) * chord;
    }
    shares[p] = exp(-depth);
  }
}
