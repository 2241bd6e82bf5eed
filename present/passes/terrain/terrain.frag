// The ground's light, over what lies behind it.
uniform float near_m;
uniform int draws_edges;  // 0: pixels that ground covers, 1: those that it covers in part

out vec4 light;

void main() {
  Terrain terrain = terrain_here();
  bool is_covered = terrain.light.a >= 1.0;
  if (terrain.light.a <= 0.0 || is_covered == (draws_edges == 1)) discard;
  light = terrain.light;
  // Distances are along the ray, depth along the line of sight.
  gl_FragDepth = clamp(near_m * length(view_ray()) / terrain.distance_m, 0.0, 1.0);
}
