// The ground as OpenCL saw it (host/world/world_terrain.h), row 0 at the top.
uniform sampler2DArray terrain_image;   // (r, g, b, coverage), kcd/m2, premultiplied
uniform sampler2DArray terrain_planes;  // distance along the unit ray, m, infinite where there is none; steps

ivec2 terrain_size() {
  return textureSize(terrain_image, 0).xy;
}

// A point of the picture, `clip`, in texels of the ground.
vec2 terrain_point() {
  return vec2(0.5 + 0.5 * clip.x, 0.5 - 0.5 * clip.y) * vec2(terrain_size());
}

struct Terrain {
  vec4 light;
  float distance_m;
};

Terrain terrain_texel(ivec2 texel) {
  return Terrain(texelFetch(terrain_image, ivec3(texel, 0), 0), texelFetch(terrain_planes, ivec3(texel, 0), 0).r);
}

// Whether a ray has met what is not under water (SeaOverTerrain of host/terrain/shading/terrain_shade.h).
bool meets_ground(float distance_m) {
  float height_m = view.eye_height_m + distance_m * normalize(view_ray()).y;
  return !isinf(distance_m) && height_m >= terrain_pass.hidden_below_m - terrain_pass.hidden_bend_perm * distance_m * distance_m;
}

// How far ground is that covers a texel in part: where its own ray has passed it, as the ground beside it.
float edge_distance_m(ivec2 texel) {
  const ivec2 steps[4] = ivec2[4](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));
  ivec2 last = terrain_size() - 1;
  float distance_m = terrain_texel(texel).distance_m;
  if (meets_ground(distance_m)) return distance_m;
  bool is_first = true, is_covered = false;
  for (int i = 0; i < 4; ++i) {
    Terrain beside = terrain_texel(clamp(texel + steps[i], ivec2(0), last));
    // Rather as ground that is seen whole: what else rays have met may be under water.
    bool covers = beside.light.a >= 1.0;
    if (beside.light.a <= 0.0 || (is_covered && !covers)) continue;
    distance_m = is_first || covers != is_covered ? beside.distance_m : min(distance_m, beside.distance_m);
    is_first = false;
    is_covered = covers;
  }
  return distance_m;
}
