// Clouds that are marched along the line of sight, one layout for host and device: 4-byte scalars only.
#ifndef OFFING_KERNELS_SHARED_CLOUD_MARCH_H
#define OFFING_KERNELS_SHARED_CLOUD_MARCH_H

// Room for the cells of a volume; those along x are a multiple of CLOUD_MARCH_ROW, those along y and z of
// CLOUD_MARCH_BLOCK, the edge of the blocks of which is known whether they hold anything.
#define CLOUD_MARCH_CELLS 524288
#define CLOUD_MARCH_ROW 16
#define CLOUD_MARCH_BLOCK 4
#define CLOUD_MARCH_BLOCKS (CLOUD_MARCH_CELLS / (CLOUD_MARCH_BLOCK * CLOUD_MARCH_BLOCK * CLOUD_MARCH_BLOCK))

// Clouds that are marched at most: the largest on the screen.
#define CLOUD_MARCH_VOLUMES 6

// A cloud's box divided into so many equal cubes: the cloud is marched where their edge is large in the picture.
#define CLOUD_MARCH_EDGES 4096.0f

// Least radius of a particle's ball, in cells of a volume. The ball's sum over cells depends on where their
// middles lie, rms: radius 1: 17 %, 1.2: 1.1 %, 1.4: 3.9 %, 1.6: 1.4 %, 1.8: 0.7 %. A large one blurs thin rims:
// with 1.8 those of a cumulonimbus against the sun are 13 % too bright.
#define CLOUD_MARCH_LEAST_RADIUS 1.2f

// Edge of the cube of noise that lumps the density (host/clouds/light/lump_noise.h); a power of two.
#define CLOUD_LUMP_TEXELS 64
// A texel holds four values of it, its own and those next along x, y and both, in 8 bits each.
#define CLOUD_LUMP_LEAST -2.0f
#define CLOUD_LUMP_STEP (1.0f / 32.0f)

// The particles of a cloud between planes across the axes of its volume.
typedef struct {
  float low_x, low_y, low_z, high_x, high_y, high_z;  // m, along these axes
  int first, end;                                     // of its particles; equal: it has none
  float edge_m;                                       // of one of CLOUD_MARCH_EDGES equal cubes that fill its box
  float radius_m;                                     // of its particles, in the mean
  float anchor_x, anchor_y, anchor_z;                 // m: a particle, which noise moves with
  unsigned int texture;                               // of that particle
} CloudMarchBounds;

// The density of a cloud in cells of a cube's shape, with an axis along the light of the first sun, so that
// light goes from cell to cell.
typedef struct {
  float right_x, right_y, right_z;     // unit: the volume's x in the axes of the particles
  float up_x, up_y, up_z;              // unit, its y
  float sun_x, sun_y, sun_z;           // unit, its z: toward the first sun
  float low_x, low_y, low_z;           // m, its least corner, along these axes from the particles' origin
  float cell_m;                        // edge of a cell
  int size_x, size_y, size_z;          // cells along each axis
  int cloud;                           // whose it is
  int slot;                            // where its cells lie in arrays
  float share;                         // of the cloud that is marched, 0 ... 1; billboards show the rest
  float lump_m;                        // edge of a texel of noise
  float lumps;                         // how strong they are, 0 ... 1
  float anchor_x, anchor_y, anchor_z;  // m, of the noise's origin in the axes of the particles
} CloudMarchVolume;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(CloudMarchBounds) == 56, "no padding");
static_assert(sizeof(CloudMarchVolume) == 96, "no padding");
#endif

#endif
