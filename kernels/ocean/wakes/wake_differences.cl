// The fields of a wake window that are drawn, by differences: for the method without a spectrum.
// In:  state [n][n] float2 of ocean/wakes/wake_verlet.cl; courant and dt of its step, and the time since the state.
// Out: fields [2][n][n] float2: h, dh/dt, then dh/dx, dh/dz.
#include "ocean/wakes/wake_differences.clh"

__kernel void wake_differences(__global const float2 *restrict state, int size, float cell_m, float courant, float step_s,
                               float since_s, __global float2 *restrict fields) {
  int places[WAKE_STENCIL];
  wake_stencil((int)get_global_id(0), (int)get_global_id(1), size, places);
  float height[WAKE_STENCIL], second[WAKE_STENCIL];
  for (int i = 0; i < WAKE_STENCIL; ++i) {
    height[i] = state[places[i]].x;
    second[i] = state[places[i]].y;
  }
  const float rise_mps = -courant * wake_bend(second) / step_s;
  fields[places[0]] = (float2)(height[0] + since_s * rise_mps, rise_mps);
  // Of fourth order: (1, -8, 0, 8, -1) / 12.
  fields[places[0] + size * size] = (float2)(8.0f * (height[2] - height[1]) - (height[6] - height[5]),
                                             8.0f * (height[4] - height[3]) - (height[8] - height[7])) /
                                    (12.0f * cell_m);
}
