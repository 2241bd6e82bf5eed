// One step of all modes of a wake window.
// In:  turn [n][n] float2: e^{-i omega dt}, with what the shortest waves lose in a step, over n^2.
// Out: spectrum [n][n] float2, inout: that of ocean/wakes/wake_press.cl.
// With Z = h + i s, where s is the surface's potential times omega / g, linear water waves are dZ/dt = -i omega Z of each
// mode: dh/dt = omega s, ds/dt = -omega h, omega^2 = g k tanh k D (O3). A wave that travels toward +K has all of its
// energy, |Z|^2, at K.
__kernel void wake_turn(__global const float2 *restrict turn, __global float2 *restrict spectrum) {
  const size_t place = get_global_id(0);
  const float2 by = turn[place], mode = spectrum[place];
  spectrum[place] = (float2)(mode.x * by.x - mode.y * by.y, mode.x * by.y + mode.y * by.x);
}
