// What a camera's rays hit first: Park, Oh & Cho 2007, section 3 (T3, T9 of docs/sources.md).
// In:  heights [rows][columns] m, maxima of terrain/pyramid_base.cl and pyramid_reduce.cl, or with TILED the pool and pages
//      of shared/terrain_tiles.h; field, view (shared/terrain.h).
//      With RELIEF (not with endless maps), relief, relief_m and relief_maxima_m of terrain/relief.clh.
// Out: records [height_px][width_px], row 0 at the top: distances in metres along the unit ray, +inf for misses; with
//      WRITES_HITS, TerrainHit.
#include "terrain/endless.clh"
#include "terrain/hit_record.clh"
#include "terrain/image_rays.clh"
#include "terrain/traversal.clh"

// By the default rule, the simd shape casts pixels whose rays go the same way as packets; not over tiles, whose leaves
// differ in size.
#if LANES > 1 && UP_RULE == TERRAIN_UP_WITH_PARENT && !defined(TILED)
#include "terrain/packet.clh"
#define CAST_COLUMNS PACKET_COLUMNS
#define CAST_ROWS PACKET_ROWS
#else
#define CAST_COLUMNS BLOCK_COLUMNS
#define CAST_ROWS BLOCK_ROWS
#endif
#ifdef RELIEF
#include "terrain/relief.clh"
#endif
#define CAST_BLOCKS (CAST_COLUMNS * CAST_ROWS / LANES)
#define BLOCKS_A_ROW (CAST_COLUMNS / BLOCK_COLUMNS)

__kernel void quadtree_cast(__global const float *restrict heights_m, __global const float *restrict maxima_m,
                            TerrainField field, TerrainView view, __global HitRecord *restrict records
#ifdef RELIEF
                            , const TerrainRelief relief_params, __global const float *restrict relief_m,
                            __global const float *restrict relief_maxima_m
#endif
) {
  const Terrain terrain = {heights_m, maxima_m, field};
#ifdef RELIEF
  const Relief relief = {relief_m, relief_maxima_m, relief_params};
#endif
  int_lanes first_level = (int_lanes)field.first_level;
  if (field.starts_at_origin) {
    first_level = level_at_origin(terrain, (int_lanes)view.cell_x, (int_lanes)view.cell_z, (lanes)view.height_m);
  }
#ifdef PACKET_RAYS
  // From above all maxima, or from beside the map, everything is ahead.
  const bool is_within = view.height_m <= field.highest_m && view.cell_x >= 0 && view.cell_x < field.cells_x &&
                         view.cell_z >= 0 && view.cell_z < field.cells_z;
  int first_levels[LANES];
  store_lanes(first_level, first_levels);
  const int home_level = is_within ? min(first_levels[0], root_level(field)) : root_level(field);
#endif
  const int left = (int)get_global_id(0) * TILE_COLUMNS, top = (int)get_global_id(1) * TILE_ROWS;
  for (int row = top; row < min(top + TILE_ROWS, view.height_px); row += CAST_ROWS) {
    for (int column = left; column < min(left + TILE_COLUMNS, view.width_px); column += CAST_COLUMNS) {
      RaySetup ray_setups[CAST_BLOCKS];
      Hits hits[CAST_BLOCKS];
      for (int i = 0; i < CAST_BLOCKS; ++i) {
        const int x = column + i % BLOCKS_A_ROW * BLOCK_COLUMNS, y = row + i / BLOCKS_A_ROW * BLOCK_ROWS;
        ray_setups[i] = ray_setup_of(field, rays_of(field, view, x + (int_lanes)lane_column, y + (int_lanes)lane_row));
        hits[i] = no_hits();
      }
#ifdef RELIEF
      Hits near[CAST_BLOCKS];
#ifdef PACKET_RAYS
      relief_hits_of_packet(terrain, relief, view, ray_setups, near);
#else
      for (int i = 0; i < CAST_BLOCKS; ++i) near[i] = relief_hits(terrain, relief, &ray_setups[i]);
#endif
#endif
      bool is_cast = false;
#ifdef PACKET_RAYS
      const Frustum frustum = frustum_of(ray_setups);
      is_cast = frustum.is_empty || frustum.is_one_way;
      if (is_cast && !frustum.is_empty) {
        packet_walk(terrain, view, ray_setups, frustum, home_level, hits);
      }
#endif
      for (int i = 0; i < CAST_BLOCKS; ++i) {
        if (!is_cast) hits[i] = first_hits(terrain, first_level, &ray_setups[i]);
#ifdef RELIEF
        hits[i] = hits_of_both(near[i], hits[i]);
#endif
        HitRecord block[LANES];
        record_hits(terrain, ray_setups[i].ray, hits[i], block);
        const int x = column + i % BLOCKS_A_ROW * BLOCK_COLUMNS, y = row + i / BLOCKS_A_ROW * BLOCK_ROWS;
        for (int down = 0; down < min(BLOCK_ROWS, view.height_px - y); ++down) {
          for (int across = 0; across < min(BLOCK_COLUMNS, view.width_px - x); ++across) {
            records[(size_t)(y + down) * view.width_px + x + across] = block[down * BLOCK_COLUMNS + across];
          }
        }
      }
    }
  }
}
