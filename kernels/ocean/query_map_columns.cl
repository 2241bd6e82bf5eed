// Fields of the modes on a finer grid, first pass of the inverse transform: columns along z, for kx >= 0 only.
// In:  fields [cascades][7][2][columns/16][MODE_ROWS][16] of ocean/mode_fields.cl; filter [MODE_ROWS/2 + 16]: what a wave of so
//      many cycles along a side is multiplied by, once for each axis.
// Out: intermediate [cascades][MAP_FIELDS][n][2][FFT_PITCH]: the first field, the same times kz in cycles, the others.
//      Modes beyond the MODE_ROWS of the fields are 0.
#include "shared/mode_layout.h"
#include "shared/query_params.h"
#include "simd/lanes.clh"

#define MODE_COLUMNS (MODE_ROWS / 2 < MODE_BLOCK_COLUMNS ? MODE_BLOCK_COLUMNS : MODE_ROWS / 2)

#define FFT_COLUMN_KERNEL query_map_columns
#define FFT_COLUMN_PARAMETERS __global const float *restrict fields, __global const float *restrict filter
#define FFT_COLUMN_FIELDS MAP_FIELDS
#define FFT_COLUMN_STATE const lanes column_filter = load_lanes(filter + column);
#define FFT_COLUMN_PREPARE(slot, row, column)
#define FFT_COLUMN_LOAD(field, slot, row, column, re, im)                                                   \
  {                                                                                                         \
    const int m = (row) < FFT_SIZE / 2 ? (row) : (row) - FFT_SIZE;                                          \
    re = (lanes)0.0f;                                                                                       \
    im = (lanes)0.0f;                                                                                       \
    if ((int)abs(m) < MODE_ROWS / 2) {                                                                      \
      const size_t plane = mode_plane_size(MODE_COLUMNS, MODE_ROWS);                                        \
      const int source_field = batch * QUERY_FIELDS + max((field) - 1, 0);                                  \
      __global const float *source =                                                                        \
          fields + (size_t)(2 * source_field) * plane + mode_place(m & (MODE_ROWS - 1), column, MODE_ROWS); \
      const lanes factor = ((field) == 1 ? (float)m : 1.0f) * filter[abs(m)] * column_filter;               \
      re = factor * load_lanes(source);                                                                     \
      im = factor * load_lanes(source + plane);                                                             \
    }                                                                                                       \
  }
#include "fft/columns.clh"
