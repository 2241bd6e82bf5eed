// How many particles cover each texel of the shadow map.
// In:    particles [count]; shadow.
// Inout: moments [4][CLOUD_SHADOW_SIZE][CLOUD_SHADOW_SIZE], zero at first: the first of them counts.
#include "clouds/shadow_cover.clh"

__kernel void shadow_crowd(__global const CloudParticle *restrict particles, int count, int particles_per_item,
                           const CloudShadowParams shadow, __global int *restrict moments) {
  const int end = min(((int)get_global_id(0) + 1) * particles_per_item, count);
  for (int i = (int)get_global_id(0) * particles_per_item; i < end; ++i) {
    const CloudParticle particle = particles[i];
    ShadowCover cover;
    set_cover(&particle, &shadow, &cover);
    for (int row = cover.first_row; row <= cover.last_row; ++row) {
      for (int column = cover.first_column; column <= cover.last_column; ++column) {
        if (chord_at(&cover, column, row) > 0.0f) atomic_inc(moments + row * CLOUD_SHADOW_SIZE + column);
      }
    }
  }
}
