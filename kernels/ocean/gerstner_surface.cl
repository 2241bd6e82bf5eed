// Gerstner waves and rings on a regular grid of rest labels.
// In:  turns, amplitudes of the waves, rings and grid (shared/gerstner_params.h); time as ocean/wave_phase.clh has it.
// Out: displacement [rows][pitch] float4 (dx m, h m, dz m, d dx/dz),
//      gradient     [rows][pitch] float4 (dh/dx, dh/dz, d dx/dx, d dz/dz), row = z, column = x, at rest labels: the layout
//      of ocean/surface_assemble.cl, so that both parts of the sea add before F is taken (O9).
// With phase p = K X - w t of each wave: h = A cos p, (dx, dz) = -Q A K/k sin p, which sharpens crests. Lee & Lee 2007,
// eq. 8, up to phase (O8). Phases are whole numbers of 2^-32 turns, exact from sample to sample.
#include "ocean/gerstner_ring.clh"

// What a vector of samples adds up, in the order of GERSTNER_HEIGHT ... GERSTNER_SLOPE_Z.
typedef struct {
  lanes field[GERSTNER_FIELDS];
} Sums;

// Adds the rings to LANES samples and stores them.
INLINE void finish_samples(__global const GerstnerRing *rings, const GerstnerGrid *grid, int row, int column, Sums *sums,
                               __global float *displacement, __global float *gradient) {
  const lanes x_m = ((float)column + LANE_INDEX) * grid->spacing_x_m;
  const lanes z_m = (lanes)((float)row * grid->spacing_z_m);
  for (int i = 0; i < grid->ring_count; ++i) {
    add_ring(rings + i, x_m - rings[i].centre_x_m, z_m - rings[i].centre_z_m, sums->field + GERSTNER_HEIGHT,
             sums->field + GERSTNER_SLOPE_X, sums->field + GERSTNER_SLOPE_Z);
  }
  const lanes *field = sums->field;
  const size_t place = ((size_t)row * grid->pitch + column) * 4;
  store_interleaved_4(field[GERSTNER_SHIFT_X], field[GERSTNER_HEIGHT], field[GERSTNER_SHIFT_Z], field[GERSTNER_GRADIENT_XZ],
                      displacement + place);
  store_interleaved_4(field[GERSTNER_SLOPE_X], field[GERSTNER_SLOPE_Z], field[GERSTNER_GRADIENT_XX],
                      field[GERSTNER_GRADIENT_ZZ], gradient + place);
}

// Phase at the first sample of a row, of LANES waves from `wave` on.
INLINE uint_lanes row_phase(__global const uint *turns, const GerstnerGrid *grid, int wave, int row, uint ticks,
                                float tick_fraction) {
  __global const uint *first = turns + wave;
  const uint_lanes rate = load_uint_lanes(first + GERSTNER_RATE * grid->wave_pitch);
  return load_uint_lanes(first + GERSTNER_PHASE * grid->wave_pitch) +
         (uint)row * load_uint_lanes(first + GERSTNER_ROW_STEP * grid->wave_pitch) -
         turns_since(rate, ticks, tick_fraction);
}

#if LANES > 1

// On a CPU a work-item computes whole rows, in blocks of columns that mirror about their middle. There, with q the phase
// in the middle and d the turns from it to a column,
//   cos(q +- d) = cos q cos d -+ sin q sin d,   sin(q +- d) = sin q cos d +- cos q sin d:
// cos d and sin d are the same for every block, cos q and sin q for all columns of one, so that a field of a sample costs
// one multiplication a wave: half the sum over cos d and sin d that it shares with its mirror image. (Where the step of a
// column is odd, its half is not whole, and the left side is off by 2^-32 turns.)
#define BLOCK_COLUMNS (2 * GERSTNER_HALF_VECTORS * LANES)

// cos d and sin d of each wave, [wave][vector].
typedef struct {
  lanes cosine[GERSTNER_WAVES * GERSTNER_HALF_VECTORS], sine[GERSTNER_WAVES * GERSTNER_HALF_VECTORS];
} Offsets;

// What fields are times cos d (even about the middle) and sin d (odd), [field][wave].
typedef struct {
  float even[GERSTNER_FIELDS * GERSTNER_WAVES], odd[GERSTNER_FIELDS * GERSTNER_WAVES];
} Middle;

INLINE void compute_offsets(__global const uint *turns, const GerstnerGrid *grid, Offsets *offsets) {
  for (int wave = 0; wave < grid->wave_count; ++wave) {
    const uint step = turns[GERSTNER_COLUMN_STEP * grid->wave_pitch + wave];
    const uint half_step = as_uint(as_int(step) >> 1);
    UNROLL for (int v = 0; v < GERSTNER_HALF_VECTORS; ++v) {
      const uint_lanes columns = convert_uint_lanes(LANE_INDEX) + (uint)(v * LANES);
      const int place = wave * GERSTNER_HALF_VECTORS + v;
      cosine_sine_of_turns(columns * step + half_step, offsets->cosine + place, offsets->sine + place);
    }
  }
}

