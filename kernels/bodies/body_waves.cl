// What linear waves do to bodies besides the hydrostatic pressure below their surface: a work-group a body, of GROUP
// work-items, a power of two.
// In:  shapes, states [bodies], waves [sea.waves], all of shared/bodies.h; tables: as BodyShape says.
// Out: excitation [bodies][BODY_MOTIONS] N, N m in world axes about the mass centre, in the middle of the sub-steps.
// A hull that has heeled far has none: tables are of the hull upright.
#include "bodies/turn.clh"
#include "shared/bodies.h"
#include "shared/query_params.h"

#define TURN (1.0f / 4294967296.0f)

__kernel __attribute__((reqd_work_group_size(GROUP, 1, 1))) void body_waves(
    __global const BodyShape* restrict shapes, __global const BodyState* restrict states,
    __global const BodyWave* restrict waves, __global const float* restrict tables, const BodySea sea,
    __global float* restrict excitation) {
  __local float sums[BODY_MOTIONS][GROUP];
  const int lane = get_local_id(0);
  const size_t body = get_group_id(0);
  const BodyShape shape = shapes[body];
  const BodyState state = states[body];
  const float4 turn = (float4)(state.turn_x, state.turn_y, state.turn_z, state.turn_w);
  const float3 forward = turned(turn, (float3)(1.0f, 0.0f, 0.0f));
  const float upright = fmax(0.0f, turned(turn, (float3)(0.0f, 1.0f, 0.0f)).y);
  const float heading = atan2(forward.z, forward.x);
  const float x = state.x_m + sea.middle_s * state.velocity_x_mps, z = state.z_m + sea.middle_s * state.velocity_z_mps;
  float sum[BODY_MOTIONS];
  for (int i = 0; i < BODY_MOTIONS; ++i) sum[i] = 0.0f;
  const int count = shape.memory_samples > 0 ? sea.waves : 0;
  for (int n = lane; n < count; n += GROUP) {
    const BodyWave wave = waves[n];
    // Whole turns are lost as sums overflow, and nothing else.
    const uint turns = wave.phase + wave.phase_by_question * (uint)sea.question +
                       wave.phase_by_tile_x * (uint)state.tile_x + wave.phase_by_tile_z * (uint)state.tile_z;
    const float phase = 2.0f * M_PI_F * TURN * (float)(int)turns + wave.kx_radpm * x + wave.kz_radpm * z;
    const float rise = wave.amplitude_m * cos(phase), fall = wave.amplitude_m * sin(phase);
    const float row = wave.frequency_radps / shape.wave_step_radps - 1.0f;
    // Below the first frequency, pressures decay and hulls scatter as its square.
    const float long_share = row < 0.0f ? (row + 1.0f) * (row + 1.0f) : 1.0f;
    const float placed = clamp(row, 0.0f, (float)(BODY_WAVE_FREQUENCIES - 1));
    const int first = min((int)placed, BODY_WAVE_FREQUENCIES - 2);
    float around = (wave.direction_rad - heading) * (BODY_WAVE_DIRECTIONS / (2.0f * M_PI_F));
    around -= BODY_WAVE_DIRECTIONS * floor(around / BODY_WAVE_DIRECTIONS);
    const int side = min((int)around, BODY_WAVE_DIRECTIONS - 1), next = (side + 1) % BODY_WAVE_DIRECTIONS;
    const float up = placed - (float)first, on = around - (float)side;
    __global const float* table = tables + shape.first_wave_float;
    __global const float* low = table + BODY_WAVE_FLOATS * (BODY_WAVE_FREQUENCIES * side + first);
    __global const float* high = table + BODY_WAVE_FLOATS * (BODY_WAVE_FREQUENCIES * next + first);
    for (int i = 0; i < BODY_MOTIONS; ++i) {
      const int j = i + BODY_MOTIONS;
      const float real = mix(mix(low[i], low[BODY_WAVE_FLOATS + i], up), mix(high[i], high[BODY_WAVE_FLOATS + i], up), on);
      const float imaginary =
          mix(mix(low[j], low[BODY_WAVE_FLOATS + j], up), mix(high[j], high[BODY_WAVE_FLOATS + j], up), on);
      sum[i] += long_share * (real * rise - imaginary * fall);
    }
  }
  for (int i = 0; i < BODY_MOTIONS; ++i) sums[i][lane] = sum[i];
  for (int kept = GROUP / 2; kept > 0; kept /= 2) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (lane < kept) {
      for (int i = 0; i < BODY_MOTIONS; ++i) sums[i][lane] += sums[i][lane + kept];
    }
  }
  if (lane == 0) {
    const float ahead = upright * cos(heading), aside = upright * sin(heading);
    __global float* made = excitation + BODY_MOTIONS * body;
    for (int i = 0; i < BODY_MOTIONS; i += 3) {
      made[i] = ahead * sums[i][0] - aside * sums[i + 2][0];
      made[i + 1] = upright * sums[i + 1][0];
      made[i + 2] = aside * sums[i][0] + ahead * sums[i + 2][0];
    }
  }
}
