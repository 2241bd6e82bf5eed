// Keys by which particles are sorted along light or view.
// In:  particles [count]. From (x, y, z) with nearness 1: distance from that place, squared. With nearness 0: the way
//      along -(x, y, z), so that what is nearest to a far light in that direction comes first. `flip` 0 sorts from near
//      to far, ~0 from far to near.
// Out: keys, values [count]; values are the particles' own places. What is not a number counts as farthest.
#include "shared/clouds.h"

// Unsigned integers in the order of floats; -0 is 0, said so that no compiler takes it for nothing.
static inline uint ordered_bits(float value) {
  const uint bits = value == 0.0f ? 0u : as_uint(value);
  return isnan(value) ? 0xffffffffu : bits ^ ((bits & 0x80000000u) != 0u ? 0xffffffffu : 0x80000000u);
}

__kernel void order_key(__global const CloudParticle *restrict particles, int count, int particles_per_item, float x,
                        float y, float z, int nearness, uint flip, __global uint *restrict keys,
                        __global uint *restrict values) {
  const int first = (int)get_global_id(0) * particles_per_item;
  const int end = min(first + particles_per_item, count);
  for (int i = first; i < end; ++i) {
    const float px = particles[i].x, py = particles[i].y, pz = particles[i].z;
    const float dx = px - x, dy = py - y, dz = pz - z;
    const float far = nearness != 0 ? dx * dx + dy * dy + dz * dz : -(px * x + py * y + pz * z);
    keys[i] = ordered_bits(far) ^ flip;
    values[i] = (uint)i;
  }
}
