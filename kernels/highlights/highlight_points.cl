// The faces in which the field of highlights/highlight_field.cl is zero, each with the place of its zero (H3).
// In:  vertices [HIGHLIGHT_VERTEX_ROWS][pitch], faces [3][face_count] (corners), lights, field [lights][2][pitch], masks [pitch].
// Out: records [capacity] in no order, count: how many there are, also where they are more than the capacity.
// A face has the zero where exactly one of its edges crosses the ray of the points (x > 0, y = 0) of the field's plane. Whether
// an edge does is decided from its two ends alone, the lower one first, so that both its faces agree to the last bit, and
// any number of them: whatever the rounding, the faces around a closed surface cover the zero as often as a continuous field
// would, and a zero on an edge or in a vertex is in one face. A field with y = 0 counts as above the ray, a crossing
// in zero itself as left of it, as if all fields were moved by an infinitely small step.
#include "highlights/highlight_record.clh"

// a b - c d with the sign of the exact value (Kahan; the error is at most 1.5 ulp: Jeannerod, Louvet & Muller 2013).
static float difference_of_products(float a, float b, float c, float d) {
  const float product = c * d;
  const float error = fma(-c, d, product);
  return fma(a, b, -product) + error;
}

// Zeros of N = -H are none, nor are those that the field has where H points against its direction in the middle of the mesh.
#define LEAST_N_DOT_H 0.5f

static void find_zero(__global const float *vertices, int pitch, const int *corners, __global const HighlightLight *lights,
                      int light_index, __global const float *field, HighlightRecord *record,
                      __global HighlightRecord *records, int capacity, __global int *count) {
  __global const float *field_x = field + (size_t)(2 * light_index) * pitch;
  __global const float *field_y = field_x + pitch;
  float x[3], y[3];
  for (int i = 0; i < 3; ++i) {
    x[i] = field_x[corners[i]];
    y[i] = field_y[corners[i]];
  }
  // Most faces that reach across y = 0 do so on one side: no edge crosses the ray, or two.
  if (fmax(fmax(x[0], x[1]), x[2]) <= 0.0f || fmin(fmin(x[0], x[1]), x[2]) > 0.0f) return;
  int crossings = 0, orientation = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    if ((y[i] < 0.0f) == (y[j] < 0.0f)) continue;
    const int low = y[i] < 0.0f ? i : j, high = y[i] < 0.0f ? j : i;
    if (!(difference_of_products(x[low], y[high], y[low], x[high]) > 0.0f)) continue;
    ++crossings;
    orientation = low == i ? 1 : -1;
  }
  if (crossings != 1) return;
  float weights[3];
  float total = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
    // Rounding may leave a weight below zero where the point is on an edge.
    weights[i] = fmax(difference_of_products(x[j], y[k], y[j], x[k]) * (float)orientation, 0.0f);
    total += weights[i];
  }
  for (int i = 0; i < 3; ++i) weights[i] = total > 0.0f ? weights[i] / total : 1.0f / 3.0f;
  const HighlightLight light = lights[light_index];
  record->orientation = orientation;
  append_record(vertices, pitch, corners, weights, &light, LEAST_N_DOT_H, record, records, capacity, count);
}

__kernel void highlight_points(__global const float *restrict vertices, int pitch, __global const int *restrict faces,
                               int face_count, int faces_per_item, __global const HighlightLight *restrict lights,
                               int first_light, __global const float *restrict field, __global const uint *restrict masks,
                               __global HighlightRecord *restrict records, int capacity, __global int *restrict count) {
  const int item = (int)get_global_id(0);
  const int end = min((item + 1) * faces_per_item, face_count);
  for (int face = item * faces_per_item; face < end; ++face) {
    const int corners[3] = {faces[face], faces[face_count + face], faces[2 * (size_t)face_count + face]};
    const uint a = masks[corners[0]], b = masks[corners[1]], c = masks[corners[2]];
    // Lights for which the face reaches across y = 0.
    for (uint mixed = (a | b | c) & ~(a & b & c); mixed != 0u; mixed &= mixed - 1u) {
      const int light = 31 - (int)clz(mixed & (0u - mixed));
      HighlightRecord record;
      record.face = face;
      record.light = first_light + light;
      find_zero(vertices, pitch, corners, lights, light, field, &record, records, capacity, count);
    }
  }
}
