// How far the normal of each vertex is from the half vector, as a field of plane vectors that are zero where both are one.
// In:  vertices [HIGHLIGHT_VERTEX_ROWS][pitch] and lights (shared/highlights.h).
// Out: field [lights][2][pitch], masks [pitch]: bit l is set where field l points down (y < 0).
//      count [1]: 0 if this is the first launch of a search, for highlights/highlight_points.cl.
// The field is the normal as seen along H, p = (N.right, N.up), in a frame that turns with H from the middle of the mesh on
// without twist (parallel transport along the great arc from axis to H). Between vertices it is interpolated: then both faces
// of an edge see the same field there, so that no zero is lost between them or found twice. For constant H its zeros are
// exactly those of [n0 n1 n2] b ~ H (H3); else they differ by less than N itself does between vertices.
#include "shared/highlights.h"
#include "simd/lanes.clh"

// The half vector H = (L + V) / |L + V| of Blinn, for LANES places side by side (H3).
typedef struct {
  lanes x, y, z;
} Vectors;

INLINE Vectors unit_vectors(Vectors v) {
  // Exactly between eye and light there is no half vector: zero.
  const lanes scale = rsqrt(fmax(v.x * v.x + v.y * v.y + v.z * v.z, 1e-30f));
  const Vectors unit = {v.x * scale, v.y * scale, v.z * scale};
  return unit;
}

INLINE Vectors toward(const HighlightSource *source, Vectors place) {
  const Vectors way = {source->x - source->nearness * place.x, source->y - source->nearness * place.y,
                       source->z - source->nearness * place.z};
  return unit_vectors(way);
}

INLINE Vectors half_vector(const HighlightLight *light, Vectors place) {
  const Vectors l = toward(&light->source, place), v = toward(&light->eye, place);
  const Vectors sum = {l.x + v.x, l.y + v.y, l.z + v.z};
  return unit_vectors(sum);
}

INLINE Vectors load_vectors(__global const float *first, int pitch) {
  const Vectors v = {load_lanes(first), load_lanes(first + pitch), load_lanes(first + 2 * pitch)};
  return v;
}

INLINE lanes dot_constant(Vectors v, float x, float y, float z) { return v.x * x + v.y * y + v.z * z; }

// Bits where a < 0.
INLINE uint_lanes bit_where_negative(lanes a, uint bit) {
#if LANES == 1
  return a < 0.0f ? bit : 0u;
#else
  return as_uint_lanes(a < 0.0f) & bit;
#endif
}

__kernel void highlight_field(__global const float *restrict vertices, int pitch,
                              __global const HighlightLight *restrict lights, int light_count, int vectors_per_item,
                              int is_first, __global float *restrict field, __global uint *restrict masks,
                              __global int *restrict count) {
  const int item = (int)get_global_id(0);
  if (item == 0 && is_first != 0) *count = 0;
  const int end = min((item + 1) * vectors_per_item * LANES, pitch);
  for (int vertex = item * vectors_per_item * LANES; vertex < end; vertex += LANES) {
    const Vectors place = load_vectors(vertices + HIGHLIGHT_POSITION * pitch + vertex, pitch);
    const Vectors normal = load_vectors(vertices + HIGHLIGHT_NORMAL * pitch + vertex, pitch);
    uint_lanes mask = (uint_lanes)(0u);
    for (int l = 0; l < light_count; ++l) {
      const HighlightLight light = lights[l];
      lanes x = dot_constant(normal, light.right_x, light.right_y, light.right_z);
      lanes y = dot_constant(normal, light.up_x, light.up_y, light.up_z);
      if (light.is_constant == 0) {
        const Vectors h = half_vector(&light, place);
        const lanes axis_h = dot_constant(h, light.axis_x, light.axis_y, light.axis_z);
        const lanes normal_sum = dot_constant(normal, light.axis_x, light.axis_y, light.axis_z) + normal.x * h.x +
                                 normal.y * h.y + normal.z * h.z;
        // Where H points against its direction in the middle no turn is the shortest; any will do.
        const lanes share = normal_sum / fmax(1.0f + axis_h, 1e-6f);
        x -= share * dot_constant(h, light.right_x, light.right_y, light.right_z);
        y -= share * dot_constant(h, light.up_x, light.up_y, light.up_z);
      }
      store_lanes(x, field + (size_t)(2 * l) * pitch + vertex);
      store_lanes(y, field + (size_t)(2 * l + 1) * pitch + vertex);
      mask |= bit_where_negative(y, 1u << l);
    }
#if LANES == 1
    masks[vertex] = mask;
#else
    PASTE(vstore, LANES)(mask, 0, masks + vertex);
#endif
  }
}
