// Second pass of a step of a wake window: the rest of the forward transform, the step of all modes, and the inverse
// transform's rows.
// In:    turn [n][n] float2: e^{-i omega dt}, with what the shortest waves lose in a step, over n^2.
// Inout: intermediate: columns of ocean/wakes/wake_press_columns.cl, transformed along z; then the stepped modes, transformed
//        back along x.
// With Z = h + i s, where s is the surface's potential times omega / g, linear water waves are dZ/dt = -i omega Z of each
// mode: dh/dt = omega s, ds/dt = -omega h, omega^2 = g k tanh k D (O3). A wave that travels toward +K has all of its
// energy, |Z|^2, at K.
#include "fft/one_field.clh"

// Comes with real and imaginary parts exchanged, of a forward transform; leaves with them in order, for an inverse one.
#define FFT_ROW_TURN(field, row, column, re, im)                                      \
  {                                                                                   \
    __global const float *of_mode = turn + ((size_t)(row) * FFT_SIZE + (column)) * 2; \
    lanes cosine, sine;                                                               \
    FIELD_SPLIT(of_mode, cosine, sine)                                                \
    const lanes x = im, y = re;                                                       \
    re = x * cosine - y * sine;                                                       \
    im = x * sine + y * cosine;                                                       \
  }
#define FFT_ROW_STORE(row, column, re, im) FFT_STORE_INTERMEDIATE(batch, row, column, re[0], im[0])
#define FFT_ROW_KERNEL wake_turn_rows
#define FFT_ROW_PARAMETERS __global const float *restrict turn
#include "fft/rows.clh"
