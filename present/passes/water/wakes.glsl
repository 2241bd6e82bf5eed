// Wake windows: layers of the surface that are known in a square alone, and end in nothing at its edge.
// Compiled for WAKES, the number of windows.
#if WAKES > 0
uniform sampler2DArray wake_map;  // h m, dh/dx, dh/dz, foam 0 ... 1

// What a window has at a label relative to the eye, as far as texels of this width show it: 0 beside it.
vec4 wake_at(int i, vec2 label_m, float width_m) {
  vec4 window = waves.wakes[i];
  vec2 place = label_m * window.x + window.yz;
  if (any(lessThan(place, vec2(0.0))) || any(greaterThan(place, vec2(window.w - 1.0)))) return vec4(0.0);
  vec3 map_place = vec3((place + waves.wake_first[i].xy + 0.5) / window.w, float(i));
  return textureLod(wake_map, map_place, max(0.0, log2(width_m * window.x)));
}

// Height in m, dh/dx and dh/dz.
vec3 wake_waves(vec2 label_m, float width_m) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < WAKES; ++i) sum += wake_at(i, label_m, width_m).xyz;
  return sum;
}

// Share that the foam of no window covers.
float bare_of_wakes(vec2 label_m, float width_m) {
  float bare = 1.0;
  for (int i = 0; i < WAKES; ++i) bare *= 1.0 - wake_at(i, label_m, width_m).w;
  return bare;
}
#else
vec3 wake_waves(vec2 label_m, float width_m) { return vec3(0.0); }
float bare_of_wakes(vec2 label_m, float width_m) { return 1.0; }
#endif
