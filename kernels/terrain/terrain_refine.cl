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

// The light of LANES pixels, (r, g, b, coverage). All pixels have the same pattern of rays, so that what stands still does
// not flicker: the points of Hammersley, one in each of `samples` columns of a pixel and, where they are a power of 2, rows.
INLINE void mean_light(const Scenery *scenery, TerrainView view, int_lanes first_level, lanes column, lanes row,
                           int samples, float4 *lights) {
  const TerrainField field = scenery->terrain.field;
  const float of_pixel = 1.0f / sqrt((float)samples);
  Colours sum = plain_colour(0.0f, 0.0f, 0.0f);
  lanes covered = (lanes)0.0f;
  for (int i = 0; i < samples; ++i) {
    const Rays rays = rays_through(field, view, column + ((float)i + 0.5f) / (float)samples,
                                   row + radical_inverse(i) + 0.5f / (float)samples);
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
                         (lanes)1.0f, (lanes)1.0f};
#if MAP_EDGE == TERRAIN_EDGE_MIRRORS
    on_ground.way_x = select((lanes)1.0f, (lanes)-1.0f, hits.flips_x);
    on_ground.way_z = select((lanes)1.0f, (lanes)-1.0f, hits.flips_z);
#endif
#ifdef CANOPY
    if (scenery->canopy.params.stands != 0) on_ground = crowns_before(scenery, rays, sample_rad, pixel_seen_rad, on_ground);
#endif
#ifdef LAKES
    on_ground.is_hit &= shown_with_lakes(scenery, rays, on_ground);
    Colours seen = light_with_lakes(scenery, rays, on_ground).seen;
#else
    on_ground.is_hit &= shown_by_height(scenery->look, rays, on_ground);
    Colours seen = terrain_light(scenery, rays, on_ground).seen;
#endif
    const int_lanes is_sea = meets_sea_beyond(scenery, rays, on_ground.is_hit);
    if (any_lane(is_sea)) {
      seen = blend(seen, sea_beyond_light(scenery, rays, sample_rad), select((lanes)0.0f, (lanes)1.0f, is_sea));
    }
    sum.red += seen.red;
    sum.green += seen.green;
    sum.blue += seen.blue;
    covered += select((lanes)0.0f, (lanes)1.0f, on_ground.is_hit | is_sea);
  }
  float values[4][LANES];
  store_lanes(sum.red, values[0]);
  store_lanes(sum.green, values[1]);
  store_lanes(sum.blue, values[2]);
  store_lanes(covered, values[3]);
  for (int lane = 0; lane < LANES; ++lane) {
    lights[lane] = (float4)(values[0][lane], values[1][lane], values[2][lane], values[3][lane]) / (float)samples;
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
    // The tile's pixels of this need, LANES at a time.
    int places[TILE_COLUMNS * TILE_ROWS];
    int count = 0;
    for (int row = top; row < min(top + TILE_ROWS, view.height_px); ++row) {
      for (int column = left; column < min(left + TILE_COLUMNS, view.width_px); ++column) {
        places[count] = row * view.width_px + column;
        count += needs[places[count]] == need;
      }
    }
    const int rays = need == TERRAIN_MANY_RAYS ? samples : max(samples / 4, 1);
    for (int first = 0; first < count; first += LANES) {
      float columns[LANES], rows[LANES];
      for (int lane = 0; lane < LANES; ++lane) {
        const int place = places[min(first + lane, count - 1)];  // lanes beyond the last repeat it
        columns[lane] = (float)(place % view.width_px);
        rows[lane] = (float)(place / view.width_px);
      }
      float4 lights[LANES];
      mean_light(&scenery, view, first_level, load_lanes(columns), load_lanes(rows), rays, lights);
      for (int lane = 0; lane < min(LANES, count - first); ++lane) image[places[first + lane]] = lights[lane];
    }
  }
}
