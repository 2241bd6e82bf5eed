// The first level of the pyramid: of 2 x 2 patches the highest corner (Park, Oh & Cho 2007, section 3.2, with maxima of
// patches as T8 has them). A patch lies between its corners, so that nothing of it is above.
// In:  heights [rows][columns] m, from `first_post` on.
// Out: maxima [nodes_z][nodes_x] m, from `first_node` on; -FLT_MAX for nodes beyond the map.
__kernel void pyramid_base(__global const float *restrict heights_m, int first_post, int columns, int rows, int nodes_x,
                           __global float *restrict maxima_m, int first_node) {
  const int x = (int)get_global_id(0), z = (int)get_global_id(1);
  float maximum_m = -FLT_MAX;
  if (2 * x < columns - 1 && 2 * z < rows - 1) {
    const int second = 2 * x + 1, third = min(2 * x + 2, columns - 1);
    for (int row = 2 * z; row < min(2 * z + 3, rows); ++row) {
      __global const float *of_row = heights_m + first_post + (size_t)row * columns;
      maximum_m = fmax(maximum_m, fmax(of_row[2 * x], fmax(of_row[second], of_row[third])));
    }
  }
  maxima_m[first_node + (size_t)z * nodes_x + x] = maximum_m;
}
