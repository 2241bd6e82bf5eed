// Shows the numbers behind the water, for whoever tunes it. WATER_SHOW says which: a WaterShow of
// present/passes/frame_request.h.

// Blue below zero, white at it, red above.
vec3 diverging(float value) {
  float strength = clamp(abs(value), 0.0, 1.0);
  return mix(vec3(0.9), value < 0.0 ? vec3(0.02, 0.1, 0.6) : vec3(0.7, 0.05, 0.02), strength);
}

vec3 debug_light(float height_m, vec2 slope, float jacobian, float foam, float footprint_m, vec2 label, float parity) {
  vec3 colour = vec3(0.0);
  if (WATER_SHOW == 1) colour = diverging(height_m / water.debug_height_m);
  if (WATER_SHOW == 2) colour = vec3(0.5 + slope, 0.5);
  if (WATER_SHOW == 3) colour = diverging(1.0 - jacobian);
  if (WATER_SHOW == 4) colour = vec3(foam);
  if (WATER_SHOW == 5) colour = vec3(fract(log2(footprint_m)), 0.3, 0.5);
  if (WATER_SHOW == 6) colour = mix(vec3(0.75), vec3(0.1, 0.2, 0.3), parity);
  if (WATER_SHOW >= 7 && WATER_SHOW - 7 < CASCADES) {
    colour = diverging(textureLod(displacement_map, map_place(WATER_SHOW - 7, label), 0.0).y / water.debug_height_m);
  }
  return 0.6 * view.white_kcdpm2 * colour;
}
