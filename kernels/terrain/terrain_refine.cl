// The light of pixels that need more rays than one, as the mean over rays of their own, spread evenly over each: terrain/terrain_light.clh.
// In:  heights, maxima, field, view, light, sky, view_table, look, colours, sky_shares as of terrain/terrain_shade.cl; needs [height_px][width_px]
//      of terrain/terrain_contrast.cl; samples, rays of a pixel that needs many; with LAKES lakes, with RELIEF relief and with CANOPY a canopy as
//      terrain/terrain_shade.cl has them.
// Inout: image [height_px][width_px] (r, g, b, coverage), kcd/m2, linear Rec.709, times the coverage.
#include "terrain/endless.clh"
#include "terrain/terrain_light.clh"
#include "terrain/hit_record.clh"
#include "terrain/image_rays.clh"
#ifdef LAKES
#include "terrain/lakes/lake_light.clh"
#endif
#ifdef CANOPY
#include "terrain/canopy/crown_hits.clh"
#endif

// In [0, 1): the bits of a number mirrored at the point. In floats, because compilers make of whole numbers a bit reversal
// that Oclgrind 21.10 does not know.
INLINE float radical_inverse(int number) {
  float inverse = 0.0f, part = 0.5f;
  for (int bits = number; bits > 0; bits >>= 1) {
    inverse += (bits & 1) != 0 ? part : 0.0f;
    part *= 0.5f;
  }
  return inverse;
}

// Hits in a queue, until LANES of them are lit at once. Fewer than LANES are in it when LANES more come.
#define MOST_QUEUED (2 * LANES - 1)
typedef struct {
  int count;
  int numbers[3][MOST_QUEUED];   // of the sum that gets the light; cell_x, cell_z
  float values[9][MOST_QUEUED];  // across_px, down_px of the ray; t_m, u, v, footprint_m, way_x, way_z, raised_m
} HitQueue;

INLINE void copy_hit(HitQueue *queue, int from, int to) {
  for (int i = 0; i < 3; ++i) queue->numbers[i][to] = queue->numbers[i][from];
  for (int i = 0; i < 9; ++i) queue->values[i][to] = queue->values[i][from];
}

// Adds the hits among LANES rays through places of the picture, whose light goes to these sums.
INLINE void queue_hits(HitQueue *queue, const int *sum_of, lanes across_px, lanes down_px, TerrainHits hits) {
  const int end = queue->count;
  int is_hit[LANES];
  store_lanes(hits.is_hit, is_hit);
  for (int lane = 0; lane < LANES; ++lane) queue->numbers[0][end + lane] = sum_of[lane];
  store_lanes(hits.cell_x, queue->numbers[1] + end);
  store_lanes(hits.cell_z, queue->numbers[2] + end);
  store_lanes(across_px, queue->values[0] + end);
  store_lanes(down_px, queue->values[1] + end);
  store_lanes(hits.t_m, queue->values[2] + end);
  store_lanes(hits.u, queue->values[3] + end);
  store_lanes(hits.v, queue->values[4] + end);
  store_lanes(hits.footprint_m, queue->values[5] + end);
  store_lanes(hits.way_x, queue->values[6] + end);
  store_lanes(hits.way_z, queue->values[7] + end);
  store_lanes(hits.raised_m, queue->values[8] + end);
  for (int lane = 0; lane < LANES; ++lane) {
    if (is_hit[lane] == 0) continue;
    copy_hit(queue, end + lane, queue->count);
    ++queue->count;
  }
}

// Adds the light of LANES rays, where they see any, to their sums.
INLINE void add_light(float4 *sums, const int *sum_of, Colours seen, int_lanes is_seen) {
  float values[3][LANES];
  int seen_flags[LANES];
  store_lanes(seen.red, values[0]);
  store_lanes(seen.green, values[1]);
  store_lanes(seen.blue, values[2]);
  store_lanes(is_seen, seen_flags);
  for (int lane = 0; lane < LANES; ++lane) {
    if (seen_flags[lane] == 0) continue;
    sums[sum_of[lane]] += (float4)(values[0][lane], values[1][lane], values[2][lane], 1.0f);
  }
}

