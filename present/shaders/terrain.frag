// The ground's light, over what lies behind it.
uniform vec2 picture_size;
uniform float near_m;
uniform int draws_edges;  // 0: pixels that ground covers, 1: those that it covers in part

out vec4 light;

// Texels whose distances differ by more than this share show different slopes.
const float one_slope = 0.1;

struct Ground {
  vec4 light;
  float distance_m;
};

Ground ground_texel(ivec2 texel) {
  return Ground(texelFetch(ground_image, ivec3(texel, 0), 0), texelFetch(ground_planes, ivec3(texel, 0), 0).r);
}

// Between four texels of a coarser view: those of the slope that the nearest one shows. Sky among them thins the
// ground.
Ground ground_between(vec2 point) {
  vec2 corner = floor(point - 0.5);
  vec2 share = point - 0.5 - corner;
  ivec2 last = ground_size() - 1;
  Ground texels[4];
  float weights[4];
  int nearest = 0;
  for (int i = 0; i < 4; ++i) {
    ivec2 step = ivec2(i & 1, i >> 1);
    texels[i] = ground_texel(clamp(ivec2(corner) + step, ivec2(0), last));
    weights[i] = (step.x == 1 ? share.x : 1.0 - share.x) * (step.y == 1 ? share.y : 1.0 - share.y);
    if (weights[i] > weights[nearest]) nearest = i;
  }
  float middle_m = texels[nearest].distance_m;
  if (isinf(middle_m)) {
    for (int i = 0; i < 4; ++i) middle_m = min(middle_m, texels[i].distance_m);
  }
  Ground ground = Ground(vec4(0.0), middle_m);
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    bool is_sky = isinf(texels[i].distance_m);
    if (!is_sky && abs(texels[i].distance_m - middle_m) > one_slope * middle_m) continue;
    ground.light += weights[i] * texels[i].light;
    sum += weights[i];
  }
  ground.light /= sum;
  return ground;
}

void main() {
  vec2 point = ground_point();
  Ground ground = ground_size() == ivec2(picture_size) ? ground_texel(ivec2(point)) : ground_between(point);
  bool is_covered = ground.light.a >= 1.0;
  if (ground.light.a <= 0.0 || is_covered == (draws_edges == 1)) discard;
  light = ground.light;
  // Distances are along the ray, depth along the line of sight.
  gl_FragDepth = clamp(near_m * length(view_ray()) / ground.distance_m, 0.0, 1.0);
}
