// The shadow that clouds throw, one layout for host, device and shaders: 4-byte scalars only.
#ifndef OFFING_KERNELS_SHARED_CLOUD_SHADOW_H
#define OFFING_KERNELS_SHARED_CLOUD_SHADOW_H

// Texels a side of the map [CLOUD_SHADOW_SIZE][CLOUD_SHADOW_SIZE].
#define CLOUD_SHADOW_SIZE 512

// What a texel holds above a place is the logistic function of deviations times this, within 0.01 of the normal
// distribution, of no deviation smaller than the least.
#define CLOUD_SHADOW_SLOPE 1.702f
#define CLOUD_SHADOW_LEAST_DEVIATION 1e-4f
#define CLOUD_SHADOW_MOST_DEVIATIONS 35.0f

// A square across the sun's light around a middle, in the axes of the particles. half_width 0: there is no shadow.
typedef struct {
  float middle_x, middle_y, middle_z;  // m
  float right_x, right_y, right_z;     // unit, along the map's columns
  float up_x, up_y, up_z;              // unit, along its rows
  float sun_x, sun_y, sun_z;           // unit, toward the sun
  float half_width;                    // m
  float padding_0, padding_1, padding_2;
} CloudShadowParams;

#if !defined(__OPENCL_VERSION__) && defined(__cplusplus)
static_assert(sizeof(CloudShadowParams) == 64, "no padding but what is written");
#endif

#endif
