// A smaller picture, enlarged: even interpolation, evened out along the edge at each place, so that edges have no steps,
// and sharpened across it. Of a picture 3.3 times as small, its error is 0.88 of that of even interpolation, and 0.91 if
// the edges are ragged (tests/present/passes/enlarge_pass_test.cpp). A filter of 16 pixels is at 0.75 and 0.82 there, but
// takes three times as long, and is no nearer to whole pictures of shipped scenes.
uniform sampler2D picture;  // as a screen shows it
uniform sampler2D edges;    // enlarge_edges.frag

in vec2 clip;
out vec4 colour;

// How far along an edge pixels count as much as the place itself, in pixels, and how much edges are sharpened.
const float along_px = 1.0, sharpening = 0.5;

void main() {
  vec2 place = 0.5 + 0.5 * clip, a_pixel = 1.0 / vec2(textureSize(picture, 0));
  vec2 edge = 2.0 * texture(edges, place).xy - 1.0;
  float strength = length(edge);
  vec2 across = edge.x >= 0.0 ? vec2(strength + edge.x, edge.y) : vec2(edge.y, strength - edge.x);
  across *= inversesqrt(max(dot(across, across), 1.0e-12));
  vec2 along = along_px * strength * a_pixel * vec2(-across.y, across.x);
  across *= a_pixel;
  vec3 middle = 0.5 * texture(picture, place).rgb +
                0.25 * (texture(picture, place + along).rgb + texture(picture, place - along).rgb);
  vec3 one = texture(picture, place + across).rgb, other = texture(picture, place - across).rgb;
  // What is sharpened would ring beside bright edges.
  colour = vec4(clamp(middle + sharpening * (middle - 0.5 * (one + other)), min(middle, min(one, other)),
                      max(middle, max(one, other))), 1.0);
}
