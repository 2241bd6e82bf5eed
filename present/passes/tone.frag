// From scene-linear light to the screen: exposure, a filmic curve, sRGB; the one place where this happens.
uniform sampler2D picture;  // kcd/m2

in vec2 clip;
out vec4 colour;

// Narkowicz 2016, a fit to the reference tone curve of the Academy Color Encoding System.
vec3 filmic(vec3 x) {
  return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

vec3 srgb(vec3 linear) {
  return mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
}

// Steps of 8 bits would show in a clear sky: less than one step of fixed noise hides them (Jimenez 2014).
float dither() {
  return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
}

void main() {
  vec3 linear = tone.exposure * texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb;
  if (tone.is_filmic == 1) linear = filmic(linear);
  colour = vec4(srgb(linear) + dither() / 255.0, 1.0);
}
