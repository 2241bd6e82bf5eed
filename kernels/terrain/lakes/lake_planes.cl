// Distances to the lakes that stand before the ground that a camera's rays hit.
// In:  field, view (shared/terrain.h); hits [height_px][width_px] of terrain/quadtree_cast.cl for the same view; lakes
//      [count] and their cells (shared/lakes.h).
// Inout: distances [height_px][width_px], m: those of the ground.
#include "terrain/image_rays.clh"
#include "terrain/lakes/lake_hits.clh"

__kernel void lake_planes(TerrainField field, TerrainView view, __global const TerrainHit *restrict hits,
                          __global const LakeWater *restrict lakes, __global const uchar *restrict cells, int count,
                          __global float *restrict distances_m) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  if (column >= view.width_px || row >= view.height_px) return;
  const size_t pixel = (size_t)row * view.width_px + column;
  const TerrainHit hit = hits[pixel];
  if (hit.kind == TERRAIN_MISS) return;
  const Lakes all = {lakes, cells, count};
  const LakeHits found =
      lakes_before(all, rays_of(field, view, column, row), (int_lanes)-1, hit.cell_x, hit.cell_z, hit.distance_m);
  if (found.lake >= 0) distances_m[pixel] = found.t_m;
}
