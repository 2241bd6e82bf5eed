// Random amplitudes of one cascade's modes, ready to be advanced.
// In:  variance [n][n] m^2, row-major, K = 0 at [0][0] (ocean/mode_variance.cl); seed, and the cascade as stream.
// Out: amplitude [4][columns/16][n][16] m, columns 0 ... n/2 - 1 (kx >= 0; the others follow by symmetry; further columns are
//      zero): P and Q, real and imaginary, with h(K, t) = P cos(w t) + Q sin(w t), that is
//      P = h0(K) + conj(h0(-K)), Q = -i (h0(K) - conj(h0(-K))).
// h0 = (xr + i xi)/2 sqrt(variance), x independent N(0, 1) of (seed, cascade, n, m): the same waves at every size of the
// same patch. Wave K travels toward +K. Lee & Lee 2007, eq. 2 and 4, corrected (O2, O4).
#include "shared/mode_layout.h"
#include "shared/random.h"

// Smaller amplitudes, in m, become zero: denormal numbers would halve the speed of every frame.
#define SMALLEST_AMPLITUDE_M 1e-20f

static float2 initial_amplitude(__global const float *variance, int size, int n, int m, uint2 seed, int cascade) {
  const int column = n & (size - 1), row = m & (size - 1);
  const PhiloxBlock block =
      philox_block(seed.x, seed.y, OFFING_STREAM_OCEAN_CASCADE + (uint)cascade, n, m, 0u);
  // Box & Muller 1958
  const float radius = sqrt(-2.0f * log(uniform_open01(block.v[0])));
  const float turn = 2.0f * uniform_open01(block.v[1]);
  const float scale = 0.5f * sqrt(variance[(size_t)row * size + column]) * radius;
  return (float2)(scale * cospi(turn), scale * sinpi(turn));
}

__kernel void spectrum_initial(__global const float *restrict variance, int size, uint2 seed, int cascade,
                               __global float *restrict amplitude, int columns) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1);
  const int m = row < size / 2 ? row : row - size;
  const size_t plane = mode_plane_size(columns, size);
  const size_t place = cascade * 4 * plane + mode_place(row, column, size);
  float2 p = (float2)(0.0f, 0.0f), q = p;
  if (column < size / 2 && m != -size / 2) {
    const float2 forward = initial_amplitude(variance, size, column, m, seed, cascade);
    const float2 backward = initial_amplitude(variance, size, -column, -m, seed, cascade);
    if (fabs(forward.x) + fabs(forward.y) + fabs(backward.x) + fabs(backward.y) > SMALLEST_AMPLITUDE_M) {
      p = (float2)(forward.x + backward.x, forward.y - backward.y);
      const float2 difference = (float2)(forward.x - backward.x, forward.y + backward.y);
      q = (float2)(difference.y, -difference.x);
    }
  }
  amplitude[place] = p.x;
  amplitude[place + plane] = p.y;
  amplitude[place + 2 * plane] = q.x;
  amplitude[place + 3 * plane] = q.y;
}
