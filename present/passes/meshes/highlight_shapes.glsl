// Shapes of highlights in their box, -1 ... 1 each way, y up, as host/highlights/projectors/texture_shapes.h has them: distance
// from the rim in half widths, negative inside.
float segment_distance(vec2 p, vec2 a, vec2 b) {
  vec2 along = b - a;
  return distance(p, a + clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0) * along);
}

float turn(vec2 a, vec2 b) {
  return a.x * b.y - a.y * b.x;
}

float window_distance(vec2 q) {
  const float pane_middle = 0.54, pane_half = 0.46, rounding = 0.08;
  vec2 beyond = abs(abs(q) - pane_middle) - (pane_half - rounding);
  return length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - rounding;
}

// All ten sides are one in the fold from a tip to the next notch.
float star_distance(vec2 q) {
  const float fold_rad = 1.25663706;
  float angle_rad = dot(q, q) > 0.0 ? atan(q.x, q.y) : 0.0;
  float folded_rad = abs(angle_rad - fold_rad * round(angle_rad / fold_rad));
  vec2 p = length(q) * vec2(sin(folded_rad), cos(folded_rad));
  vec2 tip = vec2(0.0, 1.0), notch = 0.45 * vec2(sin(0.5 * fold_rad), cos(0.5 * fold_rad));
  return (turn(notch - tip, p - tip) > 0.0 ? 1.0 : -1.0) * segment_distance(p, tip, notch);
}

// A lens along y: within two arcs of one circle.
float streak_distance(vec2 q) {
  const float half_width = 0.22, radius = (1.0 + half_width * half_width) / (2.0 * half_width);
  vec2 p = abs(q);
  if (p.y * (radius - half_width) > p.x + radius - half_width) return distance(p, vec2(0.0, 1.0));
  return length(p + vec2(radius - half_width, 0.0)) - radius;
}

// Two discs, the cleft between them, and their outer tangents from the tip.
float heart_distance(vec2 q) {
  const vec2 tip = vec2(0.0, -1.0), lobe = vec2(0.46), cleft = vec2(0.0, 0.742842713);
  const vec2 touch = vec2(0.884684807, 0.126469170), outward = vec2(0.786453347, -0.617649685);
  vec2 p = vec2(abs(q.x), q.y), way = p - lobe;
  if (turn(outward, way) > 0.0 || turn(cleft - lobe, way) < 0.0) return length(way) - 0.54;
  float to_side = segment_distance(p, tip, touch);
  return dot(p - tip, outward) > 0.0 ? to_side : -min(to_side, distance(p, cleft));
}

float shape_distance(int shape, vec2 q) {
  if (shape == 1) return window_distance(q);
  if (shape == 2) return star_distance(q);
  if (shape == 3) return abs(length(q) - 0.8) - 0.2;
  if (shape == 4) return streak_distance(q);
  if (shape == 5) return heart_distance(q);
  return length(q) - 1.0;
}

// How opaque a shape is: 0 at its rim, 1 from this softness or its depth inward, and over a pixel and a half at
// least.
float shape_opacity(int shape, vec2 q, float softness, float depth) {
  float inward = -shape_distance(shape, q);
  float pixel = length(vec2(dFdx(inward), dFdy(inward)));
  return smoothstep(0.0, max(min(softness, depth), 1.5 * pixel), inward);
}
