// The light that a camera sees of the ground its rays hit, one ray a pixel: terrain/terrain_light.clh.
// In:  heights [rows][columns] m, maxima of terrain/pyramid_base.cl and pyramid_reduce.cl, or with TILED the pool and pages
//      of shared/terrain_tiles.h; field, view (shared/terrain.h); hits [height_px][width_px] of
//      terrain/quadtree_cast.cl for the same view; light; sky and view_table of sky/view_table.cl for the same eye;
//      look (shared/terrain_look.h), colours of terrain/colour_base.cl and colour_reduce.cl, sky_shares of
//      terrain/open_sky.cl, materials (shared/terrain_materials.h): of none of these, anything. With LAKES count lakes of shared/lakes.h, their cells and waves. With
//      RELIEF, relief, relief_m and relief_maxima_m of terrain/relief.clh. With CANOPY a canopy of
//      shared/terrain_canopy.h and its map, as colours: where it has none, anything.
// Inout: hits; with CANOPY, those behind crowns become hits of the crowns.
// Out: image [height_px][width_px] (r, g, b, coverage), kcd/m2, linear Rec.709; (0, 0, 0, 0) where rays miss,
//      or what they hit is under water that is drawn over it; plain light where mirrored rays start inside the ground;
//      edges, by which pixels are chosen that need more rays, the same.
#include "terrain/terrain_light.clh"
#include "terrain/image_rays.clh"
#ifdef LAKES
#include "terrain/lakes/lake_light.clh"
#endif
#ifdef CANOPY
#include "terrain/canopy/crown_hits.clh"

// Writes the hits of a block that are of crowns.
INLINE void write_crowns(TerrainHits terrain, TerrainView view, int column, int row, __global TerrainHit *hits) {
  float places[4][LANES];
  int cells[2][LANES];
  store_lanes(terrain.raised_m, places[0]);
  store_lanes(terrain.t_m, places[1]);
  store_lanes(terrain.u, places[2]);
  store_lanes(terrain.v, places[3]);
  store_lanes(terrain.cell_x, cells[0]);
  store_lanes(terrain.cell_z, cells[1]);
  for (int lane = 0; lane < LANES; ++lane) {
    const int x = column + lane % BLOCK_COLUMNS, y = row + lane / BLOCK_COLUMNS;
    if (!(places[0][lane] > 0.0f) || x >= view.width_px || y >= view.height_px) continue;
    __global TerrainHit *hit = hits + (size_t)y * view.width_px + x;
    const TerrainHit crown = {places[1][lane], TERRAIN_SURFACE, cells[0][lane], cells[1][lane], places[2][lane],
                              places[3][lane], 0.0f,            1.0f,           0.0f,           hit->steps};
    *hit = crown;
  }
}
#endif

// Whether a mirrored ray starts inside the ground, as do those up to so many pixels away, looked at in steps. The water shows
// such pixels in means over many alone, so that they get one plain light.
#define HIDING_MARGIN_PX 16
#define HIDING_STEP_PX 4

// Rays of the camera itself that start inside the ground have distance 0. Where woods have crowns, whose hits are written here,
// there are no mirrored ones.
INLINE bool hides_mirror(__global const TerrainHit *hits, TerrainView view, int x, int y) {
  const TerrainHit hit = hits[(size_t)y * view.width_px + x];
  if (hit.kind != TERRAIN_INSIDE || hit.distance_m == 0.0f) return false;
  for (int away = HIDING_STEP_PX; away <= HIDING_MARGIN_PX; away += HIDING_STEP_PX) {
    for (int side = 0; side < 9; ++side) {
      const int column = clamp(x + away * (side % 3 - 1), 0, view.width_px - 1);
      const int row = clamp(y + away * (side / 3 - 1), 0, view.height_px - 1);
      if (hits[(size_t)row * view.width_px + column].kind != TERRAIN_INSIDE) return false;
    }
  }
  return true;
}

INLINE TerrainHits terrain_hits(__global const TerrainHit *hits, TerrainView view, lanes ray_rad, int column, int row,
                                bool *is_hiding) {
  int numbers[3][LANES];
  float places[3][LANES];
  for (int lane = 0; lane < LANES; ++lane) {
    // Lanes beyond the picture's edge repeat its last pixels.
    const int x = min(column + lane % BLOCK_COLUMNS, view.width_px - 1), y = min(row + lane / BLOCK_COLUMNS, view.height_px - 1);
    const TerrainHit hit = hits[(size_t)y * view.width_px + x];
    is_hiding[lane] = hides_mirror(hits, view, x, y);
    numbers[0][lane] = hit.kind == TERRAIN_MISS || is_hiding[lane] ? 0 : -1;
    numbers[1][lane] = hit.cell_x;
    numbers[2][lane] = hit.cell_z;
    places[0][lane] = hit.kind == TERRAIN_MISS ? 1.0f : hit.distance_m;
    places[1][lane] = hit.u;
    places[2][lane] = hit.v;
  }
  const lanes t_m = load_lanes(places[0]);
  const TerrainHits terrain = {load_lanes(numbers[0]), load_lanes(numbers[1]), load_lanes(numbers[2]), t_m,
                             load_lanes(places[1]),  load_lanes(places[2]),  t_m * ray_rad, (lanes)1.0f, (lanes)1.0f};
  return terrain;
}

