// The mean of the samples of a pixel that meshes cover, at least in part. Where they cover half of it or more it
// has their depth.
uniform sampler2DMS samples_of;
uniform sampler2DMS depth_of;

out vec4 light;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 sum = vec3(0.0);
  float weights = 0.0, covered = 0.0, nearest = 0.0, farthest = 1.0;
  for (int i = 0; i < mesh_end.sample_count; ++i) {
    vec4 each = texelFetch(samples_of, pixel, i);
    // A screen shows light by its curve, not in proportion: without weights, one sample that is many times brighter
    // than white would make its pixel white, and edges before it ragged.
    float weight = mesh_end.is_layer == 1 ? 1.0 : 1.0 / (1.0 + mesh_end.exposure * max(each.r, max(each.g, each.b)));
    sum += weight * each.rgb;
    weights += weight;
    covered += each.a;
    float depth = texelFetch(depth_of, pixel, i).r;
    nearest = max(nearest, depth);
    farthest = min(farthest, depth);
  }
  if (covered == 0.0) discard;
  light = vec4(sum / weights, mesh_end.is_layer == 1 ? covered / weights : 1.0);
  // A sample that no mesh covers has the depth of what lies behind, which is the farthest.
  gl_FragDepth = 2.0 * covered >= float(mesh_end.sample_count) ? nearest : farthest;
}
