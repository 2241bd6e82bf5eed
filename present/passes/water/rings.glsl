// Rings of waves around points, such as those of raindrops; kernels/ocean/gerstner_surface.cl has their formula.
// Compiled for whether the sea HAS_RINGS.
#if HAS_RINGS
// Height in m, dh/dx and dh/dz at a label, of the rings that samples this far apart show.
vec3 ring_waves(vec2 label_m, float spacing_m) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < rings.count; ++i) {
    vec4 ring = rings.values[2 * i], wave = rings.values[2 * i + 1];
    vec2 from_centre_m = label_m - ring.xy;
    float rounding_m = 0.25 * ring.z;
    float hypotenuse_m = sqrt(dot(from_centre_m, from_centre_m) + rounding_m * rounding_m);
    float place = (hypotenuse_m - rounding_m) / ring.z;
    float u = place - ring.w / ring.z;
    if (abs(u) > 15.0) continue;  // e^-56 is left
    float envelope_m = shown_share(ring.z / spacing_m) * wave.x * inversesqrt(1.0 + place) * exp(-0.25 * u * u);
    float phase = 6.2831853 * u + wave.y;
    float per_m = envelope_m / ring.z *
                  ((-0.5 / (1.0 + place) - 0.5 * u) * cos(phase) - 6.2831853 * sin(phase)) / hypotenuse_m;
    sum += vec3(envelope_m * cos(phase), per_m * from_centre_m);
  }
  return sum;
}
#else
vec3 ring_waves(vec2 label_m, float spacing_m) {
  return vec3(0.0);
}
#endif
