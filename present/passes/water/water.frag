// The ocean's surface: slopes summed pixel by pixel, the sky mirrored in them, the sun's glitter, the light of the
// water below and foam. What a pixel cannot show of the slopes widens the glitter instead: each mip level of the
// slope map hides a known covariance, and the shortest ripples are in no map. Light is in kcd/m2, linear Rec.709.
// Compiled for TAPS samples along a pixel's footprint.
uniform sampler2D place_of;   // water_surface.frag's outputs
uniform sampler2D facet_of;
uniform sampler2D strain_of;
uniform sampler2DArray foam_map;      // coverage 0 ... 1
uniform sampler2D foam_pattern;  // foam_texture()

out vec4 light;

const float foam_albedo = 0.5;
const vec3 wet_sand_albedo = vec3(0.19, 0.16, 0.117);  // kernels/terrain/cover/terrain_cover.clh
// Where the surface all but folds, slopes of a height field lose their meaning; foam hides such places.
const float least_jacobian = 0.2;

vec3 water_kcdpm2;  // light from below the surface here

// Light that a facet sends, and what of it is from things that it mirrors, which has come all the way to the eye as
// if there were no water on it: their light, and their share in the picture.
struct FacetLight {
  vec3 all, mirrored;
  float share;
};

vec3 hidden_at(int cascade, float level) {
  float place = clamp(level, 0.0, float(water.level_count - 1));
  int below = min(int(place), water.level_count - 2);
  return mix(water.hidden_slopes[cascade * water.level_count + below].xyz,
             water.hidden_slopes[cascade * water.level_count + below + 1].xyz, place - float(below));
}

// Width of what a facet mirrors, in parts of its `blur`. A facet stands for half of the slopes. Their rays spread over 8
// `blur` along the view, and less across it. Narrow facets sparkle, wide ones dull bright clouds: of 4, 5, 6, 8 and 12,
// 6 comes nearest to the mean over 64 finer pixels of world.toml.
const float facet_width = 6.0;

// Light that a facet of this slope sends along v, and facets like it, whose mirrored rays rise or fall by `blur`. A
// ray that is mirrored downward meets another wave, taken as level there.
FacetLight facet_light(vec2 slope, vec3 surface_m, vec3 v, float blur) {
  vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
  vec3 ray = reflect(-v, normal);
  vec3 upward = normalize(vec3(ray.x, sqrt(ray.y * ray.y + blur * blur), ray.z));
  float shown;
  vec4 local = mirrored_along(surface_m, upward, facet_width * blur, shown);
  float lost = ray.y < 0.0 ? 1.0 - fresnel(-ray.y) : 0.0;
  float mirrors = fresnel(clamp(dot(v, normal), 0.0, 1.0)) * (1.0 - lost);
  vec3 mirrored = mirrors * local.rgb;
#ifdef CLOUDY_SKY
  // Clouds that the picture shows are in it; else they are behind all that it shows.
  shown = mix(local.a, shown, water.image_has_clouds);
  vec3 sky = mirrors * ((shown - local.a) * environment_light(upward) +
                        (1.0 - shown) * cloudy_sky_light(upward, facet_width * blur));
#else
  vec3 sky = mirrors * (1.0 - local.a) * environment_light(upward);
#endif
  return FacetLight(mirrored + sky + (1.0 - mirrors) * water_kcdpm2, mirrored, mirrors * local.a);
}

// The standard normal distribution function, within 2e-4 (Bowling et al. 2009), and its inverse, within 0.02 for
// shares from 1e-4 on.
float normal_share(float x) { return 1.0 / (1.0 + exp(-x * (1.5976 + 0.07056 * x * x))); }
float normal_quantile(float share) {
  return 5.494 * sinh(asinh(0.3418 * log(share / (1.0 - share))) / 3.0);
}

// Mean and variance of the pattern of foam in a pixel.
vec2 foam_moments(vec2 place, float level) {
  vec2 texel = textureLod(foam_pattern, place, level).rg * vec2(2.0 * FOAM_VALUE_LIMIT, FOAM_VALUE_LIMIT * FOAM_VALUE_LIMIT);
  float mean = texel.x - FOAM_VALUE_LIMIT;
  return vec2(mean, max(texel.y - mean * mean, 0.0));
}

