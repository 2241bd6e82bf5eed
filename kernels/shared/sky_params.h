// Parameters and table sizes of the sky's radiance function, one layout for host, device and GLSL (a std140
// block of scalars packs them alike): 4-byte scalars only, padding written out.
#ifndef OFFING_KERNELS_SHARED_SKY_PARAMS_H
#define OFFING_KERNELS_SHARED_SKY_PARAMS_H

// Tables are [rows][columns] float4, row-major. kernels/sky/clear_sky.clh says what their coordinates mean.
#define SKY_DEPTH_COLUMNS 128
#define SKY_DEPTH_ROWS 128
#define SKY_SCATTERING_COLUMNS 64
#define SKY_SCATTERING_ROWS 24
#define SKY_VIEW_COLUMNS 33
#define SKY_VIEW_ROWS_ABOVE 80  // from the zenith to the horizon
#define SKY_VIEW_ROWS_BELOW 32  // from the horizon to the nadir
#define SKY_VIEW_ROWS 112       // of one layer: both
#define SKY_VIEW_LAYERS 2
#define SKY_ILLUMINANCE_RINGS 64

// What the radiance function needs to know beside its tables. Axes: x east, y up, z south.
typedef struct {
  float sun_direction_x;  // unit, toward the sun
  float sun_direction_y;
  float sun_direction_z;
  float eye_altitude_m;
  float ground_radius_m;
  float thickness_m;
  float aerosol_asymmetry;
  float sun_angular_radius_rad;
  // Linear Rec.709 of all sunlight above the air, klx, as a sum over four wavelengths.
  float red_0_klx;
  float red_1_klx;
  float red_2_klx;
  float red_3_klx;
  float green_0_klx;
  float green_1_klx;
  float green_2_klx;
  float green_3_klx;
  float blue_0_klx;
  float blue_1_klx;
  float blue_2_klx;
  float blue_3_klx;
} SkyParams;

#if !defined(__OPENCL_VERSION__) && defined(__cplusplus)
static_assert(sizeof(SkyParams) == 80, "no padding, and none that std140 would add");
#endif

#endif
