// Second pass of the inverse transform for particle velocity and pressure head: rows along x.
// In:  intermediate [cascades][4][n][2][FFT_PITCH] of ocean/velocity_advance.cl.
// Out: velocity [cascades][n][n] float4 (vx, vy, vz m/s, head m), row = z, column = x, at rest labels.
#include "ocean/half_rows.clh"

#define FFT_ROW_LOAD(field, row, column, upper, re, im)                                             \
  {                                                                                                 \
    if ((field) == 0) { /* vx + i vz */                                                             \
      const lanes kx = HALF_COLUMNS(column, upper) * wavenumber_step_radpm[batch];                  \
      LOAD_FIELD(speed, 4, 1, row, column, upper)                                                   \
      LOAD_FIELD(speed_kz, 4, 2, row, column, upper)                                                \
      pair_real_fields(-kx * speed_im, kx * speed_re, -speed_kz_im, speed_kz_re, upper, &re, &im);  \
    } else { /* vy + i head */                                                                      \
      LOAD_FIELD(vertical, 4, 0, row, column, upper)                                                \
      LOAD_FIELD(head, 4, 3, row, column, upper)                                                    \
      pair_real_fields(vertical_re, vertical_im, head_re, head_im, upper, &re, &im);                \
    }                                                                                               \
  }

#define FFT_ROW_STORE(row, column, re, im)                                                   \
  {                                                                                          \
    const size_t place = (((size_t)batch * FFT_SIZE + (row)) * FFT_SIZE + (column)) * 4;     \
    store_interleaved_4(re[0], re[1], im[0], im[1], velocity + place);                       \
  }

#define FFT_ROW_KERNEL velocity_assemble
#define FFT_ROW_PARAMETERS \
  __global const float *restrict wavenumber_step_radpm, __global float *restrict velocity
#define FFT_ROW_FIELDS 2
#include "fft/rows.clh"
