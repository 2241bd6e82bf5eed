// The ground as OpenCL saw it (host/world/ground_view.h), row 0 at the top.
uniform sampler2DArray ground_image;   // (r, g, b, coverage), kcd/m2, premultiplied
uniform sampler2DArray ground_planes;  // distance along the unit ray, m, infinite where there is none; steps

ivec2 ground_size() {
  return textureSize(ground_image, 0).xy;
}

// A point of the picture, `clip`, in texels of the ground.
vec2 ground_point() {
  return vec2(0.5 + 0.5 * clip.x, 0.5 - 0.5 * clip.y) * vec2(ground_size());
}

struct Ground {
  vec4 light;
  float distance_m;
};

Ground ground_texel(ivec2 texel) {
  return Ground(texelFetch(ground_image, ivec3(texel, 0), 0), texelFetch(ground_planes, ivec3(texel, 0), 0).r);
}
