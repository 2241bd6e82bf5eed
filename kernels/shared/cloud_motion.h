// How the particles of a cloud move (C4, C15), one layout for host and device: 4-byte scalars only.
#ifndef OFFING_KERNELS_SHARED_CLOUD_MOTION_H
#define OFFING_KERNELS_SHARED_CLOUD_MOTION_H

// Where the particles of a cloud are at a time.
typedef struct {
  float drift_x, drift_y, drift_z;  // m, of all
  float along_x, along_y, along_z;  // unit, where the wind blows; zero without wind
  float flow_x, flow_y, flow_z;     // unit, where it is carried around the sphere
  float lean;                       // m along the wind, a metre higher
  float run;                        // m along the wind, of the thinnest parts
  float densest;                    // optical mass over squared radius, of the densest particle
  float sway;                       // m
  float sway_per_m;                 // 1 / wavelength of the eddies
  unsigned int sway_layer;          // of the fourth dimension of their noise
  float sway_fraction;              // beyond that, 0 ... 1
  unsigned int seed_low, seed_high;
  float lift;                          // m, of parts with the mean excess of heat
  float spread;                        // of the excess, 0 ... 1
  float condensation, condensing;      // m; condensing 0: all is condensed everywhere
  float sphere_x, sphere_y, sphere_z;  // m, of what is flown around, in the moved particles' axes
  float sphere_radius;                 // m, 0 for none
  unsigned int cloud;                  // number that the particles get
} CloudMotionParams;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(CloudMotionParams) == 108, "no padding");
#endif

#endif
