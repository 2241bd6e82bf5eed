// Sunlight that waves gather and spread on a bed below them: how many times as much falls on it as without waves. A
// ray that enters where the surface slopes by s comes to lie (1 - 1 / n) s aside for each metre of depth; where rays
// come together light is denser. One step of fixed-point iteration finds where the ray to a place entered.
uniform sampler2DArray gradient_map;  // dh/dx, dh/dz, d dx/dx, d dz/dz

const float aside_a_metre = 0.25;
// Waves so short against the depth fold light many times over, and more finely than a picture shows.
const float blurred_share = 0.06;
const float densest = 3.0;

vec2 sun_slope(int cascade, vec2 label_m, float level) {
  return textureLod(gradient_map, map_place(cascade, label_m), level).xy;
}

// Of cascades that shoals leave these shares of.
float caustics(vec2 label_m, float depth_m, float width_m, vec4 shares) {
  float blur_m = max(2.0 * width_m, blurred_share * depth_m), aside_m = aside_a_metre * depth_m;
  vec2 slope = vec2(0.0);
  for (int i = 0; i < CASCADES; ++i) {
    if (blur_m < waves.longest_wave_m[i]) slope += shares[i] * sun_slope(i, label_m, map_level(i, blur_m));
  }
  label_m -= aside_m * slope;
  vec3 bend = vec3(0.0);  // d2h/dx2, d2h/dxdz, d2h/dz2
  for (int i = 0; i < CASCADES; ++i) {
    if (blur_m >= waves.longest_wave_m[i]) continue;
    float level = map_level(i, blur_m);
    float step_m = exp2(level) / waves.cascades[i].w;
    vec2 along_x = sun_slope(i, label_m + vec2(step_m, 0.0), level) - sun_slope(i, label_m - vec2(step_m, 0.0), level);
    vec2 along_z = sun_slope(i, label_m + vec2(0.0, step_m), level) - sun_slope(i, label_m - vec2(0.0, step_m), level);
    bend += shares[i] * vec3(along_x.x, 0.5 * (along_x.y + along_z.x), along_z.y) / (2.0 * step_m);
  }
  bend *= aside_m;
  float spread = (1.0 + bend.x) * (1.0 + bend.z) - bend.y * bend.y;
  return min(1.0 / max(abs(spread), 1e-3), densest);
}
