// Lookups in the pictures of what is not water (present/passes/water/water_views.h). Places are relative to the eye. What a place
// of the picture shows stands at the depth that it has there: from the way that a ray goes on to it the place is found
// where that ray shows it, as if it were flat there.
// Compiled for what there is, as some renderers go through what they do not need too: MIRRORS, clouds or things;
// MIRRORS_THINGS, what has a depth; MIRRORS_FINELY; SHOWS_BENEATH.
uniform sampler2D mirrored_light, mirrored_depth;  // premultiplied kcd/m2 with coverage; reversed depth
uniform sampler2D beneath_light, beneath_depth;
uniform sampler2D shown_ground;  // water_ground.frag: at the picture's own pixels, but without what deep water hides

// A bed's light spreads as it leaves the water: 1 / n^2, less what the surface turns back.
const float leaving_share = 0.54;
const float far_m = 1.0e5;
const int upright_taps = MIRRORS_FINELY == 1 ? 4 : 2;
// Farther down the light of many waves is one.
const float deepest_caustics_m = 16.0;

// Where the picture shows a place; z: its distance along the line of sight.
vec3 clip_of(vec3 place_m) {
  float along_m = dot(place_m, view.ray_forward);
  vec2 across = vec2(dot(place_m, view.ray_right) / dot(view.ray_right, view.ray_right), dot(place_m, view.ray_up) / dot(view.ray_up, view.ray_up));
  return vec3(across / max(along_m, 1e-3), along_m);
}

// The place that the picture shows there, so far along the line of sight.
vec3 place_along(vec3 clip_place, float along_m) {
  return (view.ray_forward + clip_place.x * view.ray_right + clip_place.y * view.ray_up) * along_m;
}

vec3 mirror_image(vec3 place_m) {
  return vec3(place_m.x, -place_m.y - 2.0 * view.eye_height_m, place_m.z);
}

vec2 mirrored_uv(vec3 clip_place) {
  return 0.5 + 0.5 / water.views_margin * vec2(clip_place.x, -clip_place.y);
}

// Above the picture there is the sky, and beside it too where clouds are all that it shows; else what its rim shows.
float mirrored_share(vec3 clip_place) {
#if MIRRORS_THINGS
  float outward = abs(clip_place.y);
#else
  float outward = max(abs(clip_place.x), abs(clip_place.y));
#endif
  return clip_place.z > 0.0 ? smoothstep(water.views_margin, 0.9 * water.views_margin, outward) : 0.0;
}

// How far from a place of the surface that stands which is mirrored at a place of the picture; far_m: nothing near,
// -1: what stands before the surface, which it does not mirror.
float mirrored_way_m(vec3 clip_place, vec3 surface_image_m) {
  float depth = textureLod(mirrored_depth, mirrored_uv(clip_place), 0.0).r;
  if (depth <= 0.0) return far_m;
  float along_m = view.near_m / depth;
  if (along_m < 0.98 * dot(surface_image_m, view.ray_forward)) return -1.0;
  return min(distance(place_along(clip_place, along_m), surface_image_m), far_m);
}

