// The next level of a colour map: the mean light of 2 x 2 texels, weighed by their coverage; at odd edges, of those that
// are there.
// inout colours: the level [rows][columns] at `source` -> that of half as many, rounded up, at `target`.
#define LANES 1
#include "terrain/colour_texel.clh"

__kernel void colour_reduce(__global uint *colours, uint source, int columns, int rows, uint target) {
  const int x = (int)get_global_id(0), z = (int)get_global_id(1);
  float red = 0.0f, green = 0.0f, blue = 0.0f, coverage = 0.0f;
  int count = 0;
  for (int row = 2 * z; row < min(2 * z + 2, rows); ++row) {
    for (int column = 2 * x; column < min(2 * x + 2, columns); ++column) {
      const Texels texel = texels_of(colours[source + (size_t)row * columns + column]);
      red += texel.coverage * texel.red;
      green += texel.coverage * texel.green;
      blue += texel.coverage * texel.blue;
      coverage += texel.coverage;
      ++count;
    }
  }
  const float scale = coverage > 0.0f ? 1.0f / coverage : 0.0f;
  colours[target + (size_t)z * ((columns + 1) / 2) + x] =
      packed_texel(red * scale, green * scale, blue * scale, coverage / (float)count);
}
