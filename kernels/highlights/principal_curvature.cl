// Principal curvatures and directions from the averaged tensors of vertices (H2): the eigenvalues across the normal, the
// larger of which belongs to the direction in which the surface bends less.
// In:  positions_m [vertices][3]; first [vertices]: the vertex that stands for all at its place; edges_begin
//      [vertices + 1], neighbours; shares [vertices] (tensor m, area m^2) after `rounds` of averaging; ring_normals
//      [vertices] (unit, area m^2).
// Out: curvatures [vertices]: k_max, k_min 1/m (convex positive), area m^2, confidence 0 ... 1;
//      e_max [vertices]: unit direction of k_max, 0; e_min is normal x e_max;
//      normals [vertices]: unit, 0. All 0 where a vertex has no surface, but the area.

// Angles of this size over an edge are rounding.
#define FLAT_RAD 1e-5f
#define BORDER_CONFIDENCE 0.5f

// Where averaging has brought shares from: the mean square of the distance along a direction. A round moves six parts of
// seven by an edge; at first, edges reach to their middles.
static float spread_along(float3 direction, float3 middle, __global const float *restrict positions_m,
                          __global const uint *restrict neighbours, uint begin, uint end, int rounds) {
  float sum = 0.0f;
  for (uint i = begin; i < end; ++i) {
    const float along = dot(direction, vload3(neighbours[i], positions_m) - middle);
    sum += along * along;
  }
  return (0.25f + rounds * 6.0f / 7.0f) * sum / (float)(end - begin);
}

__kernel void principal_curvature(__global const float *restrict positions_m, __global const uint *restrict first,
                                  __global const uint *restrict edges_begin, __global const uint *restrict neighbours,
                                  __global const uchar *restrict on_border, __global const float8 *restrict shares,
                                  __global const float4 *restrict ring_normals, int rounds,
                                  __global float4 *restrict curvatures, __global float4 *restrict e_max,
                                  __global float4 *restrict normals) {
  const size_t vertex = get_global_id(0);
  const uint source = first[vertex];
  const float8 share = shares[source];
  const float3 normal = ring_normals[source].xyz;
  const float area_m2 = ring_normals[source].w;
  if (!(share.s6 > 0.0f) || !(dot(normal, normal) > 0.5f)) {
    curvatures[vertex] = (float4)(0.0f, 0.0f, area_m2, 0.0f);
    e_max[vertex] = (float4)(0.0f);
    normals[vertex] = (float4)(0.0f);
    return;
  }
  // A frame u, w, normal: Duff et al. 2017, "Building an orthonormal basis, revisited".
  const float sign = copysign(1.0f, normal.z), a = -1.0f / (sign + normal.z), b = normal.x * normal.y * a;
  const float3 u = (float3)(1.0f + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
  const float3 w = (float3)(b, sign + normal.y * normal.y * a, -normal.y);
  const float8 mean = share / share.s6;
  const float3 of_u = (float3)(dot(mean.s012, u), dot(mean.s134, u), dot(mean.s245, u));
  const float3 of_w = (float3)(dot(mean.s012, w), dot(mean.s134, w), dot(mean.s245, w));
  const float middle = 0.5f * (dot(u, of_u) + dot(w, of_w)), half_difference = 0.5f * (dot(u, of_u) - dot(w, of_w));
  const float across = dot(w, of_u), root = sqrt(half_difference * half_difference + across * across);
  // The half angle of (half_difference, across), from whichever of its cosine and sine is not small: the direction of the
  // larger eigenvalue, which is that of the smaller curvature.
  float cosine = 1.0f, sine = 0.0f;
  if (root > 0.0f) {
    const float large = sqrt(0.5f * (1.0f + fabs(half_difference) / root)), small = 0.5f * across / (root * large);
    cosine = half_difference >= 0.0f ? large : fabs(small);
    sine = half_difference >= 0.0f ? small : copysign(large, small);
  }
  const float3 along_min = cosine * u + sine * w, along_max = sine * u - cosine * w;

  // Edges away from the vertex lean out of its tangent plane: at x along e, whose curvature is k, they lose k^2 x^2 of what
  // bends across e. Where that is much, the region is no small part of the surface.
  float k_max = middle + root, k_min = middle - root;
  const uint begin = edges_begin[source], end = edges_begin[source + 1];
  const float3 here_m = vload3(source, positions_m);
  const float max_loss =
      fmin(0.25f, spread_along(along_min, here_m, positions_m, neighbours, begin, end, rounds) * k_min * k_min);
  const float min_loss =
      fmin(0.25f, spread_along(along_max, here_m, positions_m, neighbours, begin, end, rounds) * k_max * k_max);
  const float straight_max = k_max * (1.0f + max_loss), straight_min = k_min * (1.0f + min_loss);
  if (straight_max >= straight_min) {
    k_max = straight_max;
    k_min = straight_min;
  }
  const float edge_m = fast_length(vload3(neighbours[begin], positions_m) - here_m);
  const float confidence = (k_max - k_min) / (fabs(k_max) + fabs(k_min) + FLAT_RAD / fmax(edge_m, FLT_MIN));
  curvatures[vertex] =
      (float4)(k_max, k_min, area_m2, confidence * (on_border[source] ? BORDER_CONFIDENCE : 1.0f));
  e_max[vertex] = (float4)(along_max, 0.0f);
  normals[vertex] = (float4)(normal, 0.0f);
}
