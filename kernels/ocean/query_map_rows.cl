// Fields on a finer grid, second pass of the inverse transform: rows along x, MAP_FIELDS real fields at once.
// In:  intermediate [cascades][MAP_FIELDS][n][2][FFT_PITCH] of ocean/query_map_columns.cl; inverse_scales [cascades][8]: what
//      fields are multiplied by to become shorts, with derivatives in cycles.
// Out: map [cascades][n][n + QUERY_MAP_HALO][MAP_FIELDS] shorts, fields of shared/query_params.h, row = z, column = x, at rest
//      labels; the first columns again at the end of a row. Devices have little-endian memory.
#include "ocean/half_rows.clh"
#include "shared/query_params.h"
#include "simd/lane_masks.clh"

#define FFT_ROW_LOAD(field, row, column, upper, re, im)                                        \
  {                                                                                            \
    re = (lanes)0.0f;                                                                          \
    im = (lanes)0.0f;                                                                          \
    if ((upper) ? (column) >= FFT_SIZE - SPECTRUM_COLUMNS : (column) < SPECTRUM_COLUMNS) {     \
      LOAD_FIELD(first, MAP_FIELDS, 2 * (field), row, column, upper)                           \
      LOAD_FIELD(second, MAP_FIELDS, 2 * (field) + 1, row, column, upper)                      \
      if ((field) == 0) { /* dx + i dz */                                                      \
        const lanes kx = HALF_COLUMNS(column, upper);                                          \
        pair_real_fields(-kx * first_im, kx * first_re, -second_im, second_re, upper, &re, &im); \
      } else {                                                                                 \
        pair_real_fields(first_re, first_im, second_re, second_im, upper, &re, &im);           \
      }                                                                                        \
    }                                                                                          \
  }

INLINE lanes short_pair(lanes low, lanes high) {
  const lanes largest = (lanes)(float)QUERY_MAP_LARGEST;
  const int_lanes low_int = convert_int_lanes(rint(least(most(low, -largest), largest)));
  const int_lanes high_int = convert_int_lanes(rint(least(most(high, -largest), largest)));
  return as_lanes((high_int << 16) | (low_int & 0xffff));
}

#define SHORTS(field) \
  short_pair(re[field] * inverse[2 * (field)], im[field] * inverse[2 * (field) + 1])

// The pairs travel as floats that nobody computes with.
#if MAP_FIELDS == QUERY_MAP_FIELDS
#define STORE_TEXELS(target) store_interleaved_4(SHORTS(0), SHORTS(1), SHORTS(2), SHORTS(3), target)
#else
#define STORE_TEXELS(target) store_interleaved_2(SHORTS(0), SHORTS(1), target)
#endif

#define FFT_ROW_STORE(row, column, re, im)                                                              \
  {                                                                                                     \
    const size_t texel = ((size_t)batch * FFT_SIZE + (row)) * (FFT_SIZE + QUERY_MAP_HALO) + (column);   \
    __global const float *inverse = inverse_scales + batch * QUERY_MAP_FIELDS;                          \
    STORE_TEXELS(map + texel * (MAP_FIELDS / 2));                                                       \
    if ((column) < QUERY_MAP_HALO / 2) STORE_TEXELS(map + (texel + FFT_SIZE) * (MAP_FIELDS / 2));       \
  }

#define FFT_ROW_KERNEL query_map_rows
#define FFT_ROW_PARAMETERS __global const float *restrict inverse_scales, __global float *restrict map
#define FFT_ROW_FIELDS (MAP_FIELDS / 2)
#include "fft/rows.clh"
