// First pass of the plain batched transform: rows of interleaved complex values.
// In:  input [batch][N][N][2] float, row-major.
// Out: intermediate [batch][N/16][N][2][16], rows transformed along x.
// -DFFT_FORWARD exchanges real and imaginary parts at both ends: a forward transform (e^{-i}).
#include "fft/lanes.clh"

#ifdef FFT_FORWARD
#define FFT_ROW_LOAD(field, slot, row, column, re, im) TRANSFORM_LOAD(row, column, im, re)
#else
#define FFT_ROW_LOAD(field, slot, row, column, re, im) TRANSFORM_LOAD(row, column, re, im)
#endif

#if LANES == 1
#define TRANSFORM_LOAD(row, column, first, second)                                                   \
  {                                                                                                  \
    __global const float *source = input + (((size_t)batch * FFT_SIZE + (row)) * FFT_SIZE + (column)) * 2; \
    first = source[0];                                                                               \
    second = source[1];                                                                              \
  }
#else
#define TRANSFORM_LOAD(row, column, first, second)                                                   \
  {                                                                                                  \
    __global const float *source = input + (((size_t)batch * FFT_SIZE + (row)) * FFT_SIZE + (column)) * 2; \
    const lanes low = load_lanes(source), high = load_lanes(source + LANES);                         \
    first = (lanes)(low.even, high.even);                                                            \
    second = (lanes)(low.odd, high.odd);                                                             \
  }
#endif

#define FFT_ROW_KERNEL transform_rows
#define FFT_ROW_PARAMETERS __global const float *restrict input
#define FFT_ROW_FIELDS 1
#define FFT_ROW_STATE
#define FFT_ROW_PREPARE(slot, row, column)
#include "fft/rows.clh"
