// The ground under a pixel of the picture, of a view as large as the picture.

Terrain terrain_here() {
  ivec2 texel = ivec2(terrain_point());
  Terrain terrain = terrain_texel(texel);
  if (terrain.light.a > 0.0 && terrain.light.a < 1.0) terrain.distance_m = edge_distance_m(texel);
  return terrain;
}
