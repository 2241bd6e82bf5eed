// Where the keys of each digit and tile start: sums of all counts before, by one work-group.
// In:  counts [count], digit by digit, tiles within.
// Out: starts [count].
// Set: SCAN_SIZE, work-items of the group.
__kernel __attribute__((reqd_work_group_size(SCAN_SIZE, 1, 1))) void radix_scan(__global const uint *restrict counts,
                                                                                int count,
                                                                                __global uint *restrict starts) {
  __local uint sums[SCAN_SIZE];
  const int item = (int)get_local_id(0), span = (count + SCAN_SIZE - 1) / SCAN_SIZE;
  const int first = min(item * span, count), end = min(first + span, count);
  uint sum = 0u;
  for (int i = first; i < end; ++i) sum += counts[i];
  sums[item] = sum;
  barrier(CLK_LOCAL_MEM_FENCE);
  uint start = 0u;
  for (int i = 0; i < item; ++i) start += sums[i];
  for (int i = first; i < end; ++i) {
    starts[i] = start;
    start += counts[i];
  }
}
