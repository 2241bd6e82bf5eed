// Second pass of the inverse transform and assembly of the surface: columns along z, eight real fields at once.
// In:  intermediate [cascades][5][n/16][rows + 1][2][16] of ocean/spectrum_advance.cl.
// Out: displacement [cascades][n][n] float4 (dx m, h m, dz m, d dx/dz),
//      gradient     [cascades][n][n] float4 (dh/dx, dh/dz, d dx/dx, d dz/dz), row = z, column = x, at rest labels.
// (dx, dz) = -a D of the paper: crests sharpen for choppiness a > 0. With H = h(kx, kz) after the first pass:
//   dx = i a kx/k H, dz = i a kz/k H, slopes = i K H, d dx/dx = -a kx^2/k H, and so on. PAPERS O6, O7, O10.
#include "ocean/half_columns.clh"

#define FFT_COLUMN_LOAD(field, row, upper, column, re, im)                                                        \
  {                                                                                                               \
    const int half_row = HALF_ROW(row, upper);                                                                    \
    const float kz = (float)half_row * wavenumber_step_radpm[batch];                                              \
    if ((field) == 0) { /* dx + i dz */                                                                           \
      LOAD_FIELD(chop_kx, 5, 3)                                                                                        \
      LOAD_FIELD(chop, 5, 2)                                                                                           \
      pair_real_fields(-chop_kx_im, chop_kx_re, -kz * chop_im, kz * chop_re, upper, &re, &im);                    \
    } else if ((field) == 1) { /* h + i d dx/dz */                                                                \
      LOAD_FIELD(height, 5, 0)                                                                                         \
      LOAD_FIELD(chop_kx, 5, 3)                                                                                        \
      pair_real_fields(height_re, height_im, -kz * chop_kx_re, -kz * chop_kx_im, upper, &re, &im);                \
    } else if ((field) == 2) { /* dh/dx + i dh/dz */                                                              \
      LOAD_FIELD(height_kx, 5, 1)                                                                                      \
      LOAD_FIELD(height, 5, 0)                                                                                         \
      pair_real_fields(-height_kx_im, height_kx_re, -kz * height_im, kz * height_re, upper, &re, &im);            \
    } else { /* d dx/dx + i d dz/dz */                                                                            \
      LOAD_FIELD(chop_kx_kx, 5, 4)                                                                                     \
      LOAD_FIELD(chop, 5, 2)                                                                                           \
      pair_real_fields(-chop_kx_kx_re, -chop_kx_kx_im, -kz * kz * chop_re, -kz * kz * chop_im, upper, &re, &im);  \
    }                                                                                                             \
  }

#define FFT_COLUMN_STORE(row, column, re, im)                                                    \
  {                                                                                              \
    const size_t place = (((size_t)batch * FFT_SIZE + (row)) * FFT_SIZE + (column)) * 4;         \
    store_interleaved_4(re[0], re[1], im[0], im[1], displacement + place);                       \
    store_interleaved_4(re[2], im[2], re[3], im[3], gradient + place);                           \
  }

#define FFT_COLUMN_KERNEL surface_assemble
#define FFT_COLUMN_PARAMETERS                                                                   \
  __global const float *restrict wavenumber_step_radpm, __global float *restrict displacement, \
      __global float *restrict gradient
#define FFT_COLUMN_FIELDS 4
#include "fft/columns.clh"
