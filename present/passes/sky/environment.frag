// The upper half of the sky, without the sun's disc, as a round map for reflections: see environment_light() in
// air.glsl.
out vec4 light;

void main() {
  light = vec4(sky_radiance(sky, view_table, environment_direction(clip)), 1.0);
}
