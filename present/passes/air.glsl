// The air between the eye and what it sees, which lies before the horizon of the sky's map (environment.glsl). Behind
// cloudy_sky.glsl it is that map's clear sky.

#ifndef CLOUDY_SKY
uniform sampler2D environment;

vec3 environment_light(vec3 direction) {
  return textureLod(environment, environment_uv(direction), 0.0).rgb;
}
#endif

// What is left of a light over this distance along a unit ray, with the light of the horizon that the air sends
// besides, as a long way through it does.
vec3 through_air(vec3 light, vec3 ray, float distance_m) {
  vec3 horizon = environment_light(normalize(vec3(ray.x, 0.004, ray.z)));
  return mix(horizon, light, exp(-view.haze_perm * distance_m));
}
