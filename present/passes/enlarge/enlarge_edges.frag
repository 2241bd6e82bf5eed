// Where edges run in a picture: squares of its gradient, by Sobel's differences, which filters may mix.
uniform sampler2D picture;  // as a screen shows it

out vec4 edge;  // xx, xy, yy

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
  edge = vec4(gradient.x * gradient.x, gradient.x * gradient.y, gradient.y * gradient.y, 0.0);
}
