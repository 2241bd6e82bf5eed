// Second pass of the inverse transform for particle velocity: columns along z.
// In:  intermediate [cascades][3][n/16][rows + 1][2][16] of ocean/velocity_advance.cl.
// Out: velocity [cascades][n][n] float4 (vx, vy, vz, 0) m/s, row = z, column = x, at rest labels.
#include "ocean/half_columns.clh"

#define FFT_COLUMN_LOAD(field, row, upper, column, re, im)                                              \
  {                                                                                                     \
    const int half_row = HALF_ROW(row, upper);                                                          \
    const float kz = (float)half_row * wavenumber_step_radpm[batch];                                    \
    if ((field) == 0) { /* vx + i vz */                                                                 \
      LOAD_FIELD(speed_kx, 3, 1)                                                                        \
      LOAD_FIELD(speed, 3, 2)                                                                           \
      pair_real_fields(-speed_kx_im, speed_kx_re, -kz * speed_im, kz * speed_re, upper, &re, &im);      \
    } else { /* vy */                                                                                   \
      LOAD_FIELD(vertical, 3, 0)                                                                        \
      pair_real_fields(vertical_re, vertical_im, (lanes)0.0f, (lanes)0.0f, upper, &re, &im);            \
    }                                                                                                   \
  }

#define FFT_COLUMN_STORE(row, column, re, im)                                                \
  {                                                                                          \
    const size_t place = (((size_t)batch * FFT_SIZE + (row)) * FFT_SIZE + (column)) * 4;     \
    store_interleaved_4(re[0], re[1], im[0], (lanes)0.0f, velocity + place);                 \
  }

#define FFT_COLUMN_KERNEL velocity_assemble
#define FFT_COLUMN_PARAMETERS \
  __global const float *restrict wavenumber_step_radpm, __global float *restrict velocity
#define FFT_COLUMN_FIELDS 2
#include "fft/columns.clh"
