// The swash: water that waves wash up and down a shore, one layout for host and device: 4-byte scalars only.
#ifndef OFFING_KERNELS_SHARED_SWASH_H
#define OFFING_KERNELS_SHARED_SWASH_H

#define SWASH_WAVES 8
// With u the phase of a wave, the water follows cos(u + SWASH_SKEW cos u): it rises faster than it falls.
#define SWASH_SKEW 0.5f

// Height of the water's edge over still water at (x, z) m from a place, and so many seconds ago: setup + sum
// of amplitude times the skewed cosine of phase - kx x - kz z - omega seconds.
typedef struct {
  float kx_radpm[SWASH_WAVES], kz_radpm[SWASH_WAVES];
  float amplitude_m[SWASH_WAVES], omega_radps[SWASH_WAVES];
  float phase_rad[SWASH_WAVES];
  float setup_m;
  float reach_m;   // up to which two of a hundred waves wash; 0: there is no swash
  float period_s;  // of most waves
} SwashParams;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(SwashParams) == 172, "no padding");
#endif

#endif
