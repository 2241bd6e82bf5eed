// The light that a camera sees of the ground its rays hit (T10 of docs/sources.md): diffuse cover in the light of the sun
// and the sky, the sun's disc cut by the horizon that a second walk finds, and the air between the ground and the eye.
// In:  heights [rows][columns] m, lids of terrain/pyramid_base.cl and pyramid_reduce.cl, or with TILED the pool and pages
//      of shared/terrain_tiles.h; field, view (shared/terrain.h); hits [height_px][width_px] of terrain/quadtree_cast.cl for the same view; light; sky and view_table of
//      sky/view_table.cl for the same eye.
// Out: image [height_px][width_px] (r, g, b, coverage), kcd/m2, linear Rec.709; (0, 0, 0, 0) where rays miss.
#define WALKS_CONE
#include "sky/clear_sky.clh"
#include "terrain/ground_cover.clh"
#include "terrain/ground_height.clh"
#include "terrain/mean_slope.clh"
#include "terrain/picture_rays.clh"
#include "terrain/traversal.clh"

// Shadows start so far above the ground, in the smaller side of a cell: rounding of places is 1e-6 of it, and creases
// between patches cast none.
#define SHADOW_LIFT 0.02f
// A sun overhead has no upright fan: beyond this the fan is too narrow, where shadows are shortest.
#define LEAST_SUN_LEVEL 0.1f

typedef struct {
  int_lanes is_hit, cell_x, cell_z;
  lanes t_m, u, v;
} GroundHits;

FFT_INLINE GroundHits ground_hits(__global const TerrainHit *hits, TerrainView view, int column, int row) {
  int numbers[3][LANES];
  float places[3][LANES];
  for (int lane = 0; lane < LANES; ++lane) {
    // Lanes beyond the picture's edge repeat its last pixels.
    const int x = min(column + lane % BLOCK_COLUMNS, view.width_px - 1), y = min(row + lane / BLOCK_COLUMNS, view.height_px - 1);
    const TerrainHit hit = hits[(size_t)y * view.width_px + x];
    numbers[0][lane] = hit.kind == TERRAIN_MISS ? 0 : -1;
    numbers[1][lane] = hit.cell_x;
    numbers[2][lane] = hit.cell_z;
    places[0][lane] = hit.kind == TERRAIN_MISS ? 1.0f : hit.distance_m;
    places[1][lane] = hit.u;
    places[2][lane] = hit.v;
  }
  const GroundHits ground = {load_lanes(numbers[0]), load_lanes(numbers[1]), load_lanes(numbers[2]),
                             load_lanes(places[0]),  load_lanes(places[1]),  load_lanes(places[2])};
  return ground;
}

// Share of the sun's disc that ground sees at places whose height is given.
FFT_INLINE lanes sun_share(__global const float *heights_m, __global const float *lids_m, TerrainField field, SkyParams sky,
                           GroundHits ground, lanes height_m, int_lanes is_wanted) {
  if (!any_lane(is_wanted)) return (lanes)0.0f;
  const float level = sqrt(max(1.0f - sky.sun_direction_y * sky.sun_direction_y, 0.0f));
  const float half_spread = sin(sky.sun_angular_radius_rad) / max(level, LEAST_SUN_LEVEL);
  const float lift_m = SHADOW_LIFT / max(field.cells_per_m_x, field.cells_per_m_z);
  const Rays rays = {ground.cell_x,
                     ground.cell_z,
                     ground.u,
                     ground.v,
                     height_m + lift_m,
                     (lanes)0.0f,
                     (lanes)(sky.sun_direction_x * field.cells_per_m_x),
                     (lanes)(sky.sun_direction_z * field.cells_per_m_z),
                     (lanes)0.0f,
                     (lanes)0.0f,
                     (lanes)(sky.sun_direction_y - half_spread),
                     select((lanes)-1.0f, (lanes)FARTHEST_M, is_wanted)};
  const int_lanes first_level = level_at_origin(heights_m, lids_m, field, ground.cell_x, ground.cell_z, rays.height_m);
  Course course = course_of(field, rays);
  course.spread = (lanes)(2.0f * half_spread);
  const Hits fans = walk(heights_m, lids_m, field, course, level_at_start(field, course, first_level));
  // The disc's area above a level line, as a cubic: 3 % off at most.
  return smoothstep((lanes)0.0f, (lanes)1.0f, fans.open_share);
}

// Air between two heights at this distance, as metres of the air at sea level; it thins by e every scale height.
FFT_INLINE lanes air_between(lanes distance_m, float from_m, lanes to_m, float scale_height_m) {
  const lanes climb = (to_m - from_m) / scale_height_m;
  const lanes mean = select((1.0f - exp(-climb)) / climb, 1.0f - 0.5f * climb, mask_of(fabs(climb) < 1e-3f));
  return distance_m * exp(-from_m / scale_height_m) * mean;
}

