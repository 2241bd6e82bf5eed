// Shape of the ocean's surface on a projected grid (Lee & Lee 2007, sections 3.4 and 3.5): labels from the grid's
// corners, displaced by the cascades and the Gerstner waves as far as shoals leave them, one pixel a vertex. A pass of its own, since software
// renderers share out pixels among cores and vertices not. All positions are relative to the eye, so that nothing
// loses digits far from the origin.

layout(location = 0) out vec4 place;   // place m relative to the eye; label x m
layout(location = 1) out vec4 facet;   // Gerstner waves' dh/dx, dh/dz at labels, their loss; label z m
layout(location = 2) out vec4 strain;  // Gerstner waves' d dx/dx, d dx/dz, d dz/dz; foam of waves that break on the shore

#if HAS_SHOALS
uniform sampler2DArray gradient_map;  // dh/dx, dh/dz, d dx/dx, d dz/dz

// Waves break where they stand as high as this share of the depth (McCowan 1894).
const float breaking_height = 0.78;

// Foam of breaking waves, by the waves of the open sea: their height and its slope along their travel at this label.
// Both tell the amplitude of the wave and how long ago its crest went by; foam stays behind.
float surf_foam(float depth_m, float height_m, float slope) {
  if (waves.surf.w <= 0.0) return 0.0;
  float along_m = slope / waves.surf.z;
  float wave_m = 2.0 * length(vec2(height_m, along_m));
  float broken = smoothstep(0.9, 1.3, wave_m / (breaking_height * max(depth_m, 0.02)));
  // From the front of the crest on, in turns.
  float since = fract(atan(along_m, height_m) / 6.2831853 + 0.12);
  // Low waves lap: they have no air in them.
  float airy = smoothstep(0.08, 0.4, waves.surf.w);
  return airy * broken * smoothstep(0.0, 0.1, since) * (0.65 * exp(-since / 0.12) + 0.25 * exp(-since / 0.6));
}
#endif

// Rows lie closer toward the horizon, where waves hide one another.
float row_place(float row) {
  float rest = 1.0 - row / float(shape.cells.y);
  return 1.0 - rest * rest;
}

// Label at a place of the grid, x across and y along.
vec2 grid_label(vec2 place) {
  vec3 point = mix(mix(shape.corners[0].xyz, shape.corners[1].xyz, place.x),
                   mix(shape.corners[2].xyz, shape.corners[3].xyz, place.x), place.y);
  return point.xy / point.z;
}

void main() {
  float row = floor(gl_FragCoord.y);
  float across = floor(gl_FragCoord.x) / float(shape.cells.x);
  vec2 label = grid_label(vec2(across, row_place(row)));
  vec2 beside = grid_label(vec2(across + 1.0 / float(shape.cells.x), row_place(row)));
  vec2 below = grid_label(vec2(across, row_place(max(row - 1.0, 0.0))));
  vec2 above = grid_label(vec2(across, row_place(max(row, 1.0))));
  float spacing_m = max(distance(label, beside), distance(below, above));

  float depth_m = still_depth_m(label);
#if HAS_SHOALS
  Shares shares = shares_of_depth(depth_m);
#else
  Shares shares = shares_at(label);
#endif
  vec3 open = vec3(0.0);  // of the sea without shoals: height, its slopes
  vec3 moved_m = vec3(0.0);
  for (int i = 0; i < CASCADES && 0.5 * spacing_m < waves.longest_wave_m[i]; ++i) {
    vec3 map_point = map_place(i, label);
    vec3 cascade_m = textureLod(displacement_map, map_point, map_level(i, 0.5 * spacing_m)).xyz;
    moved_m += shares.cascades[i] * cascade_m;
#if HAS_SHOALS
    // Of waves shorter than a quarter of the mean, slopes tell nothing of crests.
    float width_m = max(spacing_m, 0.8 / waves.surf.z);
    open.x += cascade_m.y;
    open.yz += textureLod(gradient_map, map_point, map_level(i, width_m)).xy;
#endif
  }

  vec2 slope = vec2(0.0);
  vec3 gradient = vec3(0.0);
  float drawn = 0.0;  // mean square slope
  for (int i = 0; i < shape.wave_count; ++i) {
    vec2 wave = shape.waves[i].xy;
    float k = length(wave);
    vec2 direction = wave / k;
    float share = shown_share(6.2831853 / (k * spacing_m));
    if (share == 0.0) continue;
    float amplitude_m = share * shape.waves[i].z, shift_m = share * shape.waves[i].w;
    drawn += 0.5 * k * k * amplitude_m * amplitude_m;
    float open_m = amplitude_m;
    float left = shares.gerstner_waves[int(dot(step(shape.band_ends, vec3(i)), vec3(1.0)))];
    amplitude_m *= left;
    shift_m *= left;
    float phase = dot(wave, label) + shape.phases[i / 4][i % 4];
    float cosine = cos(phase), sine = sin(phase);
    moved_m += vec3(-shift_m * sine * direction.x, amplitude_m * cosine, -shift_m * sine * direction.y);
    slope -= amplitude_m * sine * wave;
    open += open_m * vec3(cosine, -sine * wave);
    gradient -= shift_m * k * cosine * vec3(direction.x * direction.x, direction.x * direction.y,
                                            direction.y * direction.y);
  }

  moved_m.y += ring_waves(label, spacing_m).x + wake_waves(label, 0.5 * spacing_m).x - earth_drop_m(label);
  float foam = 0.0;
#if HAS_SHOALS
  if (waves.swash_reach_m > 0.0) moved_m.y += swash_share(depth_m) * swash_level_m(label, 0.0, SWASH_WAVES);
  foam = surf_foam(depth_m, open.x, dot(open.yz, waves.surf.xy));
#endif
  float loss = 1.0 - drawn / max(shape.gerstner_mean_square, 1e-12);
  place = vec4(vec3(label.x, -shape.eye_height_m, label.y) + moved_m, label.x);
  facet = vec4(slope, loss, label.y);
  strain = vec4(gradient, foam);
}