// What is mirrored toward a ray that leaves the surface, spread by an angle; covers as much as its alpha says.
// `shown`: the share of the picture in it; of that what is not covered is clear sky.
vec4 mirrored_along(vec3 surface_m, vec3 ray, float spread_rad, out float shown) {
  shown = 0.0;
#if MIRRORS
  vec3 image_m = mirror_image(surface_m), image_ray = vec3(ray.x, -ray.y, ray.z);
#if MIRRORS_THINGS
  vec3 clip_place = clip_of(image_m);
  float way_m = mirrored_way_m(clip_place, image_m);
  for (int step = 0; step < 2; ++step) {
    clip_place = clip_of(image_m + (way_m < 0.0 ? far_m : way_m) * image_ray);
    way_m = mirrored_way_m(clip_place, image_m);
  }
  float reach_m = way_m < 0.0 ? far_m : way_m;
#else
  vec3 clip_place = clip_of(image_m + far_m * image_ray);
  float reach_m = far_m;
#endif
  float share = mirrored_share(clip_place);
  if (share <= 0.0) return vec4(0.0);
  float pixel_rad = 2.0 * water.views_margin * length(view.ray_up) / float(textureSize(mirrored_light, 0).y);
  float pixels = max(spread_rad / pixel_rad * reach_m / (reach_m + length(surface_m)), 1.0);
  // Rays that graze rough water are spread upright alone: by a few lookups, each as wide as the spread across.
  float across = clamp(-surface_m.y / length(surface_m), 1.0 / float(upright_taps), 1.0);
  float level = log2(max(pixels * across, 1.0));
  float upright = pixels * 2.0 * water.views_margin / float(textureSize(mirrored_light, 0).y);
  // As far as a lookup between two levels reaches: two texels of the coarser one.
  vec3 beside = vec3(4.0 * exp2(level) * water.views_margin / float(textureSize(mirrored_light, 0).x), 0.0, 0.0);
  vec4 sum = vec4(0.0);
  for (int tap = 0; tap < upright_taps; ++tap) {
    vec3 place = clip_place + vec3(0.0, ((float(tap) + 0.5) / float(upright_taps) - 0.5) * upright, 0.0);
    float tap_level = level;
#if MIRRORS_THINGS
    if (mirrored_way_m(place, image_m) < 0.0) continue;
    // Not what stands beside it before the surface: what is as far away from that.
    bool is_left = min(mirrored_way_m(place - beside, image_m), mirrored_way_m(place - 0.5 * beside, image_m)) < 0.0;
    bool is_right = min(mirrored_way_m(place + beside, image_m), mirrored_way_m(place + 0.5 * beside, image_m)) < 0.0;
    if (is_left != is_right) place += is_left ? beside : -beside;
    if (is_left && is_right) tap_level = 0.0;
#endif
    sum += textureLod(mirrored_light, mirrored_uv(place), tap_level);
    shown += share / float(upright_taps);
  }
  return share / float(upright_taps) * sum;
#else
  return vec4(0.0);
#endif
}

vec2 beneath_uv(vec3 clip_place) {
  return 0.5 + 0.5 / water.views_margin * clip_place.xy;
}

// A place beneath the surface, and whether there is one: between the places of four texels, as far as they are of what
// the nearest shows.
vec4 beneath_at(vec3 clip_place) {
  vec2 size = vec2(textureSize(beneath_depth, 0)), point = beneath_uv(clip_place) * size - 0.5;
  ivec2 corner = ivec2(floor(point)), last = ivec2(size) - 1;
  vec2 share = point - floor(point);
  float nearest = texelFetch(beneath_depth, clamp(ivec2(floor(point + 0.5)), ivec2(0), last), 0).r;
  if (nearest <= 0.0) return vec4(0.0);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 step = ivec2(i & 1, i >> 1), texel = clamp(corner + step, ivec2(0), last);
    float depth = texelFetch(beneath_depth, texel, 0).r;
    float weight = (step.x == 1 ? share.x : 1.0 - share.x) * (step.y == 1 ? share.y : 1.0 - share.y);
    if (abs(depth - nearest) > 0.3 * nearest) continue;
    vec2 clip_texel = water.views_margin * (2.0 * (vec2(texel) + 0.5) / size - 1.0);
    sum += weight * vec4(place_along(vec3(clip_texel, 0.0), view.near_m / depth), 1.0);
  }
  return vec4(sum.xyz / sum.w, 1.0);
}

// Ground that the picture shows at a pixel before its water: light, and the place if w is 1.
struct ShownGround {
  vec3 light;
  vec4 place;
};

ShownGround shown_ground_at(vec2 clip) {
  vec2 size = vec2(textureSize(shown_ground, 0));
  vec4 texel = texelFetch(shown_ground, ivec2(clamp(0.5 + 0.5 * clip, vec2(0.0), vec2(0.9999)) * size), 0);
  // At the middle of the pixel, whose ray found it.
  vec2 middle = 2.0 * (floor((0.5 + 0.5 * clip) * size) + 0.5) / size - 1.0;
  bool is_there = texel.w > 0.0 && all(lessThan(abs(clip), vec2(1.0)));
  return ShownGround(texel.rgb, vec4(place_along(vec3(middle, 0.0), view.near_m / max(texel.w, 1e-9)), is_there ? 1.0 : 0.0));
}

// How much of its own light water sends that the bed behind a pixel lies so far below: none at the waterline. From a
// film of this depth on it is whole, over a pixel that is as high from the depth that it spans.
const float film_m = 0.03;
float water_share(float drop_m, float distance_m) {
  float pixel_m = 2.0 * length(view.ray_up) / float(textureSize(shown_ground, 0).y) * distance_m;
  return smoothstep(0.0, max(film_m, 0.75 * pixel_m), drop_m);
}

