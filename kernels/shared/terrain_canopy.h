// Woods over terrain as pictures show them, one layout for host and device: 4-byte scalars only. Colours are
// linear Rec.709.
#ifndef OFFING_KERNELS_SHARED_TERRAIN_CANOPY_H
#define OFFING_KERNELS_SHARED_TERRAIN_CANOPY_H

// A wood where rules say, or a map of its cover.
typedef struct {
  float height_m;          // of the highest crowns
  float red, green, blue;  // mean diffuse albedo of crowns
  // Heights between which it grows, and over how many metres it ends there.
  float lowest_m, highest_m, edge_m;
  float steepest_rad;  // slopes up to which it grows, an angle from level
  // Noise with cells of 2^patch_log2 steps and finer ones; the wood is where it is higher than `patches`, in
  // deviations.
  int patch_log2;
  float patches;
  // A map of the cover, in place of the rules, as a TerrainLook has one of colours. No columns: there is
  // none.
  int map_columns, map_rows, map_levels;
  float map_left, map_top;
  float map_a_cell_x, map_a_cell_z;
  int stands;  // 1: rays hit crowns; 0: the ground has the mean light of the wood
} TerrainCanopy;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(TerrainCanopy) == 72, "no padding");
#endif

#endif
