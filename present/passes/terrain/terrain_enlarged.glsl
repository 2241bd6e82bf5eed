// The ground under a pixel of the picture, of a coarser view.

// Texels whose distances differ by more than this share show different slopes.
const float one_slope = 0.1;

// Between four texels of a coarser view: those of the slope that the nearest one shows. Sky, and water, among them
// thins the ground.
Terrain terrain_here() {
  vec2 point = terrain_point();
  vec2 corner = floor(point - 0.5);
  vec2 share = point - 0.5 - corner;
  ivec2 last = terrain_size() - 1;
  Terrain texels[4];
  float weights[4];
  int nearest = 0;
  for (int i = 0; i < 4; ++i) {
    ivec2 step = ivec2(i & 1, i >> 1);
    ivec2 texel = clamp(ivec2(corner) + step, ivec2(0), last);
    texels[i] = terrain_texel(texel);
    weights[i] = (step.x == 1 ? share.x : 1.0 - share.x) * (step.y == 1 ? share.y : 1.0 - share.y);
    if (weights[i] > weights[nearest]) nearest = i;
  }
  float middle_m = texels[nearest].distance_m;
  if (texels[nearest].light.a <= 0.0) {
    bool is_first = true;
    for (int i = 0; i < 4; ++i) {
      if (texels[i].light.a <= 0.0) continue;
      middle_m = is_first ? texels[i].distance_m : min(middle_m, texels[i].distance_m);
      is_first = false;
    }
  }
  Terrain terrain = Terrain(vec4(0.0), middle_m);
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    bool is_sky = texels[i].light.a <= 0.0;
    if (!is_sky && abs(texels[i].distance_m - middle_m) > one_slope * middle_m) continue;
    terrain.light += weights[i] * texels[i].light;
    sum += weights[i];
  }
  terrain.light /= sum;
  return terrain;
}
