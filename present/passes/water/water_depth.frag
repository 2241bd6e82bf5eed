// The depth of the water that a picture shows, before its light.
uniform sampler2D depth_of;  // of the surface, reversed; 0: no water

void main() {
  float depth = texelFetch(depth_of, ivec2(gl_FragCoord.xy), 0).r;
  if (depth <= 0.0) discard;
  gl_FragDepth = depth;
}
