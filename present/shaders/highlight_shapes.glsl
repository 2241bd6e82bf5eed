// Shapes of highlights in their box, -1 ... 1 each way, y up: distance from the rim in half widths, below 0 inside.
float disc_distance(vec2 q, float radius) {
  return length(q) - radius;
}

// Four panes with bars between.
float window_distance(vec2 q) {
  const float half_side = 0.95, corner = 0.12, half_bar = 0.08;
  vec2 over = abs(q) - (half_side - corner);
  float frame = length(max(over, 0.0)) + min(max(over.x, over.y), 0.0) - corner;
  return max(frame, half_bar - min(abs(q.x), abs(q.y)));
}

// Five points, one of them up. Each tenth of the star is bounded by a line from a tip to a notch.
float star_distance(vec2 q) {
  const float tenth_rad = 0.62831853, notch = 0.45;
  float angle_rad = abs(mod(atan(q.x, q.y) + tenth_rad, 2.0 * tenth_rad) - tenth_rad);
  vec2 folded = length(q) * vec2(sin(angle_rad), cos(angle_rad));
  vec2 tip = vec2(0.0, 1.0), line = notch * vec2(sin(tenth_rad), cos(tenth_rad)) - tip;
  return dot(folded - tip, normalize(vec2(-line.y, line.x)));
}

// A lens along x.
float streak_distance(vec2 q) {
  const float half_height = 0.25;
  return (abs(q.y) - half_height * (1.0 - q.x * q.x)) * inversesqrt(1.0 + 4.0 * half_height * half_height * q.x * q.x);
}

// Each half is a disc with its two tangents from the tip.
float heart_distance(vec2 q) {
  const vec2 tip = vec2(0.0, -0.95), middle = vec2(0.46, 0.38);
  const float radius = 0.5;
  vec2 axis = middle - tip;
  float reach = length(axis);
  axis /= reach;
  vec2 p = vec2(abs(q.x), q.y) - tip;
  vec2 from_axis = vec2(abs(p.x * axis.y - p.y * axis.x), dot(p, axis));  // across and along it
  float sine = radius / reach, cosine = sqrt(1.0 - sine * sine);
  if (dot(from_axis, vec2(sine, cosine)) > reach * cosine) return length(p - reach * axis) - radius;
  return dot(from_axis, vec2(cosine, -sine));
}

const float deepest[6] = float[6](1.0, 0.435, 0.384, 0.29, 0.25, 0.5);

float shape_distance(int shape, vec2 q) {
  if (shape == 1) return window_distance(q);
  if (shape == 2) return star_distance(q);
  if (shape == 3) return abs(disc_distance(q, 0.71)) - deepest[3];
  if (shape == 4) return streak_distance(q);
  if (shape == 5) return heart_distance(q);
  return disc_distance(q, 1.0);
}

// How much of a pixel a shape covers whose rim is this soft: it grows from 0 at the rim inward, over a pixel at
// least, and to the shape's middle at most.
float shape_coverage(int shape, vec2 q, float softness) {
  float inside = -shape_distance(shape, q);
  float pixel = length(vec2(dFdx(inside), dFdy(inside)));
  float share = clamp(inside / max(min(softness, deepest[shape]), 1.5 * pixel), 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}
