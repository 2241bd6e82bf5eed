// What is left of the waves over shoals (host/ocean/query/shoals.h): shares of the heights that they have in the open sea.
// Compiled with HAS_SHOALS, SHOAL_STEPS rows of the table and SHOAL_STEEPEST, the slope of the bed beyond the map's edge;
// the open sea is left whole.
struct Shares {
  vec4 cascades, gerstner_waves;
};

#if HAS_SHOALS
uniform sampler2D shoal_depths;  // m, of still water at the posts of a map

// Of still water at a label relative to the eye; negative on land.
float still_depth_m(vec2 label_m) {
  vec2 posts = vec2(textureSize(shoal_depths, 0));
  vec2 place = waves.shoal_place.xy + label_m * waves.shoal_place.zw;
  vec2 near = clamp(place, vec2(0.0), posts - 1.0);
  return textureLod(shoal_depths, (near + 0.5) / posts, 0.0).r +
         SHOAL_STEEPEST * length((place - near) / waves.shoal_place.zw);
}

Shares shares_of_depth(float depth_m) {
  float row = sqrt(clamp(depth_m / waves.shoal_deepest_m, 0.0, 1.0)) * float(SHOAL_STEPS - 1);
  int below = min(int(row), SHOAL_STEPS - 2);
  float beyond = row - float(below);
  return Shares(mix(shoals.shares[2 * below], shoals.shares[2 * below + 2], beyond),
                mix(shoals.shares[2 * below + 1], shoals.shares[2 * below + 3], beyond));
}

// At a label relative to the eye.
Shares shares_at(vec2 label_m) { return shares_of_depth(still_depth_m(label_m)); }
#else
float still_depth_m(vec2 label_m) { return 1.0e9; }

Shares shares_at(vec2 label_m) {
  return Shares(vec4(1.0), vec4(1.0));
}
#endif
