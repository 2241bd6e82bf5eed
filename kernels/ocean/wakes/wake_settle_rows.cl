// Last pass of a step of a wake window, after the inverse transform's columns (fft/transform_columns.cl): back to heights above the
// mean level, and what its border absorbs.
// In:  intermediate; grid; displaced [n][n] m as ocean/wakes/wake_press_columns.cl had it; kept [2][n]: share that a column or row
//      of the window keeps in a step, twice, so that LANES columns lie side by side wherever the window begins.
// Out: state [n][n] float2: height m, second field m.
#include "fft/one_field.clh"
#include "ocean/wakes/wake_place.clh"

#define FFT_ROW_STORE(row, column, re, im)                                                                 \
  {                                                                                                        \
    const size_t place = (size_t)(row) * FFT_SIZE + (column);                                              \
    const lanes share = kept[wake_window_place(row, grid.first_row, FFT_SIZE)] *                           \
                        load_lanes(kept + wake_window_place(column, grid.first_column, FFT_SIZE));         \
    const lanes height = share * (re[0] - load_lanes(displaced + place));                                  \
    const lanes second = share * im[0];                                                                    \
    FIELD_JOIN(height, second, state + 2 * place)                                                          \
  }
#define FFT_ROW_KERNEL wake_settle_rows
#define FFT_ROW_PARAMETERS                                                                    \
  WakeGrid grid, __global const float *restrict displaced, __global const float *restrict kept, \
      __global float *restrict state
#include "fft/rows.clh"
