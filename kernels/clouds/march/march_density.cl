// Extinction of each cell of a volume: sums of the particles' balls of density h (C1). A work-item
// owns a plane of cells and takes particles in their order, so that sums round alike on all devices.
// In:  particles first ... end - 1 of one cloud; its volume. Global size: planes along z, or more.
// Out: density [CLOUD_MARCH_CELLS], 1/m.
#include "clouds/chord.clh"
#include "clouds/march/march_volume.clh"
#include "simd/lane_masks.clh"

__kernel void march_density(__global const CloudParticle *restrict particles, int first, int end,
                            const CloudMarchVolume volume, __global float *restrict density) {
  const int z = (int)get_global_id(0);
  if (z >= volume.size_z) return;
  __global float *plane = density + (size_t)z * volume.size_y * volume.size_x;
  for (int i = 0; i < volume.size_x * volume.size_y; i += LANES) store_lanes((lanes)0.0f, plane + i);
  const float a_metre = 1.0f / volume.cell_m, middle_z = (float)z + 0.5f;
  for (int i = first; i < end; ++i) {
    const float radius = march_radius(volume, particles[i].radius);
    const float3 place = in_volume(volume, (float3)(particles[i].x, particles[i].y, particles[i].z));
    const float from_z = middle_z - (place.z - volume.low_z) * a_metre;
    // What is not a number is in no plane.
    if (!(fabs(from_z) < radius)) continue;
    const float at_x = (place.x - volume.low_x) * a_metre, at_y = (place.y - volume.low_y) * a_metre;
    if (!isfinite(at_x + at_y + radius + particles[i].optical_mass)) continue;
    const float a_square = 1.0f / (radius * radius), radius_m = radius * volume.cell_m;
    const float amount = particles[i].optical_mass / (CLOUD_BALL_MASS * radius_m * radius_m * radius_m);
    const int first_y = max((int)ceil(at_y - radius - 0.5f), 0), end_y = min((int)floor(at_y + radius + 0.5f), volume.size_y);
    for (int y = first_y; y < end_y; ++y) {
      const float from_y = (float)y + 0.5f - at_y;
      const float across = from_z * from_z + from_y * from_y, left = radius * radius - across;
      if (left <= 0.0f) continue;
      const float half_width = sqrt(left);
      const int first_x = max((int)floor(at_x - half_width - 0.5f), 0) / LANES * LANES;
      const int end_x = min((int)ceil(at_x + half_width + 0.5f), volume.size_x);
      __global float *row = plane + y * volume.size_x;
      for (int x = first_x; x < end_x; x += LANES) {
        const lanes from_x = (float)x + 0.5f + LANE_INDEX - at_x;
        const lanes q = least(a_square * fma(from_x, from_x, (lanes)across), (lanes)1.0f);
        const lanes h = (1.0f - q) * (1.0f - q) * (1.0f - (4.0f / 9.0f) * q);
        store_lanes(fma((lanes)amount, h, load_lanes(row + x)), row + x);
      }
    }
  }
}
