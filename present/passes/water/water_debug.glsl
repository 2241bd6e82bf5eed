// Views of the numbers behind the water, for whoever tunes it. Compiled for the DEBUG_VIEW: in the order of DebugView
// in present/passes/frame_request.h.
uniform float debug_white;     // light that the screen shows as white
uniform float debug_height_m;  // height that is drawn fully red, its negative fully blue

// Blue below zero, white at it, red above.
vec3 diverging(float value) {
  float strength = clamp(abs(value), 0.0, 1.0);
  return mix(vec3(0.9), value < 0.0 ? vec3(0.02, 0.1, 0.6) : vec3(0.7, 0.05, 0.02), strength);
}

vec3 debug_light(float height_m, vec2 slope, float jacobian, float foam, float footprint_m, vec2 label, float parity) {
  vec3 colour = vec3(0.0);
  if (DEBUG_VIEW == 1) colour = diverging(height_m / debug_height_m);
  if (DEBUG_VIEW == 2) colour = vec3(0.5 + slope, 0.5);
  if (DEBUG_VIEW == 3) colour = diverging(1.0 - jacobian);
  if (DEBUG_VIEW == 4) colour = vec3(foam);
  if (DEBUG_VIEW == 5) colour = vec3(fract(log2(footprint_m)), 0.3, 0.5);
  if (DEBUG_VIEW == 6) colour = mix(vec3(0.75), vec3(0.1, 0.2, 0.3), parity);
  if (DEBUG_VIEW >= 7 && DEBUG_VIEW - 7 < CASCADES) {
    colour = diverging(textureLod(displacement_map, map_place(DEBUG_VIEW - 7, label), 0.0).y / debug_height_m);
  }
  return 0.6 * debug_white * colour;
}
