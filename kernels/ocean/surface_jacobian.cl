// Jacobian of one cascade's displacement.
// In:  displacement, gradient [n][n] float4 of ocean/surface_assemble.cl, from texel `first` on.
// Out: jacobian [n][n] float2: J = det F and the smaller eigenvalue of F = I + grad(dx, dz). The surface folds where J <= 0.
// Lee & Lee 2007, eq. 7, corrected (O7).
#include "ocean/deformation.clh"

__kernel void surface_jacobian(__global const float4 *restrict displacement, __global const float4 *restrict gradient,
                               int first, __global float2 *restrict jacobian) {
  const int texel = (int)get_global_id(0);
  const float4 g = gradient[first + texel];
  jacobian[texel] = deformation_jacobian(1.0f + g.z, displacement[first + texel].w, 1.0f + g.w);
}
