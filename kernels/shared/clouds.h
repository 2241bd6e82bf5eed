// Arrays of clouds, one layout for host and device: 4-byte scalars only. Places are relative to the origin of
// the cloud or of the sky that they belong to, +y up.
#ifndef OFFING_KERNELS_SHARED_CLOUDS_H
#define OFFING_KERNELS_SHARED_CLOUDS_H

// Cells along an edge of a brick of a volume (host/base/cloud_volume.h).
#define CLOUD_BRICK_CELLS 8

// Billboard textures of a set (C8); a particle's texture is one of two sets' worth.
#define CLOUD_TEXTURES 16

// Texels along an edge of a billboard texture (host/clouds/image/billboard_textures.h), its mip levels and
// all their texels.
#define CLOUD_TEXTURE_SIZE 256
#define CLOUD_TEXTURE_LEVELS 7
#define CLOUD_TEXTURE_TEXELS 87376

// A metaball (C1): density weight * h(distance / radius).
typedef struct {
  float x, y, z;  // m
  float radius;   // m, above 0
  float weight;   // dimensionless
} CloudBall;

// A particle: a ball of density h(distance / radius), whose extinction sums up to its optical mass. Drawn as
// one billboard.
typedef struct {
  float x, y, z;           // m
  float radius;            // m, above 0
  float optical_mass;      // m^2: its extinction (1/m) over its volume
  float red, green, blue;  // single-scattering albedo, 0 ... 1, linear Rec.709
  unsigned int texture;    // below 2 * CLOUD_TEXTURES: the crisp set, then the soft one
  unsigned int cloud;      // which of the sky's clouds it belongs to
  unsigned int id;         // the same in each generation from the same parameters, unique within its cloud
  float turn;              // rad, of its texture
} CloudParticle;

// What a particle looks like from the eye: made by the light, read by whoever draws.
typedef struct {
  float red, green, blue;  // kcd/m^2, of the particle where nothing is seen through it
  float optical_depth;     // through its middle; at b radii from there times the chord of h there
} CloudSprite;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(CloudBall) == 20, "no padding");
static_assert(sizeof(CloudParticle) == 48, "no padding");
static_assert(sizeof(CloudSprite) == 16, "no padding");
#endif

#endif
