// Foam of one past instant, decayed, joined to what later instants left.
// In:  coverage [n][n] half of ocean/foam_coverage.cl; weight = e^(-age / decay time).
// Out: foam [n][n], inout: the larger of what is there and weight * coverage.
__kernel void foam_decay(__global const half *restrict coverage, float weight, __global float *restrict foam) {
  const int texel = (int)get_global_id(0);
  foam[texel] = fmax(foam[texel], weight * vload_half(texel, coverage));
}
