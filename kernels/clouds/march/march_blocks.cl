// Which blocks of cells of a volume hold anything that a trilinear sample in them would see.
// In:  its density. Global size: blocks, or more.
// Out: blocks [slots][CLOUD_MARCH_BLOCKS], 1 or 0.
#include "shared/cloud_march.h"

__kernel void march_blocks(const CloudMarchVolume volume, __global const float *restrict density,
                           __global int *restrict blocks) {
  const int columns = volume.size_x / CLOUD_MARCH_BLOCK, rows = volume.size_y / CLOUD_MARCH_BLOCK;
  const int planes = volume.size_z / CLOUD_MARCH_BLOCK, block = (int)get_global_id(0);
  if (block >= columns * rows * planes) return;
  density += (size_t)volume.slot * CLOUD_MARCH_CELLS;
  const int x = block % columns * CLOUD_MARCH_BLOCK, y = block / columns % rows * CLOUD_MARCH_BLOCK;
  const int z = block / columns / rows * CLOUD_MARCH_BLOCK;
  const int end_x = min(x + CLOUD_MARCH_BLOCK + 1, volume.size_x), end_y = min(y + CLOUD_MARCH_BLOCK + 1, volume.size_y);
  const int end_z = min(z + CLOUD_MARCH_BLOCK + 1, volume.size_z);
  float most = 0.0f;
  for (int k = max(z - 1, 0); k < end_z; ++k)
    for (int j = max(y - 1, 0); j < end_y; ++j)
      for (int i = max(x - 1, 0); i < end_x; ++i)
        most = fmax(most, density[(k * volume.size_y + j) * volume.size_x + i]);
  blocks[(size_t)volume.slot * CLOUD_MARCH_BLOCKS + block] = most > 0.0f;
}
