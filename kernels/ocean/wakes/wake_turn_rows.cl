// Second pass of a step of a wake window: the rest of the forward transform, and the step of all modes.
// In:  intermediate of ocean/wakes/wake_press_columns.cl; turn [n][n] float2: e^{-i omega dt}, with what the shortest waves lose in
//      a step, over n^2.
// Out: spectrum [n][n] float2.
// With Z = h + i s, where s is the surface's potential times omega / g, linear water waves are dZ/dt = -i omega Z of each
// mode: dh/dt = omega s, ds/dt = -omega h, omega^2 = g k tanh k D (O3). A wave that travels toward +K has all of its
// energy, |Z|^2, at K.
#include "fft/one_field.clh"

// Real and imaginary parts exchanged: a forward transform.
#define FFT_ROW_STORE(row, column, re, im)                                 \
  {                                                                        \
    const size_t place = ((size_t)(row) * FFT_SIZE + (column)) * 2;        \
    lanes cosine, sine;                                                    \
    FIELD_SPLIT(turn + place, cosine, sine)                                \
    const lanes turned_x = im[0] * cosine - re[0] * sine;                  \
    const lanes turned_y = im[0] * sine + re[0] * cosine;                  \
    FIELD_JOIN(turned_x, turned_y, spectrum + place)                       \
  }
#define FFT_ROW_KERNEL wake_turn_rows
#define FFT_ROW_PARAMETERS __global const float *restrict turn, __global float *restrict spectrum
#include "fft/rows.clh"
