// The sky-view factor of posts: the light that the ground at a post gets from a sky that is alike everywhere, as a share of
// what level ground in the open gets. Light counts by the cosine to the ground's normal. From the horizon up it is integrated
// in closed form, between azimuths by the trapezoid rule.
// In:  heights [rows][columns] m, field (shared/terrain.h); directions and horizons [azimuths] of terrain/horizons.cl; the
//      first of the band's rows.
// Out: factors [rows][stride], 0 ... 1.
// A work-item takes LANES columns of a row.
#include "terrain/sky_light.clh"

__kernel void sky_view(__global const float *restrict heights_m, TerrainField field, __global const float *restrict directions,
                       __global const float *restrict rises, int azimuths, int first_row, int rows, int stride,
                       __global float *restrict factors) {
  const int first = (int)get_global_id(0) * LANES, row = (int)get_global_id(1);
  if (first >= stride) return;
  const int_lanes column = up_to(first + convert_int_lanes((lanes)LANE_INDEX), field.cells_x);
  const Slopes slopes = slopes_of_post(heights_m, field, column, (int_lanes)(first_row + row), (int_lanes)1, (int_lanes)-1);
  const lanes up = rsqrt(1.0f + slopes.x * slopes.x + slopes.z * slopes.z);
  const size_t place = (size_t)row * stride + first;
  lanes sum = (lanes)0.0f;
  for (int i = 0; i < azimuths; ++i) {
    const lanes slope = slopes.x * directions[2 * i] + slopes.z * directions[2 * i + 1];
    const lanes horizon = load_lanes(rises + (size_t)i * rows * stride + place);
    // The sky also ends where the slope turns away.
    sum += sky_light_above(most(horizon, slope), slope, up);
  }
  store_lanes(sum * (2.0f / (float)azimuths), factors + place);
}
