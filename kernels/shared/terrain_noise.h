// The unit of the places at which noise on terrain is asked for.
#ifndef OFFING_KERNELS_SHARED_TERRAIN_NOISE_H
#define OFFING_KERNELS_SHARED_TERRAIN_NOISE_H

// m: 3/256, so that whole steps are exact.
#define TERRAIN_STEP_M 0.01171875f

#endif
