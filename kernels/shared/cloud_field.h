// Parameters of the density of clouds (C1 ... C3), one layout for host and device: 4-byte scalars only.
#ifndef OFFING_KERNELS_SHARED_CLOUD_FIELD_H
#define OFFING_KERNELS_SHARED_CLOUD_FIELD_H

// Most octaves of the noise, and most lattice points along an edge of a brick: its 8 cells span 7 steps of at
// most half a wavelength each.
#define CLOUD_OCTAVES_MOST 12
#define CLOUD_LATTICE_POINTS 6

// One octave of noise. Places count in its wavelengths, as 64-bit integers of 2^-32 of one, so that all
// bricks see the same lattice: exact however far from the origin they are.
typedef struct {
  int origin_x, origin_y, origin_z;                 // of the middle of cell (0, 0, 0), whole part
  unsigned int fraction_x, fraction_y, fraction_z;  // 2^-32 of one
  unsigned int step;                                // of a cell, 2^-32 wavelengths, below 2^31 + 1
  unsigned int layer;                               // of the fourth dimension
  float layer_fraction;                             // beyond that, 0 ... 1
  float amplitude;                                  // of the octave in units of the sum's deviation
} CloudOctave;

// Shape of a cloud's density: its cells and noise.
typedef struct {
  float cell_m;
  float blend, strength, wisp, edge;  // C3
  int octaves;
  unsigned int seed_low, seed_high;
  int bricks_x, bricks_y;  // of the grid
} CloudFieldParams;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(CloudOctave) == 40, "no padding");
static_assert(sizeof(CloudFieldParams) == 40, "no padding");
#endif

#endif
