// The upper half of the sky, without the sun's disc, as a round map for reflections: see environment_light() in
// environment.glsl.
out vec4 light;

void main() {
  vec2 point = clip * environment_margin;
  float square = dot(point, point);
  // Beyond the rim, which the bilinear filter reaches, and below the horizon, the horizon's own light.
  vec3 direction = vec3(2.0 * point.x, max(1.0 - square, 0.004), 2.0 * point.y);
  light = vec4(sky_radiance(sky, view_table, normalize(direction)), 1.0);
}
