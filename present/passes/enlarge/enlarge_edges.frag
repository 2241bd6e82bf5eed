// Where edges run in a picture: the direction of its gradient, by Sobel's differences, at twice its angle, so that
// filters may mix opposite ones.
uniform sampler2D picture;  // as a screen shows it

out vec4 edge;  // red and green: as long as all gradients here point one way, 0 ... 1, from -1 ... 1

// Brightness differences below this are noise rather than edges, as squares of Sobel's sums.
const float faintest = 1.0e-3;

float brightness(ivec2 pixel) {
  ivec2 last = textureSize(picture, 0) - 1;
  return dot(texelFetch(picture, clamp(pixel, ivec2(0), last), 0).rgb, vec3(0.3, 0.59, 0.11));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float left = 0.0, right = 0.0, below = 0.0, above = 0.0;
  for (int i = -1; i <= 1; ++i) {
    float weight = i == 0 ? 2.0 : 1.0;
    left += weight * brightness(pixel + ivec2(-1, i));
    right += weight * brightness(pixel + ivec2(1, i));
    below += weight * brightness(pixel + ivec2(i, -1));
    above += weight * brightness(pixel + ivec2(i, 1));
  }
  vec2 gradient = vec2(right - left, above - below);
  vec2 turned = vec2(gradient.x * gradient.x - gradient.y * gradient.y, 2.0 * gradient.x * gradient.y);
  edge = vec4(0.5 + 0.5 * turned / (dot(gradient, gradient) + faintest), 0.0, 1.0);
}
