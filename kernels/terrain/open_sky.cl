// How much of the sky's light reaches posts: of what a slope of theirs would get where nothing stands in front of it. The
// horizon of each post, in eight directions, is found by walks through the pyramid; between them, and from the horizon up,
// the sky is alike, and its light on the slope is integrated in closed form. Directions of neighbouring posts lie between
// each other, so that what is interpolated between four posts has seen 32.
// In:  heights [rows][columns] m, maxima, field (shared/terrain.h); stride, posts from one share to the next.
// Out: shares [share_rows][share_columns] of posts at multiples of the stride and of the last ones, 255 for all the light.
#include "terrain/sky_light.clh"
#include "terrain/traversal.clh"

#define DIRECTIONS 8
#define PI 3.14159265f
// Walks begin so far above the ground, in the smaller side of a cell: rounding of places is 1e-6 of it.
#define HORIZON_LIFT 0.001f

__kernel void open_sky(__global const float *restrict heights_m, __global const float *restrict maxima_m, TerrainField field,
                       int stride, int share_columns, __global uchar *restrict shares) {
  const Terrain terrain = {heights_m, maxima_m, field};
  const int first = (int)get_global_id(0) * LANES, share_row = (int)get_global_id(1);
  const int_lanes share_column = first + convert_int_lanes((lanes)LANE_INDEX);
  const int_lanes post_x = up_to(share_column * stride, field.cells_x);
  const int_lanes post_z = (int_lanes)min(share_row * stride, field.cells_z);
  const lanes height_m = gathered(heights_m, post_z * field.columns + post_x);
  const Slopes slopes = slopes_of_post(heights_m, field, post_x, post_z, (int_lanes)stride, (int_lanes)-1);
  const lanes up = rsqrt(1.0f + slopes.x * slopes.x + slopes.z * slopes.z);
  const lanes origin_m = height_m + HORIZON_LIFT / max(field.cells_per_m_x, field.cells_per_m_z);
  const int_lanes level = level_at_origin(terrain, post_x, post_z, origin_m);
  const lanes turn = convert_lanes((share_column & 1) + 2 * (share_row & 1)) * 0.25f;
  lanes sum = (lanes)0.0f, whole = (lanes)0.0f;
  for (int i = 0; i < DIRECTIONS; ++i) {
    const lanes azimuth = (2.0f * PI / DIRECTIONS) * ((float)i + turn);
    const lanes east = cos(azimuth), south = sin(azimuth);
    const lanes slope = slopes.x * east + slopes.z * south;
    // The sky ends at a level horizon, and where the slope turns away.
    const lanes least_rise = fmax(slope, (lanes)1e-6f);
    const Rays rays = {post_x,
                       post_z,
                       (lanes)0.0f,
                       (lanes)0.0f,
                       origin_m,
                       (lanes)0.0f,
                       east * field.cells_per_m_x,
                       south * field.cells_per_m_z,
                       (lanes)0.0f,
                       (lanes)0.0f,
                       least_rise,
                       (lanes)FARTHEST_M};
    const RaySetup ray_setup = ray_setup_of(field, rays);
    const lanes horizon = horizon_of(terrain, ray_setup, level_at_start(field, ray_setup, level));
    sum += sky_light_above(horizon, slope, up);
    whole += sky_light_above(fmax(slope, (lanes)0.0f), slope, up);
  }
  float values[LANES];
  store_lanes(clamp(sum / whole, (lanes)0.0f, (lanes)1.0f), values);
  for (int lane = 0; lane < min(LANES, share_columns - first); ++lane) {
    shares[(size_t)share_row * share_columns + first + lane] = (uchar)(255.0f * values[lane] + 0.5f);
  }
}
