// Second pass of the plain batched transform.
// In:  intermediate [batch][N][2][FFT_PITCH] of fft/transform_columns.cl.
// Out: output [batch][N][N][2] float, row-major, interleaved complex.
#include "fft/one_field.clh"

#define TRANSFORM_STORE(row, column, first, second)                                                         \
  {                                                                                                         \
    __global float *target = output + (((size_t)batch * FFT_SIZE + (row)) * FFT_SIZE + (column)) * 2;       \
    FIELD_JOIN(first, second, target)                                                                       \
  }
#ifdef FFT_FORWARD
#define FFT_ROW_STORE(row, column, re, im) TRANSFORM_STORE(row, column, im[0], re[0])
#else
#define FFT_ROW_STORE(row, column, re, im) TRANSFORM_STORE(row, column, re[0], im[0])
#endif

#define FFT_ROW_KERNEL transform_rows
#define FFT_ROW_PARAMETERS __global float *restrict output
#include "fft/rows.clh"
