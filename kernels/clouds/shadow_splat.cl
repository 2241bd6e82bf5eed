// Adds the optical depth of each particle to the texels of the shadow map that it covers, and its first two moments along
// the light. Sums are of integers, so that their order does not matter.
// In:    particles [count]; shadow.
// Inout: moments [4][CLOUD_SHADOW_SIZE][CLOUD_SHADOW_SIZE]: counts of shadow_crowd.cl, then, zero at first, in their
//        shadow_units(): depth, depth times way, depth times way squared, way in half widths.
#include "clouds/shadow_cover.clh"
#include "clouds/shadow_units.clh"

__kernel void shadow_splat(__global const CloudParticle *restrict particles, int count, int particles_per_item,
                           const CloudShadowParams shadow, __global int *restrict moments) {
  const int texels = CLOUD_SHADOW_SIZE * CLOUD_SHADOW_SIZE;
  const int end = min(((int)get_global_id(0) + 1) * particles_per_item, count);
  for (int i = (int)get_global_id(0) * particles_per_item; i < end; ++i) {
    const CloudParticle particle = particles[i];
    ShadowCover cover;
    set_cover(&particle, &shadow, &cover);
    const float square = fmin(cover.way * cover.way + cover.spread, 17.0f);
    for (int row = cover.first_row; row <= cover.last_row; ++row) {
      for (int column = cover.first_column; column <= cover.last_column; ++column) {
        const float chord = chord_at(&cover, column, row);
        if (chord <= 0.0f) continue;
        __global int *sums = moments + row * CLOUD_SHADOW_SIZE + column;
        const float here = fmin(cover.depth * chord, MOST_DEPTH) * shadow_units(sums[0]);
        atomic_add(sums + texels, convert_int_rte(here));
        atomic_add(sums + 2 * texels, convert_int_rte(here * cover.way));
        atomic_add(sums + 3 * texels, convert_int_rte(here * square));
      }
    }
  }
}
