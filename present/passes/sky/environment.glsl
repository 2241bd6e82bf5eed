// A paraboloid map of the upper half of the sky: the direction d lies at d.xz / (1 + d.y), the zenith in the middle
// and the horizon on the unit circle.
const float environment_margin = 1.04;  // half the map's width

// What a place of the map, in clip coordinates, shows. Beyond the rim, which filters reach, and below the horizon, it
// shows what the horizon does.
vec3 environment_direction(vec2 place) {
  vec2 point = place * environment_margin;
  return normalize(vec3(2.0 * point.x, max(1.0 - dot(point, point), 0.004), 2.0 * point.y));
}

// Where the map has a direction, in texture coordinates.
vec2 environment_uv(vec3 direction) {
  return 0.5 + 0.5 / environment_margin * (direction.xz / (1.0 + max(direction.y, 0.0)));
}
