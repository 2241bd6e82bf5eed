// First pass of the plain batched transform: columns of interleaved complex values.
// In:  input [batch][N][N][2] float, row-major.
// Out: intermediate [batch][N][2][FFT_PITCH], columns transformed along z.
// -DFFT_FORWARD exchanges real and imaginary parts at both ends: a forward transform (e^{-i}).
#include "fft/one_field.clh"

#define TRANSFORM_INPUT(row, column) (input + (((size_t)batch * FFT_SIZE + (row)) * FFT_SIZE + (column)) * 2)
#define TRANSFORM_LOAD(row, column, first, second)                    \
  {                                                                   \
    __global const float *source = TRANSFORM_INPUT(row, column);      \
    FIELD_SPLIT(source, first, second)                                \
  }
// Rows lie a power of two apart, which processors' own prefetchers do not follow.
#define FFT_COLUMN_PREFETCH(row, column)                \
  {                                                     \
    prefetch_line(TRANSFORM_INPUT(row, column));        \
    prefetch_line(TRANSFORM_INPUT(row, column) + LANES); \
  }
#ifdef FFT_FORWARD
#define FFT_COLUMN_LOAD(field, slot, row, column, re, im) TRANSFORM_LOAD(row, column, im, re)
#else
#define FFT_COLUMN_LOAD(field, slot, row, column, re, im) TRANSFORM_LOAD(row, column, re, im)
#endif

#define FFT_COLUMN_KERNEL transform_columns
#define FFT_COLUMN_PARAMETERS __global const float *restrict input
#include "fft/columns.clh"
