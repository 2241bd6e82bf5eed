// Lakes of terrain and their waves, one layout for host and device: 4-byte scalars only. Colours are linear
// Rec.709.
#ifndef OFFING_KERNELS_SHARED_LAKES_H
#define OFFING_KERNELS_SHARED_LAKES_H

// Flags of a cell: there may be water in it; and from this bit on, of its north-west, north-east, south-west
// and south-east posts, whether the post or one beside it is under water.
#define LAKE_CELL_WET 1
#define LAKE_NEAR_SHIFT 1

// Water of one level.
typedef struct {
  float level_m;
  // A box of cells, [rows][columns] bytes of flags from first_byte on.
  int first_x, first_z, columns, rows;
  int first_byte;
  int first_wave, wave_count;
  // Covariance of the slopes of ripples, shorter than all waves.
  float ripples_xx, ripples_xz, ripples_zz;
  // What water takes of light a metre, and what it sends up where it is deep, by the sky's light and the
  // sun's.
  float attenuation_red_perm, attenuation_green_perm, attenuation_blue_perm;
  float of_sky_red_kcdpm2, of_sky_green_kcdpm2, of_sky_blue_kcdpm2;
  float of_sun_red_kcdpm2, of_sun_green_kcdpm2, of_sun_blue_kcdpm2;
} LakeWater;

// A wave: slope_x = slope * kx / k * cos(kx x + kz z + phase), at places from below the eye.
typedef struct {
  float kx_radpm, kz_radpm;
  float slope;
  float phase_rad;
} LakeWave;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(LakeWater) == 80, "no padding");
static_assert(sizeof(LakeWave) == 16, "no padding");
#endif

#endif
