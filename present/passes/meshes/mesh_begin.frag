// What lies behind the meshes gives their samples its depth and its light.
uniform sampler2D depth_behind;
uniform sampler2D light_behind;

out vec4 light;  // alpha: whether a mesh covers the sample

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  light = vec4(texelFetch(light_behind, pixel, 0).rgb, 0.0);
  gl_FragDepth = texelFetch(depth_behind, pixel, 0).r;
}
