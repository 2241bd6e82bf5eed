// The ground as OpenCL saw it (host/world/world_terrain.h), row 0 at the top.
uniform sampler2DArray terrain_image;   // (r, g, b, coverage), kcd/m2, premultiplied
uniform sampler2DArray terrain_planes;  // distance at which it is drawn, m, infinite where there is none; steps

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
