// The shadow map of its moments, for clouds/cloud_shadow.clh.
// In:  moments of shadow_splat.cl.
// Out: map [CLOUD_SHADOW_SIZE][CLOUD_SHADOW_SIZE] (depth, middle, standard deviation, 0).
#include "clouds/shadow_units.clh"
#include "shared/cloud_shadow.h"

__kernel void shadow_resolve(__global const int *restrict moments, int texels_per_item, __global float4 *restrict map) {
  const int texels = CLOUD_SHADOW_SIZE * CLOUD_SHADOW_SIZE;
  const int first = (int)get_global_id(0) * texels_per_item;
  for (int i = first; i < min(first + texels_per_item, texels); ++i) {
    const float depth = (float)moments[texels + i];
    const float middle = depth > 0.0f ? (float)moments[2 * texels + i] / depth : 0.0f;
    const float square = depth > 0.0f ? (float)moments[3 * texels + i] / depth : 0.0f;
    map[i] = (float4)(depth / shadow_units(moments[i]), middle, sqrt(fmax(square - middle * middle, 0.0f)), 0.0f);
  }
}
