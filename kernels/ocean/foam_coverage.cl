// Foam that folding crests make at one instant.
// In:  displacement, gradient [n][n] float4 of ocean/surface_assemble.cl, from texel `first` on.
// Out: coverage [n][n] half, 0 ... 1: clamp((onset - J) / width, 0, 1).
// Where J is small the surface folds or is about to: Tessendorf 2001, "Simulating ocean water". F after Lee & Lee
// 2007, eq. 7, corrected (O7).
#include "ocean/deformation.clh"

__kernel void foam_coverage(__global const float4 *restrict displacement, __global const float4 *restrict gradient,
                            int first, float onset_jacobian, float width, __global half *restrict coverage) {
  const int texel = (int)get_global_id(0);
  const float4 g = gradient[first + texel];
  const float jacobian = deformation_jacobian(1.0f + g.z, displacement[first + texel].w, 1.0f + g.w).x;
  vstore_half(clamp((onset_jacobian - jacobian) / width, 0.0f, 1.0f), texel, coverage);
}
