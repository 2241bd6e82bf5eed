// Optical depth of the way from the middle of each cell of a volume to the first sun, along the volume's z. Other clouds
// before this one add theirs where the light enters. A work-item owns rows of cells along x.
// In:  the volume, density; grids, looks, lights [clouds]; of light_entry.cl entries, which count where there are several
//      clouds. Global size: rows along y, or more.
// Out: depths [suns][CLOUD_MARCH_CELLS], of the first.
#include "clouds/march/march_entry.clh"
#include "simd/lane_masks.clh"

__kernel void march_descent(const CloudMarchVolume volume, __global const float *restrict density,
                            __global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
                            __global const CloudLightParams *restrict lights, __global const float *restrict entries,
                            int clouds, int suns, int channels, __global float *restrict depths) {
  const int y = (int)get_global_id(0), plane = volume.size_x * volume.size_y;
  if (y >= volume.size_y) return;
  const MarchEntry entry = march_entry(volume, grids, looks, lights, entries, suns, channels, 0);
  density += y * volume.size_x;
  depths += y * volume.size_x;
  for (int x = 0; x < volume.size_x; x += LANES) {
    float before[LANES];
    for (int lane = 0; lane < LANES; ++lane)
      before[lane] = clouds > 1 ? depth_before(volume, entry, x + lane, y, volume.size_z) : 0.0f;
    lanes depth = load_lanes(before);
    for (int z = volume.size_z - 1; z >= 0; --z) {
      const lanes half_cell = 0.5f * volume.cell_m * load_lanes(density + z * plane + x);
      store_lanes(depth + half_cell, depths + z * plane + x);
      depth += 2.0f * half_cell;
    }
  }
}
