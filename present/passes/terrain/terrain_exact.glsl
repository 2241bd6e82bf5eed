// The ground under a pixel of the picture, of a view as large as the picture.

Terrain terrain_here() {
  return terrain_texel(ivec2(terrain_point()));
}