// Of the pattern on the drifting water, as a pixel shows it.
float foam_value(vec2 label_m, float width_m) {
  float texel_m = water.foam_tile_m / float(textureSize(foam_pattern, 0).x);
  return foam_moments(water.foam_place + label_m / water.foam_tile_m, max(0.0, log2(width_m / texel_m))).x;
}

// How much of the water foam of this coverage hides here: patches, threads and streaks that drift with the water,
// as far as a pixel shows them. The pattern's values are normal and foam lies where they exceed a threshold, so that
// the mean opacity is the coverage at every width: what a pixel hides of the pattern softens its edges.
float foam_opacity(float coverage, vec2 label_m, float width_m) {
  const float softness = 0.35;
  if (coverage <= 1e-4) return max(coverage, 0.0);
  vec2 place = water.foam_place + label_m / water.foam_tile_m;
  float texel_m = water.foam_tile_m / float(textureSize(foam_pattern, 0).x);
  float level = max(0.0, log2(width_m / texel_m));
  vec2 fine = foam_moments(place, level);
  vec2 streak_place = water.streak_place + label_m.x * water.streak_x + label_m.y * water.streak_z;
  vec2 streaks = foam_moments(streak_place, max(0.0, level - 2.0));
  // Fresh foam is whole; as it thins out the wind draws it into streaks.
  float share = mix(water.streak_share, 0.35, smoothstep(0.1, 0.7, coverage));
  vec2 shares = vec2(1.0 - share, share);
  float value = dot(shares, vec2(fine.x, streaks.x));
  shares *= shares;
  float hidden = dot(shares, vec2(fine.y, streaks.y));
  float all = shares.x + shares.y + softness * softness;
  float threshold = -sqrt(all) * normal_quantile(min(coverage, 0.9999));
  return normal_share((value - threshold) / sqrt(hidden + softness * softness));
}

// Factors of FoamGathering for each cascade, as far as the longer waves are drawn: gerstner_share of those of Gerstner
// waves, and of cascades what texels of this width show.
vec4 gathering_factor(float width_m, float gerstner_share) {
  vec4 factor = vec4(0.0);
  float drawn = gerstner_share * water.gerstner_compression;  // variance
  for (int i = 0; i < CASCADES; ++i) {
    if (water.foam_factor[i] > 0.0) {
      factor[i] = pow(water.foam_factor[i], min(drawn / max(water.foam_variance[i], 1e-9), 1.0));
    }
    if (i + 1 == CASCADES) break;
    vec3 hidden = hidden_at(i, map_level(i, width_m)), all = hidden_at(i, float(water.level_count));
    float shown = 1.0 - (hidden.x + hidden.z) / max(all.x + all.z, 1e-9);
    drawn += shown * (water.foam_variance[i + 1] - water.foam_variance[i]);
  }
  return factor;
}

// A way aside by about a texel of a foam map, in texels: long waves have maps of texels of metres, whose
// squares would show.
vec2 ragged(vec2 label_m, float width_m) {
  vec2 place = 0.31 * (water.foam_place + label_m / water.foam_tile_m);
  float level = max(0.0, log2(0.31 * width_m * float(textureSize(foam_pattern, 0).x) / water.foam_tile_m));
  return 0.6 * vec2(foam_moments(place, level).x, foam_moments(0.5 - place.yx, level).x);
}