// LANES waves at a time.
INLINE void compute_middle(__global const uint *turns, __global const float *amplitudes, const GerstnerGrid *grid,
                               int row, int first_column, uint ticks, float tick_fraction, Middle *middle) {
  for (int wave = 0; wave < grid->wave_count; wave += LANES) {
    const uint_lanes step = load_uint_lanes(turns + GERSTNER_COLUMN_STEP * grid->wave_pitch + wave);
    const uint_lanes half_step = as_uint_lanes(as_int_lanes(step) >> 1);
    lanes cosine, sine;
    cosine_sine_of_turns(row_phase(turns, grid, wave, row, ticks, tick_fraction) +
                             (uint)(first_column + BLOCK_COLUMNS / 2) * step - half_step,
                         &cosine, &sine);
    UNROLL for (int f = 0; f < GERSTNER_FIELDS; ++f) {
      const lanes amplitude = load_lanes(amplitudes + f * grid->wave_pitch + wave);
      const bool of_cosine = f < GERSTNER_COSINE_FIELDS;
      store_lanes(amplitude * (of_cosine ? cosine : sine), middle->even + f * GERSTNER_WAVES + wave);
      store_lanes(amplitude * (of_cosine ? -sine : cosine), middle->odd + f * GERSTNER_WAVES + wave);
    }
  }
}

// Vector `v` to the right of the middle, and its mirror image to the left.
INLINE void sum_waves(const Offsets *offsets, const Middle *middle, int wave_count, int v, Sums *right, Sums *left) {
  lanes even[GERSTNER_FIELDS], odd[GERSTNER_FIELDS];
  UNROLL for (int f = 0; f < GERSTNER_FIELDS; ++f) even[f] = odd[f] = (lanes)0.0f;
  for (int wave = 0; wave < wave_count; ++wave) {
    const int place = wave * GERSTNER_HALF_VECTORS + v;
    const lanes cosine = offsets->cosine[place], sine = offsets->sine[place];
    UNROLL for (int f = 0; f < GERSTNER_FIELDS; ++f) {
      even[f] += middle->even[f * GERSTNER_WAVES + wave] * cosine;
      odd[f] += middle->odd[f * GERSTNER_WAVES + wave] * sine;
    }
  }
  UNROLL for (int f = 0; f < GERSTNER_FIELDS; ++f) {
    right->field[f] = even[f] + odd[f];
    left->field[f] = reverse_lanes(even[f] - odd[f]);
  }
}

#endif

__kernel void gerstner_surface(__global const uint *restrict turns, __global const float *restrict amplitudes,
                               __global const GerstnerRing *restrict rings, GerstnerGrid grid, uint ticks,
                               float tick_fraction, __global float *restrict displacement,
                               __global float *restrict gradient) {
#if LANES == 1
  const int row = (int)get_global_id(1), column = (int)get_global_id(0);
  Sums sums;
  UNROLL for (int f = 0; f < GERSTNER_FIELDS; ++f) sums.field[f] = 0.0f;
  for (int wave = 0; wave < grid.wave_count; ++wave) {
    const uint step = turns[GERSTNER_COLUMN_STEP * grid.wave_pitch + wave];
    float cosine, sine;
    cosine_sine_of_turns(row_phase(turns, &grid, wave, row, ticks, tick_fraction) + (uint)column * step, &cosine, &sine);
    UNROLL for (int f = 0; f < GERSTNER_FIELDS; ++f) {
      sums.field[f] += amplitudes[f * grid.wave_pitch + wave] * (f < GERSTNER_COSINE_FIELDS ? cosine : sine);
    }
  }
  finish_samples(rings, &grid, row, column, &sums, displacement, gradient);
#else
  Offsets offsets;
  Middle middle;
  compute_offsets(turns, &grid, &offsets);
  const int items = (int)get_global_size(0), item = (int)get_global_id(0);
  const int first_row = item * grid.rows / items, last_row = (item + 1) * grid.rows / items;
  for (int row = first_row; row < last_row; ++row) {
    for (int start = 0; start < grid.pitch; start += BLOCK_COLUMNS) {
      // The last block of a row moves back to end with it: some samples are computed twice, by the same work-item.
      const int first = min(start, grid.pitch - BLOCK_COLUMNS);
      compute_middle(turns, amplitudes, &grid, row, first, ticks, tick_fraction, &middle);
      for (int v = 0; v < GERSTNER_HALF_VECTORS; ++v) {
        Sums right, left;
        sum_waves(&offsets, &middle, grid.wave_count, v, &right, &left);
        const int right_column = first + BLOCK_COLUMNS / 2 + v * LANES;
        const int left_column = first + BLOCK_COLUMNS / 2 - (v + 1) * LANES;
        finish_samples(rings, &grid, row, right_column, &right, displacement, gradient);
        finish_samples(rings, &grid, row, left_column, &left, displacement, gradient);
      }
    }
  }
#endif
}
