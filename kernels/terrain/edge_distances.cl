// Distance at which each pixel's ground is drawn (T10 of docs/sources.md). If ground covers only part of a pixel and the
// pixel's own ray misses it, that is the distance of the nearest ground beside it.
// In:  field, view (shared/terrain.h); distances_m [height_px][width_px] along the unit rays to the ground, or to the lake
//      before it, +inf for misses; image [height_px][width_px] of terrain/terrain_shade.cl for the same view; hidden_below_m
//      and hidden_bend_perm of shared/terrain_look.h.
// Out: drawn_m [height_px][width_px].
#include "terrain/image_rays.clh"

// Nearest distance among the four neighbours. Those that ground covers wholly come first: rays of the others may have hit
// what is under water.
INLINE float distance_beside(__global const float *distances_m, __global const float4 *image, TerrainView view, int column,
                             int row) {
  float found_m = distances_m[row * view.width_px + column];
  bool is_first = true, is_covered = false;
  for (int side = 0; side < 4; ++side) {
    const int away = side % 2 * 2 - 1;
    const int x = clamp(column + (side < 2 ? away : 0), 0, view.width_px - 1);
    const int y = clamp(row + (side < 2 ? 0 : away), 0, view.height_px - 1);
    const float coverage = image[y * view.width_px + x].w, there_m = distances_m[y * view.width_px + x];
    const bool covers = coverage >= 1.0f;
    if (coverage <= 0.0f || (is_covered && !covers)) continue;
    found_m = is_first || covers != is_covered ? there_m : min(found_m, there_m);
    is_first = false;
    is_covered = covers;
  }
  return found_m;
}

__kernel void edge_distances(TerrainField field, TerrainView view, __global const float *restrict distances_m,
                             __global const float4 *restrict image, float hidden_below_m, float hidden_bend_perm,
                             __global float *restrict drawn_m) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  if (column >= view.width_px || row >= view.height_px) return;
  const int pixel = row * view.width_px + column;
  const float coverage = image[pixel].w;
  float distance_m = distances_m[pixel];
  if (coverage > 0.0f && coverage < 1.0f) {
    const Rays rays = rays_of(field, view, column, row);
    // As shown_by_height() has it.
    const bool meets_ground = !isinf(distance_m) && rays.height_m + distance_m * rays.rise >=
                                                        hidden_below_m - hidden_bend_perm * distance_m * distance_m;
    if (!meets_ground) distance_m = distance_beside(distances_m, image, view, column, row);
  }
  drawn_m[pixel] = distance_m;
}
