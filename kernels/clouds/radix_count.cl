// How many keys of each tile have each digit.
// In:  keys [count], `span` keys a work-item, the digit's lowest bit `shift`.
// Out: counts [DIGITS][groups].
#include "clouds/radix.clh"

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void radix_count(
    __global const uint *restrict keys, int count, int span, int shift, __global uint *restrict counts) {
  __local uint counters[DIGITS * GROUP_SIZE];
  const int first = span_start(span, count);
  count_span(keys, first, min(first + span, count), shift, counters);
  for (int digit = (int)get_local_id(0); digit < DIGITS; digit += GROUP_SIZE) {
    uint sum = 0u;
    for (int item = 0; item < GROUP_SIZE; ++item) sum += counters[digit * GROUP_SIZE + item];
    counts[digit * (int)get_num_groups(0) + (int)get_group_id(0)] = sum;
  }
}
