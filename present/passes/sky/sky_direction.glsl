// The direction in which this pixel sees the sky. The sea ends at the horizon, give or take a pixel: no ray that misses
// it may see the ground below.
vec3 sky_direction() {
  vec3 direction = normalize(view_ray());
  float dip = sky_horizon_distance(sky.ground_radius_m, sky.eye_altitude_m) / (sky.ground_radius_m + sky.eye_altitude_m);
  direction.y = max(direction.y, 1e-4 - dip);
  return direction;
}