__kernel void terrain_shade(__global const float *restrict heights_m, __global const float *restrict lids_m,
                            TerrainField field, TerrainView view, __global const TerrainHit *restrict hits,
                            TerrainLight light, SkyParams sky, __global const float4 *restrict view_table,
                            __global float4 *restrict image) {
  const float eye_m = view.height_m + view.height_rest_m;
  const float pixel_rad = 2.0f * sqrt(view.up_x * view.up_x + view.up_y * view.up_y + view.up_z * view.up_z) / view.height_px;
  const float side_m = 1.0f / max(field.cells_per_m_x, field.cells_per_m_z);
  const int left = (int)get_global_id(0) * TILE_COLUMNS, top = (int)get_global_id(1) * TILE_ROWS;
  for (int row = top; row < min(top + TILE_ROWS, view.height_px); row += BLOCK_ROWS) {
    for (int column = left; column < min(left + TILE_COLUMNS, view.width_px); column += BLOCK_COLUMNS) {
      const Rays rays = rays_of(field, view, column + (int_lanes)lane_column, row + (int_lanes)lane_row);
      const GroundHits ground = ground_hits(hits, view, column, row);
      const lanes height_m =
          ground_height(heights_m, lids_m, field, ground.cell_x, ground.cell_z, ground.u, ground.v, ground.is_hit);

      // Slopes as coarse as the pixel, between the two strides next to it.
      const lanes footprint_m = ground.t_m * pixel_rad;
#ifdef TILED
      // Tiles are as coarse as that themselves.
      const Slopes slopes =
          slopes_in_tiles(heights_m, lids_m, field, ground.cell_x, ground.cell_z, ground.u, ground.v, ground.is_hit);
      const lanes slope_x = slopes.x, slope_z = slopes.z;
#else
      const lanes detail = clamp(log2(fmax(footprint_m / side_m, (lanes)1.0f)), (lanes)0.0f, (lanes)12.0f);
      const int_lanes level = convert_int_lanes(detail);
      const Slopes near = mean_slopes(heights_m, field, ground.cell_x, ground.cell_z, ground.u, ground.v, level, ground.is_hit);
      const Slopes far =
          mean_slopes(heights_m, field, ground.cell_x, ground.cell_z, ground.u, ground.v, level + 1, ground.is_hit);
      const lanes between = detail - convert_lanes(level);
      const lanes slope_x = mix(near.x, far.x, between), slope_z = mix(near.z, far.z, between);
#endif
      const lanes up = rsqrt(1.0f + slope_x * slope_x + slope_z * slope_z);

      const lanes to_sun =
          fmax((sky.sun_direction_y - slope_x * sky.sun_direction_x - slope_z * sky.sun_direction_z) * up, (lanes)0.0f);
      const int_lanes is_lit = ground.is_hit & mask_of(to_sun > 0.0f) & mask_of((lanes)light.sun_red_klx > 0.0f);
      const lanes sun = to_sun * sun_share(heights_m, lids_m, field, sky, ground, height_m, is_lit);
      const Colours cover = ground_cover(light, (convert_lanes(ground.cell_x) + ground.u) / field.cells_per_m_x,
                                         (convert_lanes(ground.cell_z) + ground.v) / field.cells_per_m_z, height_m, up,
                                         footprint_m);
      // A slope sees the sky in part, and for the rest level ground of its own colour.
      const lanes sky_share = 0.5f + 0.5f * up, ground_share = 1.0f - sky_share;
      const float level_sun = max(sky.sun_direction_y, 0.0f);

      // Light scattered into the way, as that of the sky where the way would go on; all of it where nothing else is left.
      const lanes rayleigh_m = air_between(ground.t_m, eye_m, height_m, light.rayleigh_scale_height_m);
      const lanes aerosol = light.aerosol_perm * air_between(ground.t_m, eye_m, height_m, light.aerosol_scale_height_m);
      float distances_m[LANES], sights[3][LANES], lights[6][LANES];
      store_lanes(ground.t_m, distances_m);
      store_lanes(rays.along_x / field.cells_per_m_x, sights[0]);
      store_lanes(rays.along_z / field.cells_per_m_z, sights[1]);
      store_lanes(convert_lanes(ground.is_hit), sights[2]);
#define seen_of(channel)                                                                                               \
  (cover.channel * (1.0f / SKY_PI) *                                                                                   \
   (light.sun_##channel##_klx * sun + light.sky_##channel##_klx * sky_share +                                          \
    cover.channel * ground_share * (light.sun_##channel##_klx * level_sun + light.sky_##channel##_klx)))
#define left_of(channel) exp(-aerosol - light.rayleigh_##channel##_perm * rayleigh_m)
      const lanes left_red = left_of(red), left_green = left_of(green), left_blue = left_of(blue);
      store_lanes(seen_of(red) * left_red, lights[0]);
      store_lanes(seen_of(green) * left_green, lights[1]);
      store_lanes(seen_of(blue) * left_blue, lights[2]);
      store_lanes(1.0f - left_red, lights[3]);
      store_lanes(1.0f - left_green, lights[4]);
      store_lanes(1.0f - left_blue, lights[5]);
      for (int lane = 0; lane < LANES; ++lane) {
        const int x = column + lane % BLOCK_COLUMNS, y = row + lane / BLOCK_COLUMNS;
        if (x >= view.width_px || y >= view.height_px) continue;
        float4 seen = (float4)(0.0f);
        if (sights[2][lane] != 0.0f) {
          const float3 level_sight = normalize((float3)(sights[0][lane], 0.0f, sights[1][lane] + 1e-12f));
          const float3 haze = sky_radiance(sky, view_table, level_sight);
          seen = (float4)((float3)(lights[0][lane], lights[1][lane], lights[2][lane]) +
                              (float3)(lights[3][lane], lights[4][lane], lights[5][lane]) * haze,
                          1.0f);
        }
        image[(size_t)y * view.width_px + x] = seen;
      }
    }
  }
}
