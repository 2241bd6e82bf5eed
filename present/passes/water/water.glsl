// What the shaders of the water's shape and of its light know: cascades of waves on repeating maps, and where the eye stands on them.
const float earth_radius_m = 6.36e6;

// How far the Earth's surface lies below the plane at the eye's label.
float earth_drop_m(vec2 label_m) {
  return dot(label_m, label_m) / (2.0 * earth_radius_m);
}

// CASCADES, their number, is what this is compiled for.
uniform sampler2DArray displacement_map;  // dx, h, dz in m, d dx/dz

// Place on the map of a cascade of a label relative to the eye: the first texel is label (0, 0).
vec3 map_place(int cascade, vec2 label_m) {
  vec4 patch_of = waves.cascades[cascade];
  float half_texel = 0.5 * patch_of.x / patch_of.w;
  return vec3(label_m * patch_of.x + patch_of.yz + half_texel, float(cascade));
}

// Mip level whose texels are this wide.
float map_level(int cascade, float width_m) {
  return max(0.0, log2(width_m * waves.cascades[cascade].w));
}

// Share of a wave that is drawn on a grid with this many samples a wavelength: host/ocean/surface/gerstner_surface.h.
float shown_share(float samples) {
  return smoothstep(2.0, 4.0, samples);
}
