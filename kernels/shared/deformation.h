// The limit of the surface's deformation, one value for host and device.
#ifndef OFFING_KERNELS_SHARED_DEFORMATION_H
#define OFFING_KERNELS_SHARED_DEFORMATION_H

// Determinants of the deformation gradient that something is divided by are kept this far off 0, where the
// surface is about to fold.
#define LEAST_DETERMINANT 0.05f

#endif
