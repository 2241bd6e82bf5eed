// How a surface bends about each vertex: half of each edge's angle * length * e e^T, a third of each face's area (Alliez et
// al. 2003, H1 with the smallest region); and its normal, the mean of the faces around by area.
// In:  positions_m [vertices][3]; face_normals [faces] (unit, area m^2) of highlights/face_normal.cl;
//      faces_begin [vertices + 1], faces: those around each vertex;
//      edges_begin [vertices + 1], neighbours: the other ends of its edges, and beside each
//      sides: the face that runs from the vertex to the neighbour and the other one, as ~face where it has to be
//      turned over to agree; the edge does not bend where both are one, as on borders.
// Out: shares [vertices] (xx, xy, xz, yy, yz, zz in m, area m^2, 0), divided by the edges and one, ready to be averaged;
//      normals [vertices]: unit vector, area m^2; all 0 where nothing is around.

// What a vertex with an edge that does not bend counts beside others: it misses a part of its tensor, but is better
// than nothing.
#define BORDER_WEIGHT 1e-6f

// What atan2's series leaves out is t^10 / 11 of the angle, less than a bit.
static float angle_of(float sine, float cosine) {
  const float t = sine / (1.0f + cosine), t2 = t * t;
  if (!(fabs(t) < 0.125f)) return atan2(sine, cosine);
  return 2.0f * t * (1.0f - t2 * (1.0f / 3 - t2 * (1.0f / 5 - t2 * (1.0f / 7 - t2 / 9))));
}

static float3 normal_of(__global const float4 *restrict face_normals, int side) {
  return side < 0 ? -face_normals[~side].xyz : face_normals[side].xyz;
}

__kernel void ring_tensor(__global const float *restrict positions_m, __global const float4 *restrict face_normals,
                          __global const uint *restrict faces_begin, __global const uint *restrict faces,
                          __global const uint *restrict edges_begin, __global const uint *restrict neighbours,
                          __global const int2 *restrict sides, __global float8 *restrict shares,
                          __global float4 *restrict normals) {
  const size_t vertex = get_global_id(0);
  float3 normal = (float3)(0.0f);
  float4 largest = (float4)(0.0f);
  float area = 0.0f;
  for (uint i = faces_begin[vertex]; i < faces_begin[vertex + 1]; ++i) {
    const float4 face = face_normals[faces[i]];
    normal += face.w * face.xyz;
    area += face.w;
    largest = face.w > largest.w ? face : largest;
  }
  const float normal_length = length(normal);
  area /= 3.0f;

  const float3 middle = vload3(vertex, positions_m);
  float3 diagonal = (float3)(0.0f), others = (float3)(0.0f);
  float weight = 1.0f;
  for (uint i = edges_begin[vertex]; i < edges_begin[vertex + 1]; ++i) {
    const int2 side = sides[i];
    if (side.x == side.y) {
      weight = BORDER_WEIGHT;
      continue;
    }
    const float3 along = vload3(neighbours[i], positions_m) - middle;
    const float edge_length = length(along);
    if (!(edge_length > 0.0f)) continue;
    const float3 left = normal_of(face_normals, side.x), right = normal_of(face_normals, side.y);
    const float angle = angle_of(dot(cross(left, right), along) / edge_length, dot(left, right));
    const float3 scaled = (0.5f * angle / edge_length) * along;
    diagonal += scaled * along;
    others += scaled.xxy * along.yzz;
  }
  weight /= (float)(edges_begin[vertex + 1] - edges_begin[vertex] + 1);
  shares[vertex] = weight * (float8)(diagonal.x, others.x, others.y, diagonal.y, others.z, diagonal.z, area, 0.0f);
  // Faces back to back cancel but for rounding: then one of them has to do.
  normals[vertex] = (float4)(normal_length > 1e-5f * area ? normal / normal_length : largest.xyz, area);
}
