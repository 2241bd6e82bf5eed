// The horizon of posts by azimuth: the least rise at which a ray passes over all ground that lies its way (Max 1988, Horizon
// mapping), found by walks through the pyramid. A walk begins at the rise of the ground where the horizon of the post north
// of it was: that ground lies in its own way, so that its horizon is at least there, and mostly little above.
// In:  heights [rows][columns] m, maxima, field (shared/terrain.h); directions [azimuths] (east, south), unit; the first of
//      `rows` rows that are looked from; bend, the fall of the Earth by d^2 (m a square metre), with IS_CURVED.
// Out: rises [azimuths][rows][stride] m/m, 0 or more, less HORIZON_STEP at most.
// A work-item takes LANES columns in one azimuth.
#define EXACT_HORIZONS
#define HORIZON_STEP 0.001f
#include "terrain/traversal.clh"

// Walks begin so far above the ground, in the smaller side of a cell: more than the rounding of places, 1e-6 of it.
#define HORIZON_LIFT 2e-5f

// The rise from posts to the ground at a way from them; 0 where that is nearer than half a cell, or beyond the map.
INLINE lanes rise_to(Terrain terrain, int_lanes post_x, int_lanes post_z, Rays rays, lanes way_m, float cell_m, float bend) {
  const TerrainField field = terrain.field;
  const lanes cells_x = way_m * rays.along_x, cells_z = way_m * rays.along_z;
  const int_lanes whole_x = whole_cells(cells_x), whole_z = whole_cells(cells_z);
  const int_lanes cell_x = post_x + whole_x, cell_z = post_z + whole_z;
  const int_lanes is_there = mask_of(way_m >= 0.5f * cell_m) & mask_of(cell_x >= 0) & mask_of(cell_z >= 0) &
                             mask_of(cell_x < field.cells_x) & mask_of(cell_z < field.cells_z);
  if (!any_lane(is_there)) return (lanes)0.0f;
  const int_lanes none = (int_lanes)0;
  const lanes ground_m = surface_place(terrain, select(none, cell_x, is_there), select(none, cell_z, is_there),
                                        cells_x - convert_lanes(whole_x), cells_z - convert_lanes(whole_z), is_there).height_m;
  return select((lanes)0.0f, (ground_m - rays.height_m - rays.height_rest_m) / way_m + way_m * -bend, is_there);
}

__kernel void horizons(__global const float *restrict heights_m, __global const float *restrict maxima_m, TerrainField field,
                       __global const float *restrict directions, int first_row, int rows, int stride, float bend,
                       __global float *restrict rises) {
  const Terrain terrain = {heights_m, maxima_m, field};
  const int first = (int)get_global_id(0) * LANES, azimuth = (int)get_global_id(1);
  if (first >= stride) return;
  const int_lanes post_x = up_to(first + convert_int_lanes((lanes)LANE_INDEX), field.cells_x);
  const float east = directions[2 * azimuth], south = directions[2 * azimuth + 1];
  const lanes along_x = (lanes)(east * field.cells_per_m_x), along_z = (lanes)(south * field.cells_per_m_z);
  const float cell_m = 1.0f / max(field.cells_per_m_x, field.cells_per_m_z);
  lanes way_m = (lanes)0.0f;
  for (int row = 0; row < rows; ++row) {
    const int_lanes post_z = (int_lanes)(first_row + row);
    const lanes height_m = gathered(heights_m, post_z * field.columns + post_x);
    Rays rays = {post_x,  post_z,  (lanes)0.0f, (lanes)0.0f, height_m,     (lanes)(HORIZON_LIFT * cell_m),
                 along_x, along_z, (lanes)0.0f, (lanes)0.0f, (lanes)1e-6f, (lanes)FARTHEST_M};
    lanes least_rise = rays.rise;
    UNROLL for (int i = -1; i <= 1; ++i) {
      least_rise = most(least_rise, rise_to(terrain, post_x, post_z, rays, way_m + (float)i * cell_m, cell_m, bend));
    }
    rays.rise = least_rise;
    RaySetup ray_setup = ray_setup_of(field, rays);
#ifdef IS_CURVED
    ray_setup.bend = (lanes)bend;
#endif
    const int_lanes level = level_at_origin(terrain, post_x, post_z, height_m);
    const lanes rise = horizon_at(terrain, ray_setup, level_at_start(field, ray_setup, level), &way_m);
    store_lanes(rise, rises + ((size_t)azimuth * rows + row) * stride + first);
  }
}
