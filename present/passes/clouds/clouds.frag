// Clouds over what lies behind them, through the air before them.
uniform sampler2DArray cloud_image;     // premultiplied, kcd/m2
uniform sampler2DArray cloud_distance;  // m, mean of that light's

out vec4 light;

// Mean density along a straight way between two altitudes, over that at the sea.
vec2 mean_density(float low_m, float rise_m) {
  vec2 at_low = exp(-low_m / clouds.scale_heights_m), rises = rise_m / clouds.scale_heights_m;
  vec2 share = (1.0 - exp(-rises)) / rises;
  return at_low * mix(share, 1.0 - 0.5 * rises, lessThan(abs(rises), vec2(1e-3)));
}

void main() {
  ivec3 pixel = ivec3(gl_FragCoord.xy, 0);
  vec4 seen = texelFetch(cloud_image, pixel, 0);
  if (seen.a <= 0.0) discard;
  vec3 ray = normalize(view_ray());
  float distance_m = max(texelFetch(cloud_distance, pixel, 0).r - clouds.airless_m / max(ray.y, 1e-3), 0.0);
  float from_m = max(view.eye_height_m, 0.0);
  vec2 way = distance_m / clouds.scale_heights_m * mean_density(from_m, max(distance_m * ray.y, -from_m));
  vec3 before = clouds.rayleigh_depth * way.x + clouds.aerosol_depth * way.y;
  // Of the light that all air along the ray sends, what is before the cloud sends as much as it takes away. A ray that
  // does not rise never leaves the air.
  vec2 all_way = exp(-from_m / clouds.scale_heights_m) / max(ray.y, 0.01);
  vec3 all_air = clouds.rayleigh_depth * all_way.x + clouds.aerosol_depth * all_way.y;
  vec3 sent = (1.0 - exp(-before)) / (1.0 - exp(-max(all_air, before)));
  vec3 sky = environment_light(normalize(vec3(ray.x, max(ray.y, 0.004), ray.z)));
  light = vec4(seen.rgb * exp(-before) + seen.a * sky * sent, seen.a);
}
