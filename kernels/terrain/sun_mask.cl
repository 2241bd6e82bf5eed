// Where the sun shines at a moment.
// In:  heights, field, horizons, blocks and suns as terrain/sun_hours.cl has them; which of the suns.
// Out: lit [rows][stride], 255 where the sun's edge is above the horizon, else 0.
// A work-item takes LANES columns of a row.
#include "terrain/sun_light.clh"

__kernel void sun_mask(__global const float *restrict heights_m, TerrainField field, __global const float *restrict rises,
                       __global const SunBlock *restrict blocks, __global const BlockSun *restrict all_suns,
                       int suns, int which, int block_columns, int first_row, int rows, int stride,
                       __global uchar *restrict lit) {
  const int first = (int)get_global_id(0) * LANES, row = (int)get_global_id(1);
  if (first >= stride) return;
  const int block = min(first, field.cells_x) / block_columns;
  const SunPosts posts = sun_posts(heights_m, field, blocks[block], first, first_row + row);
  const BlockSun sun = all_suns[(size_t)block * suns + which];
  const size_t plane = (size_t)rows * stride, place = (size_t)row * stride + first;
  const lanes above = sun_above(sun, posts, load_lanes(rises + sun.horizon * plane + place),
                                load_lanes(rises + sun.next * plane + place));
  float values[LANES];
  store_lanes(above, values);
  for (int lane = 0; lane < LANES; ++lane) lit[place + lane] = values[lane] > 0.0f ? 255 : 0;
}
