// The next level of the pyramid: of 2 x 2 nodes the highest (Park, Oh & Cho 2007, section 3.2).
// inout maxima: the level of 2 nodes_x columns at `source` -> that of nodes_x columns at `target`, m.
__kernel void pyramid_reduce(__global float *maxima_m, int source, int nodes_x, int target) {
  const int x = (int)get_global_id(0), z = (int)get_global_id(1);
  __global const float *above = maxima_m + source + (size_t)4 * z * nodes_x + 2 * x;
  __global const float *below = above + 2 * nodes_x;
  maxima_m[target + (size_t)z * nodes_x + x] = fmax(fmax(above[0], above[1]), fmax(below[0], below[1]));
}
