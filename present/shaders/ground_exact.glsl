// The ground under a pixel of the picture, of a view as large as the picture.

Ground ground_here() {
  return ground_texel(ivec2(ground_point()));
}
