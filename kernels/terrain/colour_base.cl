// The finest level of a colour map.
// In:  srgb [rows][columns], bytes red, green, blue, coverage (IEC 61966-2-1).
// Out: colours [rows][columns] of terrain/colour_texel.clh.
#define LANES 1
#include "terrain/colour_texel.clh"

INLINE float linear_of(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : pow((srgb + 0.055f) / 1.055f, 2.4f);
}

__kernel void colour_base(__global const uchar4 *restrict srgb, __global uint *restrict colours) {
  const size_t i = get_global_id(0);
  const float4 texel = convert_float4(srgb[i]) * (1.0f / 255.0f);
  colours[i] = packed_texel(linear_of(texel.x), linear_of(texel.y), linear_of(texel.z), texel.w);
}