#if MAP_EDGE == TERRAIN_EDGE_MIRRORS
// Of places so far from the eye on one axis, in cells: -1 in copies of the map that go back.
INLINE lanes turned(int cell, float fraction, lanes way, int cells) {
  const lanes copy = floor(((float)cell + fraction + way) / (float)cells);
  return 1.0f - 2.0f * (copy - 2.0f * floor(0.5f * copy));
}
#endif

__kernel void terrain_shade(__global const float *restrict heights_m, __global const float *restrict maxima_m,
                            TerrainField field, TerrainView view, __global TerrainHit *restrict hits,
                            TerrainLight light, SkyParams sky, __global const float4 *restrict view_table,
                            TerrainLook look, __global const uint *restrict colours, __global const uchar *restrict sky_shares,
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
                            __global float4 *restrict image, __global float4 *restrict edges) {
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
  const float4 of_open_ground = light_of_open_ground(light, sky);
  const int left = (int)get_global_id(0) * TILE_COLUMNS, top = (int)get_global_id(1) * TILE_ROWS;
  for (int row = top; row < min(top + TILE_ROWS, view.height_px); row += BLOCK_ROWS) {
    for (int column = left; column < min(left + TILE_COLUMNS, view.width_px); column += BLOCK_COLUMNS) {
      const Rays rays = rays_of(field, view, column + (int_lanes)lane_column, row + (int_lanes)lane_row);
      const lanes ray_rad = seen_rad(field, view, rays);
      bool is_hiding[LANES];
      TerrainHits terrain = terrain_hits(hits, view, ray_rad, column, row, is_hiding);
#ifdef CANOPY
      if (canopy.stands != 0) {
        terrain = crowns_before(&scenery, rays, ray_rad, ray_rad, terrain);
        write_crowns(terrain, view, column, row, hits);
      }
#endif
#ifdef LAKES
      terrain.is_hit &= shown_with_lakes(&scenery, rays, terrain);
#else
      terrain.is_hit &= shown_by_height(look, rays, terrain);
#endif
#if MAP_EDGE == TERRAIN_EDGE_MIRRORS
      terrain.way_x = turned(view.cell_x, view.fraction_x, terrain.t_m * rays.along_x, field.cells_x);
      terrain.way_z = turned(view.cell_z, view.fraction_z, terrain.t_m * rays.along_z, field.cells_z);
#endif
#ifdef LAKES
      const TerrainColours colours_there = light_with_lakes(&scenery, rays, terrain);
#else
      const TerrainColours colours_there = terrain_light(&scenery, rays, terrain);
#endif
      const int_lanes is_sea = meets_sea_beyond(&scenery, rays, terrain.is_hit);
      Colours seen = colours_there.seen, edge_light = colours_there.edges;
      if (any_lane(is_sea)) {
        const Colours sea = sea_beyond_light(&scenery, rays, ray_rad);
        const lanes share = select((lanes)0.0f, (lanes)1.0f, is_sea);
        seen = blend(seen, sea, share);
        edge_light = blend(edge_light, sea, share);
      }
      float values[7][LANES];
      store_lanes(seen.red, values[0]);
      store_lanes(seen.green, values[1]);
      store_lanes(seen.blue, values[2]);
      store_lanes(select((lanes)0.0f, (lanes)1.0f, terrain.is_hit | is_sea), values[3]);
      store_lanes(edge_light.red, values[4]);
      store_lanes(edge_light.green, values[5]);
      store_lanes(edge_light.blue, values[6]);
      for (int lane = 0; lane < LANES; ++lane) {
        const int x = column + lane % BLOCK_COLUMNS, y = row + lane / BLOCK_COLUMNS;
        if (x >= view.width_px || y >= view.height_px) continue;
        const size_t pixel = (size_t)y * view.width_px + x;
        if (is_hiding[lane]) {
          image[pixel] = edges[pixel] = of_open_ground;
          continue;
        }
        image[pixel] = (float4)(values[0][lane], values[1][lane], values[2][lane], values[3][lane]);
        edges[pixel] = (float4)(values[4][lane], values[5][lane], values[6][lane], values[3][lane]);
      }
    }
  }
}
