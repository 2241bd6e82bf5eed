// Second pass of the inverse transform and assembly of the surface: rows along x, eight real fields at once.
// In:  intermediate [cascades][5][n][2][FFT_PITCH] of ocean/spectrum_advance.cl.
// Out: displacement [cascades][n][n] float4 (dx m, h m, dz m, d dx/dz),
//      gradient     [cascades][n][n] float4 (dh/dx, dh/dz, d dx/dx, d dz/dz), row = z, column = x, at rest labels.
// (dx, dz) = -a D of the paper: crests sharpen for choppiness a > 0. With H = h(kx, kz) after the first pass:
//   dx = i a kx/k H, dz = i a kz/k H, slopes = i K H, d dx/dx = -a kx^2/k H, and so on. Lee & Lee 2007,
// eq. 6, 7 and 9 (O6, O7, O10).
#include "ocean/half_rows.clh"

#define FFT_ROW_LOAD(field, row, column, upper, re, im)                                                           \
  {                                                                                                               \
    const lanes kx = HALF_COLUMNS(column, upper) * wavenumber_step_radpm[batch];                                  \
    if ((field) == 0) { /* dx + i dz */                                                                           \
      LOAD_FIELD(chop, 5, 2, row, column, upper)                                                                  \
      LOAD_FIELD(chop_kz, 5, 3, row, column, upper)                                                               \
      pair_real_fields(-kx * chop_im, kx * chop_re, -chop_kz_im, chop_kz_re, upper, &re, &im);                    \
    } else if ((field) == 1) { /* h + i d dx/dz */                                                                \
      LOAD_FIELD(height, 5, 0, row, column, upper)                                                                \
      LOAD_FIELD(chop_kz, 5, 3, row, column, upper)                                                               \
      pair_real_fields(height_re, height_im, -kx * chop_kz_re, -kx * chop_kz_im, upper, &re, &im);                \
    } else if ((field) == 2) { /* dh/dx + i dh/dz */                                                              \
      LOAD_FIELD(height, 5, 0, row, column, upper)                                                                \
      LOAD_FIELD(height_kz, 5, 1, row, column, upper)                                                             \
      pair_real_fields(-kx * height_im, kx * height_re, -height_kz_im, height_kz_re, upper, &re, &im);            \
    } else { /* d dx/dx + i d dz/dz */                                                                            \
      LOAD_FIELD(chop, 5, 2, row, column, upper)                                                                  \
      LOAD_FIELD(chop_kz_kz, 5, 4, row, column, upper)                                                            \
      pair_real_fields(-kx * kx * chop_re, -kx * kx * chop_im, -chop_kz_kz_re, -chop_kz_kz_im, upper, &re, &im);  \
    }                                                                                                             \
  }

#define FFT_ROW_STORE(row, column, re, im)                                                   \
  {                                                                                          \
    const size_t place = (((size_t)batch * FFT_SIZE + (row)) * FFT_SIZE + (column)) * 4;     \
    store_interleaved_4(re[0], re[1], im[0], im[1], displacement + place);                   \
    store_interleaved_4(re[2], im[2], re[3], im[3], gradient + place);                       \
  }

#define FFT_ROW_KERNEL surface_assemble
#define FFT_ROW_PARAMETERS                                                                      \
  __global const float *restrict wavenumber_step_radpm, __global float *restrict displacement, \
      __global float *restrict gradient
#define FFT_ROW_FIELDS 4
#include "fft/rows.clh"
