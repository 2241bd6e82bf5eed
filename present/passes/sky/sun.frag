// The sun's disc, to be added to the sky behind it. Light is in kcd/m2, linear Rec.709.
out vec4 light;

// The disc at noon is brighter than a half can hold (65504), and than any picture shows.
const float brightest_kcdpm2 = 3.0e4;

void main() {
  light = vec4(min(sky_sun_disc(sky, depth_table, sky_direction()), vec3(brightest_kcdpm2)), 0.0);
}
