// Foam between two instants: that of the last one, faded since, and the next one's fading in.
// In:  past [n][n], foam at the last instant; next [n][n] half of ocean/foam_coverage.cl; weights of both.
// Out: foam [n][n]: the larger of the two.
__kernel void foam_now(__global const float* restrict past, float past_weight,
                       __global const half* restrict next, float next_weight, __global float* restrict foam) {
  const int texel = (int)get_global_id(0);
  foam[texel] = fmax(past_weight * past[texel], next_weight * vload_half(texel, next));
}
