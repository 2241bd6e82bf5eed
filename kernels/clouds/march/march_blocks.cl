// Which blocks of cells of a volume hold anything that a trilinear sample in them would see: those that balls of particles
// reach. A work-item owns a plane of blocks.
// In:  particles first ... end - 1 of one cloud; its volume. Global size: planes of blocks, or more.
// Out: blocks [slots][CLOUD_MARCH_BLOCKS], 1 or 0.
#include "clouds/march/march_volume.clh"

__kernel void march_blocks(__global const CloudParticle *restrict particles, int first, int end,
                           const CloudMarchVolume volume, __global int *restrict blocks) {
  const int columns = volume.size_x / CLOUD_MARCH_BLOCK, rows = volume.size_y / CLOUD_MARCH_BLOCK;
  const int planes = volume.size_z / CLOUD_MARCH_BLOCK, plane = (int)get_global_id(0);
  if (plane >= planes) return;
  blocks += (size_t)volume.slot * CLOUD_MARCH_BLOCKS + plane * rows * columns;
  for (int i = 0; i < rows * columns; ++i) blocks[i] = 0;
  const float a_block = 1.0f / ((float)CLOUD_MARCH_BLOCK * volume.cell_m);
  const float3 low = (float3)(volume.low_x, volume.low_y, volume.low_z);
  for (int i = first; i < end; ++i) {
    const float3 at = a_block * (in_volume(volume, (float3)(particles[i].x, particles[i].y, particles[i].z)) - low);
    // Samples see the cells beside theirs.
    const float reach = a_block * volume.cell_m * (march_radius(volume, particles[i].radius) + 1.0f);
    const float beyond_z = fmax(fabs((float)plane + 0.5f - at.z) - 0.5f, 0.0f);
    // What is not a number is in no plane.
    if (!(beyond_z < reach) || !isfinite(at.x + at.y)) continue;
    const int first_x = max((int)floor(at.x - reach), 0), last_x = min((int)floor(at.x + reach), columns - 1);
    const int first_y = max((int)floor(at.y - reach), 0), last_y = min((int)floor(at.y + reach), rows - 1);
    for (int y = first_y; y <= last_y; ++y) {
      const float beyond_y = fmax(fabs((float)y + 0.5f - at.y) - 0.5f, 0.0f);
      for (int x = first_x; x <= last_x; ++x) {
        const float beyond_x = fmax(fabs((float)x + 0.5f - at.x) - 0.5f, 0.0f);
        if (beyond_x * beyond_x + beyond_y * beyond_y + beyond_z * beyond_z < reach * reach) blocks[y * columns + x] = 1;
      }
    }
  }
}
