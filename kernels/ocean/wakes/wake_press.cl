// A wake window's water from the level that it would rest at under what presses it.
// In:  state [n][n] float2 of ocean/wakes/wake_settle_columns.cl; displaced [n][n] m of ocean/wakes/wake_displace.cl.
// Out: pressed [n][n] float2: what oscillates about 0 while the pressure stays.
__kernel void wake_press(__global const float2 *restrict state, __global const float *restrict displaced,
                         __global float2 *restrict pressed) {
  const size_t place = get_global_id(0);
  pressed[place] = state[place] + (float2)(displaced[place], 0.0f);
}
