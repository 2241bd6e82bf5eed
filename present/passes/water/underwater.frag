// What an eye below a flat sea sees.
uniform sampler2D dry_light;  // kcd/m2
uniform sampler2D dry_depth;  // reversed

out vec4 light;

vec3 sky_above(vec3 direction) {
#ifdef CLOUDY_SKY
  return cloudy_sky_light(direction, 0.0);
#else
  return environment_light(direction);
#endif
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 ray = view_ray();
  float depth_m = -view.eye_height_m;
  float depth = texelFetch(dry_depth, pixel, 0).r;
  float way_m = depth > 0.0 ? view.near_m / depth * length(ray) : 1.0e9;
  ray = normalize(ray);
  vec3 seen = texelFetch(dry_light, pixel, 0).rgb;
  float surface_m = ray.y > 0.0 ? depth_m / ray.y : 1.0e9;
  if (surface_m < way_m) {
    vec3 above = refract(ray, vec3(0.0, -1.0, 0.0), water_index);
    bool is_window = dot(above, above) > 0.0;
    seen = is_window ? (1.0 - fresnel(above.y)) * sky_above(above) : underwater.deep_kcdpm2;
    way_m = surface_m;
  } else {
    // Light has come down to what is seen.
    seen *= exp(-underwater.attenuation_perm * max(depth_m - way_m * ray.y, 0.0));
  }
  vec3 left = exp(-underwater.attenuation_perm * way_m);
  // The water's own light, which falls with the depth.
  vec3 around = underwater.deep_kcdpm2 * exp(-underwater.attenuation_perm * depth_m);
  light = vec4(seen * left + around * (1.0 - left), 1.0);
}
