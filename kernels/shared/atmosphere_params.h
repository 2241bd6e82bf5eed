// The air and the ground as the kernels that make the sky's tables see them, one layout for host and device:
// 4-byte scalars only, padding written out.
#ifndef OFFING_KERNELS_SHARED_ATMOSPHERE_PARAMS_H
#define OFFING_KERNELS_SHARED_ATMOSPHERE_PARAMS_H

// Light is carried at four wavelengths: _0 ... _3 are 626, 564, 512, 440 nm (host/sky/atmosphere.h says why).
typedef struct {
  float ground_radius_m;
  float thickness_m;  // altitude where the air ends
  float rayleigh_scale_height_m;
  float aerosol_scale_height_m;
  float rayleigh_scattering_0_perm;  // at the ground
  float rayleigh_scattering_1_perm;
  float rayleigh_scattering_2_perm;
  float rayleigh_scattering_3_perm;
  float ozone_absorption_0_perm;  // at the peak of its layer
  float ozone_absorption_1_perm;
  float ozone_absorption_2_perm;
  float ozone_absorption_3_perm;
  float ozone_peak_m;
  float ozone_half_width_m;
  float aerosol_scattering_perm;  // at the ground
  float aerosol_extinction_perm;
  float sun_angular_radius_rad;
  float padding;
  float ground_albedo_0;
  float ground_albedo_1;
  float ground_albedo_2;
  float ground_albedo_3;
} AtmosphereParams;

#if !defined(__OPENCL_VERSION__) && defined(__cplusplus)
static_assert(sizeof(AtmosphereParams) == 88, "no padding");
#endif

#endif
