// Water that waves wash up and down a shore (host/ocean/surface/swash.h), and where they break before it. Labels are relative
// to the eye.

// Height of the water's edge over still water, so many seconds ago.
float swash_level_m(vec2 label_m, float earlier_s, int wave_count) {
  float level_m = waves.swash_setup_m;
  for (int i = 0; i < wave_count; ++i) {
    vec4 wave = waves.swash_waves[i];
    float turn = wave.w - dot(wave.xy, label_m) - waves.swash_omegas[i / 4][i % 4] * earlier_s;
    level_m += wave.z * cos(turn + SWASH_SKEW * cos(turn));
  }
  return level_m;
}

// Of the swash, over a bed of this depth: farther out waves move the water.
float swash_share(float depth_m) {
  return 1.0 - smoothstep(0.0, 2.0 * waves.swash_reach_m, depth_m);
}
