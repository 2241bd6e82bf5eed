// Values with their next ones, in pairs (march_pairs.clh).
// In:  values [count].
// Out: pairs [first + count], from `first` on.
#include "clouds/march/march_pairs.clh"

__kernel void march_pairs(__global const float *restrict values, int count, int first, __global uint *restrict pairs) {
  for (int i = (int)get_global_id(0); i < count; i += (int)get_global_size(0))
    pairs[first + i] = pair_of(values[i], values[min(i + 1, count - 1)]);
}
