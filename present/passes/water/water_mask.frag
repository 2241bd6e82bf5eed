// Which pixels show water: a depth of 1, else 0. Drivers that draw on the CPU skip what fails a test of depths, but neither
// branches nor what shaders discard.
uniform sampler2D depth_of;     // of the surface, reversed; 0: no water
uniform sampler2D shown_depth;  // of what the picture shows

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depth_of, pixel, 0).r;
  gl_FragDepth = depth > 0.0 && depth == texelFetch(shown_depth, pixel, 0).r ? 1.0 : 0.0;
}
