// Moves keys and values to the places of their digit, in the order in which they come.
// In:  keys, values [count], as radix_count had them; starts [DIGITS][groups] of radix_scan.
// Out: sorted_keys, sorted_values [count].
#include "clouds/radix.clh"

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void radix_scatter(
    __global const uint *restrict keys, __global const uint *restrict values, int count, int span, int shift,
    __global const uint *restrict starts, __global uint *restrict sorted_keys, __global uint *restrict sorted_values) {
  __local uint counters[DIGITS * GROUP_SIZE];
  const int first = span_start(span, count), end = min(first + span, count);
  count_span(keys, first, end, shift, counters);
  // From counts to the place of each work-item's next key of each digit.
  for (int digit = (int)get_local_id(0); digit < DIGITS; digit += GROUP_SIZE) {
    uint place = starts[digit * (int)get_num_groups(0) + (int)get_group_id(0)];
    for (int item = 0; item < GROUP_SIZE; ++item) {
      const uint here = counters[digit * GROUP_SIZE + item];
      counters[digit * GROUP_SIZE + item] = place;
      place += here;
    }
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  for (int i = first; i < end; ++i) {
    const uint key = keys[i];
    const uint place = counters[digit_of(key, shift) * GROUP_SIZE + get_local_id(0)]++;
    sorted_keys[place] = key;
    sorted_values[place] = values[i];
  }
}
