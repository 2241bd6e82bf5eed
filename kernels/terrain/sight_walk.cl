// Which posts are seen from a point, line by line: those that are undecided.
// In:    heights [rows][columns] m, maxima of terrain/pyramid_base.cl and pyramid_reduce.cl, field (shared/terrain.h),
//        sight (shared/terrain_sight.h).
// inout: seen [rows][columns], SIGHT_UNDECIDED -> SIGHT_HIDDEN or SIGHT_VISIBLE.
// A work-item takes columns_each posts of a row.
#define IS_CURVED
#include "shared/terrain_sight.h"
#include "terrain/traversal.clh"

// Cells from the eye to a post, and what that loses as a float.
INLINE lanes cells_to(int_lanes post, int cell, float fraction, lanes *rest) {
  const lanes whole = convert_lanes(post - cell), cells = whole - fraction;
  *rest = (whole - cells) - fraction;
  return cells;
}

INLINE int_lanes is_seen(Terrain terrain, TerrainSight sight, int_lanes first_level, int_lanes column, int row) {
  const TerrainField field = terrain.field;
  lanes rest_x, rest_z;
  const lanes x = cells_to(column, sight.cell_x, sight.fraction_x, &rest_x);
  const lanes z = cells_to((int_lanes)row, sight.cell_z, sight.fraction_z, &rest_z);
  const lanes bend = sight.bend_x_m * (x * x) + sight.bend_z_m * (z * z);
  const lanes target_m = gathered(terrain.heights_m, row * field.columns + column);
  const lanes rise = (target_m - sight.eye_m) + (sight.target_above_m - sight.eye_rest_m) - bend;
  const Rays rays = {(int_lanes)sight.cell_x,
                     (int_lanes)sight.cell_z,
                     (lanes)sight.fraction_x,
                     (lanes)sight.fraction_z,
                     (lanes)sight.eye_m,
                     (lanes)sight.eye_rest_m,
                     x,
                     z,
                     rest_x,
                     rest_z,
                     rise,
                     (lanes)1.0f};
  RaySetup ray_setup = ray_setup_of(field, rays);
  ray_setup.bend = bend;
  const SightEnds ends = {column, (int_lanes)row, sight.eye_above_m, sight.target_above_m};
  return is_in_sight(terrain, ray_setup, level_at_start(field, ray_setup, first_level), ends);
}

INLINE bool is_decided(uchar16 posts) {
  const long2 undecided = as_long2(posts == (uchar16)SIGHT_UNDECIDED);
  return (undecided.x | undecided.y) == 0;
}

INLINE void hide_posts(__global uchar *posts, int first, int end) {
  int post = first;
  for (; post + 16 <= end; post += 16) vstore16((uchar16)SIGHT_HIDDEN, 0, posts + post);
  for (; post < end; ++post) posts[post] = SIGHT_HIDDEN;
}

__kernel void sight_walk(__global const float *restrict heights_m, __global const float *restrict maxima_m,
                         TerrainField field, TerrainSight sight, int columns_each, __global uchar *seen) {
  const Terrain terrain = {heights_m, maxima_m, field};
  const int row = (int)get_global_id(1);
  int first = (int)get_global_id(0) * columns_each;
  int end = min(first + columns_each, field.columns);
  const float z = (float)(row - sight.cell_z) - sight.fraction_z, far_z = sight.radius_share_z * (z * z);
  const int_lanes first_level = level_at_origin(terrain, (int_lanes)sight.cell_x, (int_lanes)sight.cell_z,
                                                (lanes)sight.eye_m);
  __global uchar *of_row = seen + (size_t)row * field.columns;
#if LANES > 1
  // Columns that are within the radius, by more than rounding, and some more.
  if (sight.radius_share_x > 0.0f) {
    const float reach = min(sqrt((max(1.0f - far_z, 0.0f) + 4e-7f) / sight.radius_share_x) + 2.0f, 1e9f);
    const int first_near = clamp(sight.cell_x - (int)reach, first, end);
    const int end_near = far_z > 1.0f ? first_near : clamp(sight.cell_x + (int)reach + 2, first_near, end);
    hide_posts(of_row, first, first_near);
    hide_posts(of_row, end_near, end);
    first = first_near;
    end = end_near;
  }
#endif
  int columns[LANES];
  int count = 0;
  for (int column = first; column < end; ++column) {
    // Most posts are decided.
    while (end - column >= 16 && is_decided(vload16(0, of_row + column))) column += 16;
    if (column < end && of_row[column] == SIGHT_UNDECIDED) {
      const float x = (float)(column - sight.cell_x) - sight.fraction_x;
      if (sight.radius_share_x * (x * x) + far_z > 1.0f) {
        of_row[column] = SIGHT_HIDDEN;
      } else {
        columns[count++] = column;
      }
    }
    if (count == LANES || (count > 0 && column >= end - 1)) {
      for (int lane = count; lane < LANES; ++lane) columns[lane] = columns[0];
      int answers[LANES];
      store_lanes(is_seen(terrain, sight, first_level, load_lanes(columns), row), answers);
      for (int lane = 0; lane < count; ++lane) {
        of_row[columns[lane]] = answers[lane] != 0 ? SIGHT_VISIBLE : SIGHT_HIDDEN;
      }
      count = 0;
    }
  }
}
