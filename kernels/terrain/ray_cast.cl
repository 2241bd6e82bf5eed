// What any rays hit first, by the walk of terrain/quadtree_cast.cl.
// In:  heights [rows][columns] m, maxima of terrain/pyramid_base.cl and pyramid_reduce.cl, or with TILED the pool and pages
//      of shared/terrain_tiles.h; field, rays [count] (shared/terrain.h).
//      With IS_CURVED (not with endless maps), bend_x_m and bend_z_m: how far the ground falls away at a cell's distance
//      from the origin along x, along z.
// Out: hits [count]; rays that are not finite miss.
#define WRITES_HITS
#include "terrain/endless.clh"
#include "terrain/hit_record.clh"

__kernel void ray_cast(__global const float *restrict heights_m, __global const float *restrict maxima_m,
                       TerrainField field, __global const TerrainRay *restrict rays, int count,
                       __global TerrainHit *restrict hits
#ifdef IS_CURVED
                       , float bend_x_m, float bend_z_m
#endif
) {
  const Terrain terrain = {heights_m, maxima_m, field};
  const int first = (int)get_global_id(0) * LANES;
  int cells[2][LANES];
  float numbers[10][LANES];
  for (int lane = 0; lane < LANES; ++lane) {
    // Lanes beyond the last ray cast it too.
    const TerrainRay ray = rays[min(first + lane, count - 1)];
    cells[0][lane] = ray.cell_x;
    cells[1][lane] = ray.cell_z;
    numbers[0][lane] = ray.fraction_x;
    numbers[1][lane] = ray.fraction_z;
    numbers[2][lane] = ray.height_m;
    numbers[3][lane] = ray.height_rest_m;
    numbers[4][lane] = ray.along_x;
    numbers[5][lane] = ray.along_z;
    numbers[6][lane] = ray.along_x_rest;
    numbers[7][lane] = ray.along_z_rest;
    numbers[8][lane] = ray.rise;
    numbers[9][lane] = ray.limit_m;
  }
  const Rays of_lanes = {load_lanes(cells[0]),   load_lanes(cells[1]),   load_lanes(numbers[0]), load_lanes(numbers[1]),
                         load_lanes(numbers[2]), load_lanes(numbers[3]), load_lanes(numbers[4]), load_lanes(numbers[5]),
                         load_lanes(numbers[6]), load_lanes(numbers[7]), load_lanes(numbers[8]), load_lanes(numbers[9])};
  int_lanes first_level = (int_lanes)field.first_level;
  if (field.starts_at_origin) {
    first_level = level_at_origin(terrain, of_lanes.cell_x, of_lanes.cell_z, of_lanes.height_m);
  }
  TerrainHit records[LANES];
  RaySetup ray_setup = ray_setup_of(field, of_lanes);
#ifdef IS_CURVED
  ray_setup.bend = bend_x_m * (of_lanes.along_x * of_lanes.along_x) + bend_z_m * (of_lanes.along_z * of_lanes.along_z);
#endif
  const Hits found = first_hits(terrain, first_level, &ray_setup);
  record_hits(terrain, ray_setup.ray, found, records);
  for (int lane = 0; lane < min(LANES, count - first); ++lane) hits[first + lane] = records[lane];
}
