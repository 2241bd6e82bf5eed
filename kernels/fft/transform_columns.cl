// First pass of the plain batched transform: columns of interleaved complex values.
// In:  input [batch][N][N][2] float, row-major.
// Out: intermediate [batch][N][2][FFT_PITCH], columns transformed along z.
// -DFFT_FORWARD exchanges real and imaginary parts at both ends: a forward transform (e^{-i}).
#include "simd/lanes.clh"

#if LANES == 1
#define TRANSFORM_SPLIT(source, first, second) \
  first = source[0];                           \
  second = source[1];
#else
#define TRANSFORM_SPLIT(source, first, second)                                       \
  const lanes low = load_lanes(source), high = load_lanes(source + LANES);           \
  first = (lanes)(low.even, high.even);                                              \
  second = (lanes)(low.odd, high.odd);
#endif

#define TRANSFORM_INPUT(row, column) (input + (((size_t)batch * FFT_SIZE + (row)) * FFT_SIZE + (column)) * 2)
#define TRANSFORM_LOAD(row, column, first, second)                    \
  {                                                                   \
    __global const float *source = TRANSFORM_INPUT(row, column);      \
    TRANSFORM_SPLIT(source, first, second)                            \
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
#define FFT_COLUMN_FIELDS 1
#define FFT_COLUMN_STATE
#define FFT_COLUMN_PREPARE(slot, row, column)
#include "fft/columns.clh"
