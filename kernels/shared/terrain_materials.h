// Materials of a scene that lie over the ground's own cover, one layout for host and device: 4-byte scalars
// only. Colours are linear Rec.709.
#ifndef OFFING_KERNELS_SHARED_TERRAIN_MATERIALS_H
#define OFFING_KERNELS_SHARED_TERRAIN_MATERIALS_H

// Whose relief and pattern a material has.
#define TERRAIN_LIKE_GRASS 0
#define TERRAIN_LIKE_SCREE 1
#define TERRAIN_LIKE_ROCK 2
#define TERRAIN_LIKE_SAND 3

// Heights beyond all ground.
#define TERRAIN_NO_LIMIT_M 1e30f

typedef struct {
  int like;
  float red, green, blue;  // mean diffuse albedo
  float roughness;         // strength of the relief
  // Heights between which it lies, and over how many metres it ends there.
  float lowest_m, highest_m, edge_m;
  // Slopes between which it lies, angles from level.
  float gentlest_rad, steepest_rad;
  // Noise is made of these parts; the material lies where it is higher than `patches`, in deviations.
  float of_broad, of_patch, of_fine;
  float patches;
} TerrainMaterial;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(TerrainMaterial) == 56, "no padding");
#endif

#endif
