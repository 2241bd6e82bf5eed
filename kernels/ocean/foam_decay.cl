// Foam of a map, faded, joined to the coverage of another instant.
// In:  past [n][n], foam; coverage [n][n] half of ocean/foam_coverage.cl; a weight for each, such as e^(-age / decay time).
// Out: foam [n][n]: the larger of the two, weighted.
__kernel void foam_decay(__global const float *restrict past, float past_weight, __global const half *restrict coverage,
                         float weight, __global float *restrict foam) {
  const int texel = (int)get_global_id(0);
  foam[texel] = fmax(past_weight * past[texel], weight * vload_half(texel, coverage));
}
