// Shape of the ocean's surface on a projected grid (Lee & Lee 2007, sections 3.4 and 3.5): labels from the grid's
// corners, displaced by the cascades and the Gerstner waves as far as shoals leave them, one pixel a vertex. A pass of its own, since software
// renderers share out pixels among cores and vertices not. All positions are relative to the eye, so that nothing
// loses digits far from the origin.

layout(location = 0) out vec4 place;   // place m relative to the eye; label x m
layout(location = 1) out vec4 facet;   // Gerstner waves' dh/dx, dh/dz at labels, their loss; label z m
layout(location = 2) out vec4 strain;  // Gerstner waves' d dx/dx, d dx/dz, d dz/dz

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

  Shares shares = shares_at(label);
  vec3 moved_m = vec3(0.0);
  for (int i = 0; i < CASCADES && 0.5 * spacing_m < waves.longest_wave_m[i]; ++i) {
    moved_m += shares.cascades[i] * textureLod(displacement_map, map_place(i, label), map_level(i, 0.5 * spacing_m)).xyz;
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
    float left = shares.gerstner_waves[int(dot(step(shape.band_ends, vec3(i)), vec3(1.0)))];
    amplitude_m *= left;
    shift_m *= left;
    float phase = dot(wave, label) + shape.phases[i / 4][i % 4];
    float cosine = cos(phase), sine = sin(phase);
    moved_m += vec3(-shift_m * sine * direction.x, amplitude_m * cosine, -shift_m * sine * direction.y);
    slope -= amplitude_m * sine * wave;
    gradient -= shift_m * k * cosine * vec3(direction.x * direction.x, direction.x * direction.y,
                                            direction.y * direction.y);
  }

  moved_m.y += ring_waves(label, spacing_m).x + wake_waves(label, 0.5 * spacing_m).x - earth_drop_m(label);
  float loss = 1.0 - drawn / max(shape.gerstner_mean_square, 1e-12);
  place = vec4(vec3(label.x, -shape.eye_height_m, label.y) + moved_m, label.x);
  facet = vec4(slope, loss, label.y);
  strain = vec4(gradient, 0.0);
}