// How the sun lights what is beneath: labels of places less the places themselves, the width of a pixel's footprint,
// and its share in the light on level ground; what shoals leave of the cascades.
struct Lit {
  vec2 label_shift_m;
  float width_m, sun_part;
  vec4 cascade_shares;
};

// Light that comes up through the surface toward v, of what is in the water and of the water itself. `ground` is what the
// picture shows behind it; bed_kcdpm2 is the light of a level bed of wet sand.
vec3 light_beneath(vec3 surface_m, vec3 v, vec3 normal, Lit lit, ShownGround ground, vec3 bed_kcdpm2, vec3 deep_kcdpm2) {
#if SHOWS_BENEATH
  vec3 clip_place = clip_of(surface_m);
  vec4 straight = beneath_at(clip_place);
  // Ground as sharp as the picture, but for things in the water before it.
  bool is_sharp = ground.place.w > 0.0 && (straight.w == 0.0 || length(straight.xyz) > 0.7 * length(ground.place.xyz));
  if (is_sharp) straight = ground.place;
  // As deep below the surface as the bed, or what stands before it, along the broken ray.
  vec3 broken = refract(-v, normal, 1.0 / water_index);
  float down_m = max(still_depth_m(surface_m.xz + lit.label_shift_m) + surface_m.y + view.eye_height_m, 0.0);
  float straight_down_m = surface_m.y - straight.y;
  bool is_straight_bed = straight.w > 0.0 && straight_down_m >= 0.0 && straight_down_m <= down_m;
  if (straight.w > 0.0) down_m = min(down_m, max(straight_down_m, 0.0));
  if (down_m > 1.0e6) return deep_kcdpm2;
  vec3 bed_m = surface_m + broken * (down_m / max(-broken.y, 0.3));
  vec3 shifted_place = clip_of(bed_m);
  ShownGround shifted_ground = shown_ground_at(shifted_place.xy);
  is_sharp = is_sharp && shifted_ground.place.w > 0.0 && shifted_ground.place.y < surface_m.y;
  vec4 place = is_sharp ? shifted_ground.place : beneath_at(shifted_place);
  // Not what stands out of the water, or before it.
  bool is_beneath = place.w > 0.0 && place.y < surface_m.y && all(lessThan(abs(shifted_place.xy), vec2(water.views_margin)));
#if HAS_SHOALS
  // Nor the bed far out, past a beach that hides the bed here.
  is_beneath = is_beneath && !(distance(place.xz, surface_m.xz) > 2.0 * (surface_m.y - place.y) && place.y < bed_m.y - 0.5);
#endif
  vec4 seen = vec4(bed_kcdpm2, 1.0);
  if (is_beneath) {
    seen = is_sharp ? vec4(shifted_ground.light, 1.0) : textureLod(beneath_light, beneath_uv(shifted_place), 0.0);
  } else if (HAS_SHOALS == 1 && !is_straight_bed) {
    // Shallows that the pictures do not show, far away or beside them, are sand.
    place = vec4(bed_m, 1.0);
  } else if (straight.w > 0.0) {
    place = straight;
    is_sharp = ground.place.w > 0.0 && straight == ground.place;
    seen = is_sharp ? vec4(ground.light, 1.0) : textureLod(beneath_light, beneath_uv(clip_place), 0.0);
  } else {
    return deep_kcdpm2;
  }
  down_m = max(surface_m.y - place.y, 0.0);
  // Light has come down to it, and goes up to the eye.
  vec3 left = exp(-water.attenuation_perm * (down_m + distance(place.xyz, surface_m))) * seen.a;
  float leaving = mix(leaving_share, 1.0, exp(-4.0 * down_m));
  if (down_m > 0.0 && down_m < deepest_caustics_m) {
    float gathered = caustics(place.xz + lit.label_shift_m, down_m, lit.width_m, lit.cascade_shares);
    float fade = smoothstep(deepest_caustics_m, 0.5 * deepest_caustics_m, down_m);
    leaving *= mix(1.0, gathered, lit.sun_part * fade);
  }
  return leaving * seen.rgb / max(seen.a, 1e-3) * left + deep_kcdpm2 * (1.0 - left);
#else
  return deep_kcdpm2;
#endif
}
