// Second pass of the plain batched transform.
// In:  intermediate [batch][N][2][FFT_PITCH] of fft/transform_columns.cl.
// Out: output [batch][N][N][2] float, row-major, interleaved complex.
#include "simd/lanes.clh"

#if LANES == 1
#define TRANSFORM_JOIN(first, second, target) \
  target[0] = first;                          \
  target[1] = second;
#else
#define TRANSFORM_JOIN(first, second, target)           \
  store_result(interleave_low(first, second), target); \
  store_result(interleave_high(first, second), target + LANES);
#endif

#define TRANSFORM_STORE(row, column, first, second)                                                         \
  {                                                                                                         \
    __global float *target = output + (((size_t)batch * FFT_SIZE + (row)) * FFT_SIZE + (column)) * 2;       \
    TRANSFORM_JOIN(first, second, target)                                                                   \
  }
#ifdef FFT_FORWARD
#define FFT_ROW_STORE(row, column, re, im) TRANSFORM_STORE(row, column, im[0], re[0])
#else
#define FFT_ROW_STORE(row, column, re, im) TRANSFORM_STORE(row, column, re[0], im[0])
#endif

#define FFT_ROW_PREFETCH(row, column)                               \
  {                                                                 \
    prefetch_line(intermediate + FFT_INTERMEDIATE(batch, row, column));             \
    prefetch_line(intermediate + FFT_INTERMEDIATE(batch, row, column) + FFT_PITCH); \
  }
#define FFT_ROW_LOAD(field, row, column, upper, re, im)                                  \
  {                                                                                      \
    __global const float *source = intermediate + FFT_INTERMEDIATE(batch, row, column);  \
    re = load_lanes(source);                                                             \
    im = load_lanes(source + FFT_PITCH);                                                 \
  }
#define FFT_ROW_KERNEL transform_rows
#define FFT_ROW_PARAMETERS __global float *restrict output
#define FFT_ROW_FIELDS 1
#include "fft/rows.clh"
