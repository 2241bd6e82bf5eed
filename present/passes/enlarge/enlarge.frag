// A smaller picture, enlarged: at each place a filter of 16 pixels that is drawn out along the edge there, so that
// edges stay sharp across and smooth along them (after Lottes 2021, AMD FidelityFX Super Resolution 1). Of a picture 3.3
// times as small, its error is 0.75 of that of bilinear interpolation, and 0.82 if the edges are ragged
// (tests/present/passes/enlarge_pass_test.cpp).
uniform sampler2D picture;  // as a screen shows it
uniform sampler2D edges;    // enlarge_edges.frag

in vec2 clip;
out vec4 colour;

// Brightness differences below this are noise rather than edges, as squares of Sobel's sums.
const float faintest = 1.0e-3;

void main() {
  vec2 size = vec2(textureSize(picture, 0));
  vec2 place = (0.5 + 0.5 * clip) * size;
  vec3 square = textureLod(edges, place / size, 0.0).xyz;
  // The tensor's greater eigenvector points across the edge.
  float middle = 0.5 * (square.x - square.z), root = sqrt(middle * middle + square.y * square.y);
  vec2 across = middle >= 0.0 ? vec2(root + middle, square.y) : vec2(square.y, root - middle);
  across = dot(across, across) > 1.0e-12 ? normalize(across) : vec2(1.0, 0.0);
  float edge = 2.0 * root / (square.x + square.z + faintest);  // 0: none, 1: all gradients point one way

  // With an edge the filter is longer along it and has deeper lobes across: the values with the least errors there.
  float along_scale = 1.0 - 0.6 * edge, lobe = mix(0.5, 0.2, edge), farthest = 1.0 / lobe;
  vec2 first = floor(place - 0.5);
  ivec2 last = ivec2(size) - 1;
  vec3 sum = vec3(0.0), low = vec3(1.0), high = vec3(0.0);
  float weights = 0.0;
  for (int i = 0; i < 16; ++i) {
    ivec2 tap = ivec2(i & 3, i >> 2) - 1;
    vec2 away = first + vec2(tap) + 0.5 - place;
    vec2 turned = vec2(dot(away, across), dot(away, vec2(-across.y, across.x)) * along_scale);
    float far = min(dot(turned, turned), farthest);
    float base = 0.4 * far - 1.0, window = lobe * far - 1.0;
    float weight = (1.5625 * base * base - 0.5625) * window * window;
    vec3 texel = texelFetch(picture, clamp(ivec2(first) + tap, ivec2(0), last), 0).rgb;
    sum += weight * texel;
    weights += weight;
    bool is_inner = tap.x >= 0 && tap.x <= 1 && tap.y >= 0 && tap.y <= 1;
    if (is_inner) {
      low = min(low, texel);
      high = max(high, texel);
    }
  }
  // Lobes would ring beside bright edges.
  colour = vec4(clamp(sum / weights, low, high), 1.0);
}
