// Parameters of the ocean kernels, one layout for host and device: 4-byte scalars only, padding written out.
#ifndef OFFING_KERNELS_SHARED_OCEAN_PARAMS_H
#define OFFING_KERNELS_SHARED_OCEAN_PARAMS_H

// One cascade's modes and the spectrum table, for ocean/mode_variance.cl.
typedef struct {
  float wavenumber_step_radpm;  // 2 pi / patch length
  float k_min_radpm;            // the band: k_min <= |K| < k_max
  float k_max_radpm;
  float log_k_first;  // of the spectrum table: ln of its first wavenumber in rad/m
  float log_k_step;
  int wavenumber_count;  // nk, nd of the table [nk][nd]
  int direction_count;
  int padding;
} OceanSpectrumParams;

// A rectangle of rest labels in each cascade's patch, for ocean/surface_compose.cl. Places are in 2^-32 of
// the patch, in two's complement: sums that overflow lose whole patches, and nothing else.
typedef struct {
  int origin_column[4];  // label of sample (0, 0)
  int origin_row[4];
  int column_step[4];  // between neighbouring samples
  int row_step[4];
  int cascade_count;
  int columns;
  int rows;
  int gerstner_pitch;  // samples from row to row of the Gerstner waves' maps; 0 without Gerstner waves
  int adds_slopes;     // 1: slopes at labels, as they add up; 0: of the displaced surface
} OceanComposeParams;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(OceanSpectrumParams) == 32, "no padding");
static_assert(sizeof(OceanComposeParams) == 84, "no padding");
#endif

#endif