// Lights the last LANES hits of a queue, or all where there are fewer.
INLINE void light_queued(const Scenery *scenery, TerrainView view, HitQueue *queue, float4 *sums) {
  const int first = max(queue->count - LANES, 0), count = queue->count - first;
  for (int lane = count; lane < LANES; ++lane) copy_hit(queue, 0, lane);
  const Rays rays = rays_through(scenery->terrain.field, view, load_lanes(queue->values[0] + first),
                                 load_lanes(queue->values[1] + first));
  const int_lanes is_hit = mask_of(LANE_INDEX < (lanes)(float)count);
  const TerrainHits hits = {is_hit,
                            load_lanes(queue->numbers[1] + first),
                            load_lanes(queue->numbers[2] + first),
                            load_lanes(queue->values[2] + first),
                            load_lanes(queue->values[3] + first),
                            load_lanes(queue->values[4] + first),
                            load_lanes(queue->values[5] + first),
                            load_lanes(queue->values[6] + first),
                            load_lanes(queue->values[7] + first),
                            load_lanes(queue->values[8] + first)};
#ifdef LAKES
  const Colours seen = light_with_lakes(scenery, rays, hits).seen;
#else
  const Colours seen = terrain_light(scenery, rays, hits).seen;
#endif
  add_light(sums, queue->numbers[0] + first, seen, is_hit);
  queue->count = first;
}

// Sums the light of `samples` rays through each of the pixels: (r, g, b, rays that see any). All pixels have the same
// pattern of rays, so that what stands still does not flicker: the points of Hammersley, one in each of `samples` columns of a
// pixel and, where they are a power of 2, rows.
INLINE void sum_light(const Scenery *scenery, TerrainView view, int_lanes first_level, const int *pixels, int count,
                      int samples, float4 *sums) {
  const TerrainField field = scenery->terrain.field;
  const float of_pixel = 1.0f / sqrt((float)samples), part = 1.0f / (float)samples;
  HitQueue queue;
  queue.count = 0;
  for (int i = 0; i < count; ++i) sums[i] = (float4)(0.0f);
  const int ray_count = count * samples;
  for (int first = 0; first < ray_count; first += LANES) {
    int sum_of[LANES];
    float columns[LANES], rows[LANES];
    for (int lane = 0; lane < LANES; ++lane) {
      const int ray = min(first + lane, ray_count - 1), sample = ray % samples;  // lanes beyond the last repeat it
      sum_of[lane] = ray / samples;
      const int pixel = pixels[sum_of[lane]];
      columns[lane] = (float)(pixel % view.width_px) + ((float)sample + 0.5f) * part;
      rows[lane] = (float)(pixel / view.width_px) + radical_inverse(sample) + 0.5f * part;
    }
    const lanes across_px = load_lanes(columns), down_px = load_lanes(rows);
    const int_lanes is_ray = mask_of(LANE_INDEX < (lanes)(float)(ray_count - first));
    const Rays rays = rays_through(field, view, across_px, down_px);
    const lanes pixel_seen_rad = seen_rad(field, view, rays), sample_rad = of_pixel * pixel_seen_rad;
    RaySetup ray_setup = ray_setup_of(field, rays);
#ifdef RELIEF
    const Hits near = relief_hits(scenery->terrain, scenery->relief, &ray_setup);
    const Hits hits = hits_of_both(near, first_hits(scenery->terrain, first_level, &ray_setup));
#else
    const Hits hits = first_hits(scenery->terrain, first_level, &ray_setup);
#endif
    const HitPlaces places = places_of_hits(scenery->terrain, ray_setup.ray, hits);
    const int_lanes is_met = mask_of(hits.kind != TERRAIN_MISS);
    const lanes t_m = select((lanes)1.0f, hits.t_m + hits.rest_m, is_met);
    TerrainHits on_ground = {is_met, places.cell_x, places.cell_z, t_m, places.u, places.v, t_m * sample_rad,
                             (lanes)1.0f, (lanes)1.0f, (lanes)0.0f};
#if MAP_EDGE == TERRAIN_EDGE_MIRRORS
    on_ground.way_x = select((lanes)1.0f, (lanes)-1.0f, hits.flips_x);
    on_ground.way_z = select((lanes)1.0f, (lanes)-1.0f, hits.flips_z);
#endif
#ifdef CANOPY
    if (scenery->canopy.params.stands != 0) on_ground = crowns_before(scenery, rays, sample_rad, pixel_seen_rad, on_ground);
#endif
#ifdef LAKES
    on_ground.is_hit &= shown_with_lakes(scenery, rays, on_ground);
#else
    on_ground.is_hit &= shown_by_height(scenery->look, rays, on_ground);
#endif
    const int_lanes is_sea = is_ray & meets_sea_beyond(scenery, rays, on_ground.is_hit);
    if (any_lane(is_sea)) add_light(sums, sum_of, sea_beyond_light(scenery, rays, sample_rad), is_sea);
    on_ground.is_hit &= is_ray;
    queue_hits(&queue, sum_of, across_px, down_px, on_ground);
    // After the last rays a vector need not be full.
    const int enough = first + LANES < ray_count ? LANES : 1;
    while (queue.count >= enough) light_queued(scenery, view, &queue, sums);
  }
}

