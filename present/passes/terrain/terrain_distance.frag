// How far the ground of each texel is, where a texel is covered in part as far as the ground beside it: worked out once a
// texel, before the ground is enlarged.

out float distance_m;

void main() {
  ivec2 texel = ivec2(terrain_point());
  Terrain terrain = terrain_texel(texel);
  bool is_edge = terrain.light.a > 0.0 && terrain.light.a < 1.0;
  distance_m = is_edge ? edge_distance_m(texel) : terrain.distance_m;
}
