// How many rays pixels need: by how much their light differs from that of a pixel beside, above or below them, as a share
// of the brighter one's luminance. Edges, and detail finer than pixels, differ so.
// In:  image [height_px][width_px] (r, g, b, coverage) of terrain/terrain_shade.cl; least_contrast.
// Out: needs [height_px][width_px] of shared/terrain_light_params.h: many where coverage changes or the contrast is
//      TERRAIN_MANY_CONTRASTS times the least or more, few where it is more than the least.
#include "shared/terrain_light_params.h"

__kernel void terrain_contrast(__global const float4 *restrict edges, int width_px, int height_px, float least_contrast,
                               __global uchar *restrict needs) {
  const int x = (int)get_global_id(0), y = (int)get_global_id(1);
  const int row = y * width_px;
  const float4 here = edges[row + x];
  const int beside[4] = {row + max(x - 1, 0), row + min(x + 1, width_px - 1), max(y - 1, 0) * width_px + x,
                         min(y + 1, height_px - 1) * width_px + x};
  const float4 luminance = (float4)(0.2126f, 0.7152f, 0.0722f, 0.0f);
  uchar need = TERRAIN_ONE_RAY;
  for (int i = 0; i < 4; ++i) {
    const float4 there = edges[beside[i]];
    const float4 difference = fabs(here - there);
    const float most = max(difference.x, max(difference.y, difference.z));
    const float least = least_contrast * max(dot(here, luminance), dot(there, luminance));
    if (most > least) need = max(need, (uchar)TERRAIN_FEW_RAYS);
    if (most > TERRAIN_MANY_CONTRASTS * least || difference.w > 0.0f) need = TERRAIN_MANY_RAYS;
  }
  needs[row + x] = need;
}
