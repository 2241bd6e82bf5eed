// What lies behind the meshes gives their samples its depth.
uniform sampler2D depth_behind;

out vec4 light;

void main() {
  light = vec4(0.0);
  gl_FragDepth = texelFetch(depth_behind, ivec2(gl_FragCoord.xy), 0).r;
}
