// Where the modes of one cascade lie in memory, the same on host and device.
// A plane is [columns/16][n][16]: strips of 16 columns kx >= 0, in which the rows of a strip are neighbours,
// because the first pass of the transform reads them from top to bottom.
#ifndef OFFING_KERNELS_SHARED_MODE_LAYOUT_H
#define OFFING_KERNELS_SHARED_MODE_LAYOUT_H

#ifdef __OPENCL_VERSION__
#define OFFING_LAYOUT_INLINE static inline
#else
#include <stddef.h>
#define OFFING_LAYOUT_INLINE inline
#endif

#define MODE_BLOCK_COLUMNS 16

// Place in a plane of mode (row, column), of `size` rows.
OFFING_LAYOUT_INLINE size_t mode_place(int row, int column, int size) {
  const size_t strip = column / MODE_BLOCK_COLUMNS;
  return (strip * size + row) * MODE_BLOCK_COLUMNS + column % MODE_BLOCK_COLUMNS;
}

// Values in a plane of `columns` columns, a multiple of 16.
OFFING_LAYOUT_INLINE size_t mode_plane_size(int columns, int size) {
  const size_t rows = size;
  return rows * columns;
}

#endif
