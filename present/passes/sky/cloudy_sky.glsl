// The round maps of present/passes/sky/cloudy_sky.h, the clear sky and the sky with clouds, in the place of the clear sky's alone.
#define CLOUDY_SKY
uniform sampler2DArray environment;

// Without clouds.
vec3 environment_light(vec3 direction) {
  return textureLod(environment, vec3(environment_uv(direction), 0.0), 0.0).rgb;
}

// With clouds, spread by an angle.
vec3 cloudy_sky_light(vec3 direction, float spread_rad) {
  vec2 uv = environment_uv(direction), point = (2.0 * uv - 1.0) * environment_margin;
  // The direction at an angle a from the zenith lies tan(a / 2) from the middle.
  float map_rad = 0.25 / environment_margin * (1.0 + dot(point, point));
  float level = log2(max(spread_rad * map_rad * float(textureSize(environment, 0).x), 1.0));
  return textureLod(environment, vec3(uv, 1.0), level).rgb;
}
