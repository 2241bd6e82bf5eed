// First pass of a step of a wake window, the forward transform's: columns of its water, from the level that it would rest at under
// what presses it.
// In:  state [n][n] float2 of ocean/wakes/wake_settle_columns.cl; displaced [n][n] m of ocean/wakes/wake_displace.cl.
// Out: intermediate [n][2][FFT_PITCH], columns transformed along z.
#include "fft/one_field.clh"

#define STATE_AT(row, column) (state + ((size_t)(row) * FFT_SIZE + (column)) * 2)
// Real and imaginary parts exchanged: a forward transform.
#define FFT_COLUMN_LOAD(field, slot, row, column, re, im)               \
  {                                                                     \
    FIELD_SPLIT(STATE_AT(row, column), im, re)                          \
    im += load_lanes(displaced + (size_t)(row) * FFT_SIZE + (column));  \
  }
// Rows lie a power of two apart, which processors' own prefetchers do not follow.
#define FFT_COLUMN_PREFETCH(row, column)                                     \
  {                                                                          \
    prefetch_line(STATE_AT(row, column));                                    \
    prefetch_line(STATE_AT(row, column) + LANES);                            \
    prefetch_line(displaced + (size_t)(row) * FFT_SIZE + (column));          \
  }
#define FFT_COLUMN_KERNEL wake_press_columns
#define FFT_COLUMN_PARAMETERS __global const float *restrict state, __global const float *restrict displaced
#include "fft/columns.clh"
