// The refractive index of sea water.
const float water_index = 1.34;

// Light reflected by water at a facet, from above and unpolarised, by the cosine between ray and normal: Fresnel's
// equations.
float fresnel(float cosine) {
  float inside = sqrt(water_index * water_index - 1.0 + cosine * cosine);
  float across = (cosine - inside) / (cosine + inside);
  float along = (water_index * water_index * cosine - inside) / (water_index * water_index * cosine + inside);
  return 0.5 * (across * across + along * along);
}