#if HAS_SHOALS && SHOWS_BENEATH
// Foam that the swash carries over a place of the bed: a front, and lace that thins out behind it until the next one comes.
float swash_foam(vec3 bed_m, vec2 label_shift_m) {
  const int steps = 6;  // of a period
  vec2 label_m = bed_m.xz + label_shift_m;
  float bed_height_m = bed_m.y + view.eye_height_m + earth_drop_m(label_m);
  bool is_shore = abs(bed_height_m) < 1.5 * waves.swash_reach_m;
  int wave_count = is_shore ? SWASH_WAVES : 0, step_count = is_shore ? steps : 0;
  float step_s = waves.swash_period_s / float(steps);
  float above_m = max(swash_level_m(label_m, 0.0, wave_count) - bed_height_m, 0.0), since = 1.0;
  for (int step = 1; step <= step_count; ++step) {
    float before_m = swash_level_m(label_m, float(step) * step_s, wave_count) - bed_height_m;
    if (since == 1.0 && before_m < 0.0) since = (float(step - 1) + above_m / max(above_m - before_m, 1e-6)) / float(steps);
    above_m = max(before_m, 0.0);
  }
  float low = 1.0 - smoothstep(0.6, 1.5, -bed_height_m / max(waves.swash_reach_m, 1e-6));
  return (is_shore ? low : 0.0) * smoothstep(0.02, 0.25, waves.swash_reach_m) *
         (0.5 * exp(-since / 0.07) + 0.38 * exp(-since / 0.3));
}
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 facet = texelFetch(facet_of, pixel, 0);
  float distance_m = facet.z;
  vec4 place = texelFetch(place_of, pixel, 0);
  vec2 label_m = place.xy, long_m = place.zw;
  float width_m = max(length(long_m) / float(TAPS), facet.w);
  vec2 gerstner_slope = facet.xy;
  // Rings are mostly shorter than the cells of the grid: their slopes are worked out here.
  gerstner_slope += ring_waves(label_m, width_m).yz + wake_waves(label_m, width_m).yz;
  vec4 strain = texelFetch(strain_of, pixel, 0);
  vec3 gerstner_gradient = strain.xyz;

  Shares shares = shares_at(label_m);
  vec2 slope = vec2(0.0);
  vec3 square = vec3(0.0);
  vec3 gradient = gerstner_gradient;
  float bare = 1.0;
  vec2 aside = ragged(label_m, width_m);
  vec4 factor = gathering_factor(width_m, 1.0 - fract(strain.w));
  for (int tap = 0; tap < TAPS; ++tap) {
    vec2 tap_m = label_m + ((float(tap) + 0.5) / float(TAPS) - 0.5) * long_m;
    vec2 tap_slope = gerstner_slope;
    float tap_bare = 1.0;
    float compression = -(gerstner_gradient.x + gerstner_gradient.z);
    for (int i = 0; i < CASCADES; ++i) {
      vec3 map_point = map_place(i, tap_m);
      float level = map_level(i, width_m);
      if (water.foam_factor[i] > 0.0) {
        vec3 foam_point = map_place(i, tap_m + aside / waves.cascades[i].w);
        float foam = shares.cascades[i] * factor[i] * exp(water.foam_steepness[i] * compression) *
                     textureLod(foam_map, foam_point, level).r;
        tap_bare *= 1.0 - min(foam, 1.0);
      }
      if (width_m >= waves.longest_wave_m[i]) continue;
      vec4 texel = textureLod(gradient_map, map_point, level);
      tap_slope += shares.cascades[i] * texel.xy;
      compression -= shares.cascades[i] * (texel.z + texel.w);
      gradient += shares.cascades[i] / float(TAPS) *
                  vec3(texel.z, textureLod(displacement_map, map_point, level).w, texel.w);
    }
    slope += tap_slope / float(TAPS);
    square += vec3(tap_slope.x * tap_slope.x, tap_slope.x * tap_slope.y, tap_slope.y * tap_slope.y) / float(TAPS);
    bare -= (1.0 - tap_bare) / float(TAPS);
  }
  // Hidden are the slopes of ripples, of Gerstner waves that the grid is too coarse for, those between the taps and those
  // that differ from tap to tap.
  // Gerstner waves that are not drawn are mostly the shortest. The wind makes ripples anew wherever it blows.
  float gerstner_share = shares.gerstner_waves.w;
  vec3 hidden = water.ripples + gerstner_share * gerstner_share * fract(strain.w) * water.gerstner_slopes + square - vec3(slope.x * slope.x, slope.x * slope.y, slope.y * slope.y);
  for (int i = 0; i < CASCADES; ++i) {
    hidden += shares.cascades[i] * shares.cascades[i] * hidden_at(i, map_level(i, width_m));
  }

  // F^-T applied to the slopes at labels gives those of the displaced surface; F = I + gradient.
  vec3 f = gradient + vec3(1.0, 0.0, 1.0);
  float jacobian = f.x * f.z - f.y * f.y;
  slope = vec2(f.z * slope.x - f.y * slope.y, f.x * slope.y - f.y * slope.x) / max(jacobian, least_jacobian);

  vec3 ray = normalize(view_ray());
  vec3 v = -ray;
  float sun_share = cloud_share(ray * distance_m);
  vec3 shaded_sun_klx = sun_share * water.sun_klx;
  vec3 surface_m = ray * distance_m;
  float sun_level_klx = dot(shaded_sun_klx, vec3(1.0)) * max(water.sun_direction.y, 0.0);
  float sun_part = sun_level_klx / max(sun_level_klx + dot(water.sky_klx, vec3(1.0)), 1e-6);
  ShownGround ground = shown_ground_at(clip);
  Lit lit = Lit(label_m - surface_m.xz, width_m, sun_part, shares.cascades);
  water_kcdpm2 = light_beneath(surface_m, v, normalize(vec3(-slope.x, 1.0, -slope.y)), lit, ground,
                               wet_sand_albedo / pi * (water.sky_klx + shaded_sun_klx * max(water.sun_direction.y, 0.0)),
                               water.water_of_sky_kcdpm2 + sun_share * water.water_of_sun_kcdpm2);
  Facets facets = Facets(slope, hidden);
  Visibility seen = visibility(facets, v);
  // Two facets that have mean and variance of those seen; each stands for half of them.
  vec2 apart = seen.spread * seen.deviation;
  vec2 middle = slope + seen.spread * seen.mean;
  float blur = 0.5 * length(apart);
  FacetLight low = facet_light(middle - apart, surface_m, v, blur), high = facet_light(middle + apart, surface_m, v, blur);
  vec3 mirrored = 0.5 * (low.mirrored + high.mirrored);
  float mirrored_share = 0.5 * (low.share + high.share);
  vec3 seen_light = 0.5 * (low.all + high.all);
  seen_light += shaded_sun_klx * sun_glitter(facets, seen, v, water.sun_direction, water.sun_radius_rad);

  float open = 1.0 - floor(0.5 * strain.w) / float(surf_foam_steps);  // what foam of the shore leaves
