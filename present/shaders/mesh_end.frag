// The mean of a pixel's samples, over what lies behind it. Where meshes cover half of a pixel or more it has their
// depth.
uniform sampler2DMS samples_of;
uniform sampler2DMS depth_of;
uniform int sample_count;

out vec4 light;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = vec4(0.0);
  float nearest = 0.0, farthest = 1.0;
  for (int i = 0; i < sample_count; ++i) {
    sum += texelFetch(samples_of, pixel, i);
    float depth = texelFetch(depth_of, pixel, i).r;
    nearest = max(nearest, depth);
    farthest = min(farthest, depth);
  }
  if (sum.a == 0.0) discard;
  light = sum / float(sample_count);
  // A sample that no mesh covers has the depth of what lies behind, which is the farthest.
  gl_FragDepth = light.a >= 0.5 ? nearest : farthest;
}
