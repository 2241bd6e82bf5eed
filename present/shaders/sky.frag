// The sky behind everything down to the horizon, with the sun's disc. Light is in kcd/m2, linear Rec.709.
out vec4 light;

// The disc at noon is brighter than a half can hold (65504), and than any picture shows.
const float brightest_kcdpm2 = 3.0e4;

void main() {
  vec3 direction = normalize(view_ray());
  // The sea ends at the horizon, give or take a pixel: no ray that misses it may see the ground below.
  float dip = sky_horizon_distance(sky.ground_radius_m, sky.eye_altitude_m) / (sky.ground_radius_m + sky.eye_altitude_m);
  direction.y = max(direction.y, 1e-4 - dip);
  vec3 sun = min(sky_sun_disc(sky, depth_table, direction), vec3(brightest_kcdpm2));
  light = vec4(sky_radiance(sky, view_table, direction) + sun, 1.0);
}