#if HAS_SHOALS && SHOWS_BENEATH
  if (ground.place.w > 0.0) open *= 1.0 - swash_foam(ground.place.xyz, lit.label_shift_m);
#endif
  bare *= open;
  float coverage = 1.0 - bare * bare_of_wakes(label_m, width_m);
  float foam = foam_opacity(coverage, label_m, width_m);
  vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
  vec3 foam_light = foam_albedo / pi * (water.sky_klx + shaded_sun_klx * max(dot(normal, water.sun_direction), 0.0));
  // Thick foam is lumpy.
  foam_light *= 1.0 + 0.16 * (1.0 - open) * foam_value(label_m, width_m);
  vec3 surface = mix(seen_light - mirrored, foam_light, foam);

  mirrored_share *= 1.0 - foam;
  light = vec4((1.0 - mirrored_share) * through_air(surface / max(1.0 - mirrored_share, 1e-3), ray, distance_m) +
                   (1.0 - foam) * mirrored, 1.0);
#if SHOWS_BENEATH
  if (ground.place.w > 0.0) {
    // The edge runs ahead and stays behind by the grain of the sand.
    float drop_m = surface_m.y - ground.place.y - 0.005 * max(foam_value(3.7 * label_m, 3.7 * width_m) + 1.0, 0.0);
    light.rgb = mix(ground.light, light.rgb, water_share(drop_m, distance_m));
  }
#endif
#if WATER_SHOW != 0
  light.rgb = debug_light(ray.y * distance_m + view.eye_height_m + earth_drop_m(label_m), slope, jacobian, coverage, width_m,
                          label_m, mod(floor(strain.w), 2.0));
#endif
}
