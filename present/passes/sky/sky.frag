// The sky behind everything down to the horizon, without the sun's disc. Light is in kcd/m2, linear Rec.709.
out vec4 light;

void main() {
  light = vec4(sky_radiance(sky, view_table, sky_direction()), 1.0);
}