__kernel void terrain_refine(__global const float *restrict heights_m, __global const float *restrict maxima_m,
                             TerrainField field, TerrainView view, TerrainLight light, SkyParams sky,
                             __global const float4 *restrict view_table, TerrainLook look,
                             __global const uint *restrict colours, __global const uchar *restrict sky_shares,
                             const CloudShadowParams shadow, __global const float4 *restrict shadow_map,
                             __global const TerrainMaterial *restrict materials,
#ifdef LAKES
                             __global const LakeWater *restrict lakes, __global const uchar *restrict lake_cells,
                             __global const LakeWave *restrict lake_waves, int lake_count,
#endif
#ifdef RELIEF
                             const TerrainRelief relief_params, __global const float *restrict relief_m,
                             __global const float *restrict relief_maxima_m,
#endif
#ifdef CANOPY
                            const TerrainCanopy canopy, __global const uint *restrict canopy_map,
#endif
                             __global const uchar *restrict needs, int samples, __global float4 *restrict image) {
  const Scenery scenery = {{heights_m, maxima_m, field}, light, sky, view_table, look, colours, sky_shares, shadow, shadow_map,
                           materials
#ifdef LAKES
                           , {lakes, lake_cells, lake_count}, lake_waves
#endif
#ifdef RELIEF
                           , {relief_m, relief_maxima_m, relief_params}
#endif
#ifdef CANOPY
                           , {canopy, canopy_map}
#endif
  };
  const int left = (int)get_global_id(0) * TILE_COLUMNS, top = (int)get_global_id(1) * TILE_ROWS;
  int_lanes first_level = (int_lanes)field.first_level;
  if (field.starts_at_origin) {
    first_level = level_at_origin(scenery.terrain, (int_lanes)view.cell_x, (int_lanes)view.cell_z, (lanes)view.height_m);
  }
  for (int need = TERRAIN_FEW_RAYS; need <= TERRAIN_MANY_RAYS; ++need) {
    // The tile's pixels of this need.
    int pixels[TILE_COLUMNS * TILE_ROWS];
    int count = 0;
    for (int row = top; row < min(top + TILE_ROWS, view.height_px); ++row) {
      for (int column = left; column < min(left + TILE_COLUMNS, view.width_px); ++column) {
        pixels[count] = row * view.width_px + column;
        count += needs[pixels[count]] == need;
      }
    }
    if (count == 0) continue;
    const int rays = need == TERRAIN_MANY_RAYS ? samples : max(samples / 4, 1);
    float4 sums[TILE_COLUMNS * TILE_ROWS];
    sum_light(&scenery, view, first_level, pixels, count, rays, sums);
    for (int i = 0; i < count; ++i) image[pixels[i]] = sums[i] / (float)rays;
  }
}
