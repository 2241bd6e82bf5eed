// The ground under a pixel of the picture, of a view as large as the picture.

Ground ground_here() {
  ivec2 texel = ivec2(ground_point());
  Ground ground = ground_texel(texel);
  if (ground.light.a > 0.0 && ground.light.a < 1.0) ground.distance_m = edge_distance_m(texel);
  return ground;
}
