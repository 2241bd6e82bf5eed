// Hits of the rays of terrain/mirror_rays.cl, as far as they are from the mirrored eye.
// In:  view of the mirrored eye (shared/terrain.h), plane_m: the plane's height;
//      hits [height_px][width_px], by distances from the plane.
// Out: hits, by distances from the eye.
#include "terrain/mirror.clh"

__kernel void mirror_hits(TerrainView view, float plane_m, __global TerrainHit *restrict hits) {
  const int pixel = (int)get_global_id(0);
  if (pixel >= view.width_px * view.height_px) return;
  if (hits[pixel].kind == TERRAIN_MISS) return;
  MirrorRay ray;
  mirror_ray(view, plane_m, pixel, &ray);
  hits[pixel].distance_m += ray.begin_m;
}
