// The rays of a camera whose eye is mirrored in a level plane, for terrain/ray_cast.cl.
// In:  field, view of the mirrored eye (shared/terrain.h), plane_m: the plane's height; farthest_m: rays that come up
//      farther away see nothing.
// Out: rays [height_px][width_px] from where they come up through the plane; those that do not are not finite.
#include "terrain/mirror.clh"

__kernel void mirror_rays(TerrainField field, TerrainView view, float plane_m, float farthest_m,
                          __global TerrainRay *restrict rays) {
  const int pixel = (int)get_global_id(0);
  if (pixel >= view.width_px * view.height_px) return;
  MirrorRay of_pixel;
  mirror_ray(view, plane_m, pixel, &of_pixel);
  TerrainRay ray;
  ray.along_x = of_pixel.x * field.cells_per_m_x;
  ray.along_z = of_pixel.z * field.cells_per_m_z;
  ray.along_x_rest = 0.0f;
  ray.along_z_rest = 0.0f;
  ray.rise = of_pixel.y;
  ray.limit_m = farthest_m;
  ray.height_m = plane_m;
  ray.height_rest_m = 0.0f;
  const bool comes_up = of_pixel.begin_m < farthest_m;
  const float begin_m = comes_up ? of_pixel.begin_m : 0.0f;
  const float x = view.fraction_x + begin_m * ray.along_x, z = view.fraction_z + begin_m * ray.along_z;
  ray.cell_x = view.cell_x + (int)floor(x);
  ray.cell_z = view.cell_z + (int)floor(z);
  ray.fraction_x = x - floor(x);
  ray.fraction_z = z - floor(z);
  if (!comes_up) ray.rise = NAN;
  rays[pixel] = ray;
}
