// Highlight points by least squares, as printed (H3): with N and H interpolated over a face from its corners, the place where
// they differ least; kept within `tolerance` of the face.
// In:  as highlights/highlight_points.cl, without a field.
// Out: records [capacity] in no order, count. Neighbours may both have a point on their edge, or neither: the host merges the
//      former, and the latter is lost. A least distance is a highlight only if N.H there is above least_n_dot_h.
#include "highlights/highlight_record.clh"

__kernel void least_squares_points(__global const float *restrict vertices, int pitch, __global const int *restrict faces,
                                   int face_count, __global const HighlightLight *restrict lights, int light_count,
                                   int first_light, float tolerance, float least_n_dot_h,
                                   __global HighlightRecord *restrict records, int capacity, __global int *restrict count) {
  const int face = (int)get_global_id(0);
  if (face >= face_count) return;
  const int corners[3] = {faces[face], faces[face_count + face], faces[2 * (size_t)face_count + face]};
  for (int l = 0; l < light_count; ++l) {
    const HighlightLight light = lights[l];
    float3 apart[3];  // N - H
    for (int i = 0; i < 3; ++i) {
      apart[i] = corner_vector(vertices, pitch, HIGHLIGHT_NORMAL, corners[i]) -
                 half_vector_at(&light, corner_vector(vertices, pitch, HIGHLIGHT_POSITION, corners[i]));
    }
    const float3 first = apart[1] - apart[0], second = apart[2] - apart[0];
    const float aa = dot(first, first), bb = dot(second, second), ab = dot(first, second);
    const float determinant = aa * bb - ab * ab;
    if (!(determinant > 1e-12f * aa * bb)) continue;
    const float a = -dot(first, apart[0]), b = -dot(second, apart[0]);
    float weights[3];
    weights[1] = (bb * a - ab * b) / determinant;
    weights[2] = (aa * b - ab * a) / determinant;
    weights[0] = 1.0f - weights[1] - weights[2];
    if (!(weights[0] >= -tolerance && weights[1] >= -tolerance && weights[2] >= -tolerance)) continue;
    float total = 0.0f;
    for (int i = 0; i < 3; ++i) total += weights[i] = fmax(weights[i], 0.0f);
    for (int i = 0; i < 3; ++i) weights[i] /= total;
    HighlightRecord record;
    record.face = face;
    record.light = first_light + l;
    // Whether the field turns with the surface, as seen along H.
    const float3 axis = half_vector_at(&light, corner_vector(vertices, pitch, HIGHLIGHT_POSITION, corners[0]));
    record.orientation = dot(cross(first, second), axis) < 0.0f ? -1 : 1;
    append_record(vertices, pitch, corners, weights, &light, least_n_dot_h, &record, records, capacity, count);
  }
}
