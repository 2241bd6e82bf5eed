// Second pass of the plain batched transform.
// In:  intermediate [batch][N/16][N][2][16] of fft/transform_rows.cl.
// Out: output [batch][N][N][2] float, row-major, interleaved complex.
#include "fft/lanes.clh"

#ifdef FFT_FORWARD
#define FFT_COLUMN_STORE(row, column, re, im) TRANSFORM_STORE(row, column, im[0], re[0])
#else
#define FFT_COLUMN_STORE(row, column, re, im) TRANSFORM_STORE(row, column, re[0], im[0])
#endif

#if LANES == 1
#define TRANSFORM_STORE(row, column, first, second)                                                  \
  {                                                                                                  \
    __global float *target = output + (((size_t)batch * FFT_SIZE + (row)) * FFT_SIZE + (column)) * 2; \
    target[0] = first;                                                                               \
    target[1] = second;                                                                              \
  }
#else
#define TRANSFORM_STORE(row, column, first, second)                                                  \
  {                                                                                                  \
    __global float *target = output + (((size_t)batch * FFT_SIZE + (row)) * FFT_SIZE + (column)) * 2; \
    stream_lanes(interleave_low(first, second), target);                                             \
    stream_lanes(interleave_high(first, second), target + LANES);                                    \
  }
#endif

#define FFT_COLUMN_LOAD(field, row, upper, column, re, im)                           \
  {                                                                                  \
    __global const float *source = intermediate + FFT_INTERMEDIATE(batch, row, column); \
    re = load_lanes(source);                                                         \
    im = load_lanes(source + FFT_BLOCK);                                             \
  }
#define FFT_COLUMN_KERNEL transform_columns
#define FFT_COLUMN_PARAMETERS __global float *restrict output
#define FFT_COLUMN_FIELDS 1
#include "fft/columns.clh"
