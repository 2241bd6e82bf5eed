// The ground's light, over what lies behind it.

out vec4 light;

void main() {
  Terrain terrain = terrain_here();
  bool is_covered = terrain.light.a >= 1.0;
  if (terrain.light.a <= 0.0 || is_covered == (terrain_pass.draws_edges == 1)) discard;
  light = terrain.light;
  // Distances are along the ray, depth along the line of sight.
  gl_FragDepth = clamp(view.near_m * length(view_ray()) / terrain.distance_m, 0.0, 1.0);
}
