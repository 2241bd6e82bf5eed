// How long the sun shines on posts, and how much of its direct light they get, from moment to moment. Between two moments
// the sun's height above the horizon is taken as linear, so that sunrise and sunset need not be at one.
// In:    heights [rows][columns] m, field (shared/terrain.h), horizons [azimuths][rows][stride] of terrain/horizons.cl;
//        blocks, and the suns of each [blocks][suns] in order of time (shared/sun_blocks.h); blocks are block_columns wide
//        and as high as the band; the first of the band's rows.
// Out:   hours, and kWh/m^2 of inclined ground, [rows][stride].
// A work-item takes LANES columns of a row.
#include "terrain/sun_light.clh"

__kernel void sun_hours(__global const float *restrict heights_m, TerrainField field, __global const float *restrict rises, int azimuths,
                        __global const SunBlock *restrict blocks, __global const BlockSun *restrict all_suns,
                        int suns, int block_columns, int first_row, int rows, int stride, __global float *restrict hours,
                        __global float *restrict energy) {
  const int first = (int)get_global_id(0) * LANES, row = (int)get_global_id(1);
  if (first >= stride) return;
  const int block = min(first, field.cells_x) / block_columns;
  const SunPosts posts = sun_posts(heights_m, field, blocks[block], first, first_row + row);
  const size_t plane = (size_t)rows * stride, place = (size_t)row * stride + first;
  lanes horizons[AZIMUTHS];
  for (int i = 0; i < azimuths; ++i) horizons[i] = load_lanes(rises + i * plane + place);
  lanes shone = (lanes)0.0f, gained = (lanes)0.0f, above_before = (lanes)0.0f, light_before = (lanes)0.0f;
  for (int i = 0; i < suns; ++i) {
    const BlockSun sun = all_suns[(size_t)block * suns + i];
    const lanes above = sun_above(sun, posts, horizons[sun.horizon], horizons[sun.next]);
    const lanes light = sun_light(sun, posts);
    // The share of the time in which the sun is up, at the end at which it is higher.
    const lanes share = clamp(most(above, above_before) / most(fabs(above - above_before), (lanes)1e-9f), (lanes)0.0f,
                              (lanes)1.0f);
    const int_lanes rises_now = mask_of(above > above_before);
    const lanes bright = select(light_before, light, rises_now), dark = select(light, light_before, rises_now);
    shone += sun.hours * share;
    gained += sun.hours * share * most(bright + 0.5f * share * (dark - bright), (lanes)0.0f);
    above_before = above;
    light_before = light;
  }
  store_lanes(shone, hours + place);
  store_lanes(gained, energy + place);
}
