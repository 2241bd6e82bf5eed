// Last pass of a step of a wake window: the inverse transform's columns, back to heights above the mean level, and what the
// border absorbs.
// In:  grid; displaced [n][n] m as ocean/wakes/wake_press_columns.cl had it; kept [2][n]: share that a column or row of the
//      window keeps in a step, twice, so that LANES columns lie side by side wherever the window begins; intermediate of
//      ocean/wakes/wake_turn_rows.cl.
// Out: state [n][n] float2: height m, second field m.
#include "fft/one_field.clh"
#include "ocean/wakes/wake_place.clh"

#define FFT_COLUMN_LOAD(field, slot, row, column, re, im) FFT_LOAD_INTERMEDIATE(batch, row, column, re, im)
#define FFT_COLUMN_STORE(field, row, column, re, im)                                               \
  {                                                                                                \
    const size_t place = (size_t)(row) * FFT_SIZE + (column);                                      \
    const lanes share = kept[wake_window_place(row, grid.first_row, FFT_SIZE)] *                   \
                        load_lanes(kept + wake_window_place(column, grid.first_column, FFT_SIZE)); \
    const lanes height = share * (re - load_lanes(displaced + place));                             \
    const lanes second = share * im;                                                               \
    FIELD_JOIN(height, second, state + 2 * place)                                                  \
  }
#define FFT_COLUMN_PREFETCH(row, column) prefetch_line(displaced + (size_t)(row) * FFT_SIZE + (column));
#define FFT_COLUMN_KERNEL wake_settle_columns
#define FFT_COLUMN_PARAMETERS                                                                   \
  WakeGrid grid, __global const float *restrict displaced, __global const float *restrict kept, \
      __global float *restrict state
#include "fft/columns.clh"
