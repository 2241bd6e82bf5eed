// The fields of a wake window that are drawn, as spectra.
// In:  spectrum [n][n] float2 of its state, not scaled; omega [n][n] rad/s; the time since the state; the step between
//      wavenumbers.
// Out: fields [2][n][n] float2, for one inverse transform: h + i dh/dt, then dh/dx + i dh/dz.
// h and s are real, so that half of their modes are conjugates of the others: h(K) = (Z(K) + conj Z(-K)) / 2,
// s(K) = (Z(K) - conj Z(-K)) / 2i.
__kernel void wake_spectrum(__global const float2 *restrict spectrum, __global const float *restrict omega, int size,
                            float since_s, float wavenumber_step_radpm, __global float2 *restrict fields) {
  const int column = (int)get_global_id(0), row = (int)get_global_id(1), mask = size - 1;
  const size_t place = (size_t)row * size + column, partner = (size_t)((size - row) & mask) * size + ((size - column) & mask);
  const float cosine = cos(omega[place] * since_s), sine = -sin(omega[place] * since_s);
  const float2 a = spectrum[place], b = spectrum[partner];
  const float2 mode = (float2)(a.x * cosine - a.y * sine, a.x * sine + a.y * cosine);
  const float2 mirrored = (float2)(b.x * cosine - b.y * sine, -b.x * sine - b.y * cosine);
  const float scale = 0.5f / ((float)size * (float)size);
  const float2 height = scale * (mode + mirrored), turned = scale * (mode - mirrored);
  // s = turned / i and dh/dt = omega s, so that i dh/dt = omega turned.
  fields[place] = height + omega[place] * turned;
  // The wavenumber n/2 has no partner, and no slope.
  const float kx = column == size / 2 ? 0.0f : (float)(column < size / 2 ? column : column - size) * wavenumber_step_radpm;
  const float kz = row == size / 2 ? 0.0f : (float)(row < size / 2 ? row : row - size) * wavenumber_step_radpm;
  fields[place + (size_t)size * size] =
      (float2)(-kx * height.y - kz * height.x, kx * height.x - kz * height.y);
}
