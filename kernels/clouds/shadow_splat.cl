// Adds the optical depth of each particle to the texels of the shadow map that it covers, and its first two moments along
// the light. Sums are of integers, so that their order does not matter.
// In:    particles [count]; shadow.
// Inout: moments [3][CLOUD_SHADOW_SIZE][CLOUD_SHADOW_SIZE], units of 1 / SHADOW_UNITS, zero at first: depth, depth times
//        way, depth times way squared, way in half widths.
#include "clouds/chord.clh"
#include "clouds/shadow_units.clh"
#include "shared/cloud_shadow.h"
#include "shared/clouds.h"

__kernel void shadow_splat(__global const CloudParticle *restrict particles, int count, int particles_per_item,
                           const CloudShadowParams shadow, __global int *restrict moments) {
  const float texel = 2.0f * shadow.half_width / (float)CLOUD_SHADOW_SIZE;
  const int texels = CLOUD_SHADOW_SIZE * CLOUD_SHADOW_SIZE;
  const int end = min(((int)get_global_id(0) + 1) * particles_per_item, count);
  for (int i = (int)get_global_id(0) * particles_per_item; i < end; ++i) {
    const CloudParticle particle = particles[i];
    const float x = particle.x - shadow.middle_x, y = particle.y - shadow.middle_y, z = particle.z - shadow.middle_z;
    const float at_x = (x * shadow.right_x + y * shadow.right_y + z * shadow.right_z + shadow.half_width) / texel;
    const float at_y = (x * shadow.up_x + y * shadow.up_y + z * shadow.up_z + shadow.half_width) / texel;
    const float way = (x * shadow.sun_x + y * shadow.sun_y + z * shadow.sun_z) / shadow.half_width;
    // A ball smaller than a texel is drawn as large as one.
    const float radius = fmax(particle.radius / texel, 1.0f);
    if (!(at_x + radius > 0.0f && at_y + radius > 0.0f && at_x - radius < (float)CLOUD_SHADOW_SIZE &&
          at_y - radius < (float)CLOUD_SHADOW_SIZE && fabs(way) < MOST_WAY && isfinite(particle.optical_mass)))
      continue;
    const float spread = 0.1041f * particle.radius * particle.radius / (shadow.half_width * shadow.half_width);
    const float depth = particle.optical_mass / (CLOUD_BALL_MASS * radius * radius * texel * texel);
    for (int row = max((int)(at_y - radius), 0); row <= min((int)(at_y + radius), CLOUD_SHADOW_SIZE - 1); ++row) {
      for (int column = max((int)(at_x - radius), 0); column <= min((int)(at_x + radius), CLOUD_SHADOW_SIZE - 1);
           ++column) {
        const float dx = ((float)column + 0.5f - at_x) / radius, dy = ((float)row + 0.5f - at_y) / radius;
        const float chord = cloud_chord(dx * dx + dy * dy);
        if (chord <= 0.0f) continue;
        const float here = fmin(depth * chord, MOST_DEPTH) * SHADOW_UNITS;
        __global int *sums = moments + row * CLOUD_SHADOW_SIZE + column;
        atomic_add(sums, (int)here);
        atomic_add(sums + texels, (int)(here * way));
        atomic_add(sums + 2 * texels, (int)(here * (way * way + spread)));
      }
    }
  }
}
