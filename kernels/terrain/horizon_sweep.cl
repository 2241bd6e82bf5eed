// Which posts are seen from a point, for nearly all of them: from bounds of the horizon in thin wedges of ground.
//
// LANES rays go out from the eye side by side, the wedges lie between neighbours. An octant's rays cross its lines of
// posts one after the other, at `ahead` cells from the eye, and there lie at ahead * slope aside. In the picture (slope,
// height / ahead) that the eye has of the ground, all straight lines are straight, so are what is between two posts, and
// patches where they are cut at a distance. Therefore over a wedge
// - no ground is above a line that is above the ground along both rays, and above all posts between them;
// - the horizon is above the picture of each piece of ground between two posts that reaches across.
// A post that is above the first line is seen, if the last patch before it does not hide it, one below the second is
// hidden; the rest, some percent, is left to terrain/sight_walk.cl. Bounds keep clear of rounding.
//
// Where the horizon of all wedges is above what the highest target of the map can reach from there on, the rest of them is
// hidden.
//
// In:    heights [rows][columns] m, field (shared/terrain.h), sight (shared/terrain_sight.h).
// inout: seen [rows][columns], SIGHT_UNDECIDED -> SIGHT_HIDDEN or SIGHT_VISIBLE, or as it was.
// A work-item takes LANES - 1 wedges of the octant get_global_id(1).
#include "shared/terrain_sight.h"
#include "terrain/ray_setup.clh"

#if LANES == 16
#define next_lane(a) ((a).s123456789abcdeff)
#else
#define next_lane(a) ((a).s12345677)
#endif

// 16 roundings.
#define ROUNDING 1e-6f
#define NO_TERRAIN -1e30f

// An axis of the map from the eye on: line 0 is behind the eye by `fraction` cells.
typedef struct {
  int origin, step, last;  // index of line 0, 1 or -1, the last line
  float fraction;          // 0 ... 1
  float bend_m;            // at a cell's distance
} Axis;

INLINE Axis axis_of(int cell, float fraction, int cells, float bend_m, bool goes_up) {
  const bool is_at_end = cell == cells;
  const int first = is_at_end ? cell - 1 : cell;
  const float share = is_at_end ? 1.0f : fraction;
  const Axis up = {first, 1, cells - first, share, bend_m}, down = {first + 1, -1, first + 1, 1.0f - share, bend_m};
  return goes_up ? up : down;
}

INLINE lanes above_eye(TerrainSight sight, lanes height_m) { return (height_m - sight.eye_m) - sight.eye_rest_m; }

// Ground along rays between two crossings: from `from_m` at `from` cells to `to_m` at `to`, `bulge` s^2 among its terms.
// The highest that it is in the eye's picture, if that is at neither of them; from an eye on the ground on, its slope.
INLINE lanes highest_between(lanes from, lanes from_m, lanes to, lanes to_m, lanes bulge) {
  const lanes length = to - from, rise_m = to_m - from_m, arch_m = bulge * length * length;
  const int_lanes at_eye = mask_of(from == 0.0f) & mask_of(from_m == 0.0f);
  // Still rises in the picture where it begins, and falls where it ends.
  const int_lanes turns = mask_of(bulge < 0.0f) & mask_of((rise_m - arch_m) * from > from_m * length) &
                          mask_of((rise_m + arch_m) * to < to_m * length);
  if (!any_lane(turns | at_eye)) return (lanes)NO_TERRAIN;
  const lanes slope = (rise_m - arch_m) / most(length, (lanes)1e-6f);
  const lanes r = most(slope * from - from_m, (lanes)0.0f) / select((lanes)1.0f, -bulge, turns);
  const lanes way = least(r / (from + sqrt(from * from + r)), length);
  const lanes at_turn = (from_m + way * (slope + way * bulge)) / (from + way);
  return select(select((lanes)NO_TERRAIN, slope, at_eye), at_turn, turns);
}

// The least of h + f1 s + f2 s^2, s from 0 to `length`; of (f1 s + f2 s^2) / s where h is 0.
INLINE lanes least_clearance(float h, lanes f1, lanes f2, float length) {
  const lanes at_end = f1 + length * f2;
  if (h == 0.0f) return least(f1, at_end);
  const lanes turn = clamp(-0.5f * f1 / most(f2, (lanes)1e-30f), (lanes)0.0f, (lanes)length);
  return least(h + length * at_end, h + turn * (f1 + turn * f2));
}

// Hides the posts between two rays, from a line on: those that are within them by more than rounding.
INLINE void hide_rest(int first_line, int last_line, Axis major, Axis minor, int2 steps, int base, float first_slope,
                      float last_slope, __global uchar *restrict seen) {
  for (int line = first_line; line <= last_line; ++line) {
    const float ahead = (float)line - major.fraction, rounding = 1e-2f + 4e-7f * ahead;
    const int first = max((int)ceil(first_slope * ahead + minor.fraction + rounding), 0);
    const int last = min((int)floor(last_slope * ahead + minor.fraction - rounding), minor.last);
    for (int post = first; post <= last; ++post) seen[base + line * steps.x + post * steps.y] = SIGHT_HIDDEN;
  }
}

__kernel void horizon_sweep(__global const float *restrict heights_m, TerrainField field, TerrainSight sight,
                            __global uchar *restrict seen) {
  const int octant = (int)get_global_id(1);
  const bool goes_along_z = (octant & 1) != 0;
  const Axis axis_x = axis_of(sight.cell_x, sight.fraction_x, field.cells_x, sight.bend_x_m,
                              (octant & (goes_along_z ? 4 : 2)) == 0);
  const Axis axis_z = axis_of(sight.cell_z, sight.fraction_z, field.cells_z, sight.bend_z_m,
                              (octant & (goes_along_z ? 2 : 4)) == 0);
  const Axis major = goes_along_z ? axis_z : axis_x, minor = goes_along_z ? axis_x : axis_z;
  const int major_step = major.step * (goes_along_z ? field.columns : 1);
  const int minor_step = minor.step * (goes_along_z ? 1 : field.columns);
  const int base = axis_z.origin * field.columns + axis_x.origin;
  const float major_share = goes_along_z ? sight.radius_share_z : sight.radius_share_x;
  const float minor_share = goes_along_z ? sight.radius_share_x : sight.radius_share_z;

  int last_line = major.last;
  if (major_share > 0.0f) last_line = min(last_line, (int)min(rsqrt(major_share) + 1.5f, 1e9f));
  const int spaces = last_line + 1;  // between rays, less than a cell at the last line
  const int first_ray = (int)get_global_id(0) * (LANES - 1);
  if (first_ray > spaces + 1) return;
  // The first ray is aside of the axis, so that posts on it are between rays.
  const lanes number = (float)first_ray - 0.5f + LANE_INDEX;
  const lanes slope = least(number / (float)spaces, (lanes)1.0f);
  const lanes per_gap = 1.0f / most(next_lane(slope) - slope, (lanes)1e-9f);
  const lanes bend_m = major.bend_m + minor.bend_m * (slope * slope);  // at a line's distance

  const int start_column = min((int)minor.fraction, minor.last - 1);
  int_lanes cell = (int_lanes)start_column;
  lanes place = (lanes)(minor.fraction - (float)start_column);  // in the cell
  // The posts of the last line at the cell.
  const int first_line = 1 + (int)major.fraction;
  const int before = base + (first_line - 1) * major_step + start_column * minor_step;
  lanes before_low_m = (lanes)heights_m[before], before_high_m = (lanes)heights_m[before + minor_step];
  // Heights above the eye, less what the Earth falls away.
  lanes terrain_m = (lanes)(-sight.eye_above_m), last_ahead = (lanes)0.0f;
  lanes upper_left = (lanes)NO_TERRAIN, upper_right = (lanes)NO_TERRAIN;
  lanes lower_left = (lanes)NO_TERRAIN, lower_right = (lanes)NO_TERRAIN;

  for (int line = first_line; line <= last_line; ++line) {
    const float ahead = (float)line - major.fraction;
    const float per_cell = 1.0f / ahead;
    const float ahead_rest = ((float)line - ahead) - major.fraction;
    const lanes way = slope * ahead, whole = floor(way);
    const lanes aside = (way - whole) + (fma(slope, (lanes)ahead, -way) + slope * ahead_rest + minor.fraction);
    const int_lanes whole_cell = convert_int_lanes(whole) + convert_int_lanes(floor(aside));
    const int_lanes last_cell = cell;
    cell = min(clamp(whole_cell, cell, cell + 1), (int_lanes)(minor.last - 1));
    const lanes last_place = place;
    place = aside + convert_lanes(convert_int_lanes(whole) - cell);
    if (!any_lane(mask_of(convert_lanes(cell) + place <= (float)minor.last + 1.0f))) break;

    const int row = base + line * major_step;
    const int_lanes at = row + cell * minor_step;
    const lanes low_m = gathered(heights_m, at);
    const lanes high_m = gathered(heights_m + minor_step, at);
    const int_lanes crosses = mask_of(cell != last_cell);
    // Cells follow each other, so that a post of the last cell is also one of the next.
    const lanes behind_low_m = select(before_low_m, before_high_m, crosses);
    const lanes last_high_m = select(high_m, low_m, crosses);
    lanes behind_high_m = before_high_m, last_low_m = low_m;
    if (any_lane(crosses)) {
      behind_high_m = gathered(heights_m + minor_step, at - major_step);
      last_low_m = gathered(heights_m, row + last_cell * minor_step);
    }

    // The post between a ray and the next, if there is one.
    const int_lanes is_on_axis = mask_of(place < 0.0f);
    const lanes to_post = select((lanes)1.0f, (lanes)0.0f, is_on_axis) - place;
    const int_lanes post = cell + 1 + is_on_axis;
    const lanes next_place = next_lane(place);
    const int_lanes is_between = mask_of(to_post > 0.0f) & mask_of(post <= minor.last) &
                                 mask_of(convert_lanes(next_lane(cell) - post) + next_place >= 0.0f);
    const lanes share = clamp(to_post * per_cell * per_gap, (lanes)0.0f, (lanes)1.0f);
    const lanes post_aside = convert_lanes(post) - minor.fraction;
    const lanes post_m = select(high_m, low_m, is_on_axis);
    const lanes drop_m = major.bend_m * (ahead * ahead) + minor.bend_m * (post_aside * post_aside);
    const lanes post_height = (above_eye(sight, post_m) - drop_m) * per_cell;
    const lanes target = post_height + sight.target_above_m * per_cell;

    // On the diagonal octants meet, and on the axes: one of them answers.
    const int_lanes is_mine =
        (minor.step > 0 ? mask_of(post_aside >= 0.0f) : mask_of(post_aside > 0.0f)) &
        (goes_along_z ? mask_of(post_aside < ahead) : mask_of(post_aside <= ahead)) &
        mask_of(major_share * (ahead * ahead) + minor_share * (post_aside * post_aside) <= 1.0f);
    const int_lanes is_asked = is_between & is_mine;
    if (any_lane(is_asked)) {
      // The last patch, from the post back toward the eye.
      const lanes beside_m = select(low_m, high_m, is_on_axis), across_m = select(behind_low_m, behind_high_m, is_on_axis);
      const lanes back_m = select(behind_high_m, behind_low_m, is_on_axis) - post_m;
      const lanes side_m = beside_m - post_m, twist_m = (across_m - beside_m) - back_m;
      const lanes slant = post_aside * per_cell;
      const lanes f1 = -target - back_m - side_m * slant - 2.0f * drop_m * per_cell;
      const lanes f2 = drop_m * (per_cell * per_cell) - twist_m * slant;
      const lanes clear = least_clearance(sight.target_above_m, f1, f2, min(1.0f, ahead));
      const lanes noise = ROUNDING * (fabs(target) + fabs(back_m) + fabs(side_m) + fabs(twist_m) + drop_m * per_cell +
                                      sight.target_above_m);
      const lanes width = upper_right - upper_left, above = target - (upper_left + share * width);
      const lanes below = (lower_left + share * (lower_right - lower_left)) - target;
      const lanes margin = ROUNDING * (fabs(target) + fabs(width) + fabs(lower_right - lower_left) +
                                       (drop_m + sight.target_above_m) * per_cell);
      const int_lanes is_seen = is_asked & mask_of(above > margin) & mask_of(clear > noise);
      const int_lanes is_hidden = is_asked & (mask_of(below > margin) | mask_of(clear < -noise));
      int places[LANES], answers[LANES];
      store_lanes(row + post * minor_step, places);
      store_lanes((is_seen & 1) | (is_hidden & 2), answers);
      for (int lane = 0; lane < LANES - 1; ++lane) {
        if (answers[lane] != 0) seen[places[lane]] = answers[lane] == 1 ? SIGHT_VISIBLE : SIGHT_HIDDEN;
      }
    }

    // Along each ray: at the border between two patches, in them, and at the line.
    const lanes line_m = above_eye(sight, low_m) + place * (high_m - low_m) - bend_m * (ahead * ahead);
    const lanes at_line = line_m * per_cell;
    const lanes last_twist_m = (last_high_m - last_low_m) - (before_high_m - before_low_m);
    const lanes last_bulge = last_twist_m * slope - bend_m;
    lanes border = (lanes)NO_TERRAIN, highest;
    lanes rough = fabs(high_m - low_m) + bend_m * (ahead * ahead);
    if (any_lane(crosses)) {
      const lanes step = clamp((1.0f - last_place) / most(slope, (lanes)1e-9f), (lanes)0.0f, ahead - last_ahead);
      const lanes border_ahead = last_ahead + step;
      const lanes border_share = border_ahead - (ahead - 1.0f);
      const lanes border_m =
          above_eye(sight, behind_low_m) + border_share * (low_m - behind_low_m) - bend_m * (border_ahead * border_ahead);
      const lanes twist_m = (high_m - low_m) - (behind_high_m - behind_low_m);
      border = select(border, border_m / border_ahead, crosses);
      const lanes end = select((lanes)ahead, border_ahead, crosses), end_m = select(line_m, border_m, crosses);
      const lanes second = highest_between(border_ahead, border_m, (lanes)ahead, line_m, twist_m * slope - bend_m);
      highest = most(highest_between(last_ahead, terrain_m, end, end_m, last_bulge), select(border, second, crosses));
      rough += fabs(low_m - behind_low_m);
    } else {
      highest = highest_between(last_ahead, terrain_m, (lanes)ahead, line_m, last_bulge);
    }
    const lanes noise = ROUNDING * (fabs(at_line) + rough * per_cell);
    // Between rays the Earth's curve arches above straight lines.
    const float arch = 0.25f * minor.bend_m * ahead / ((float)spaces * (float)spaces);
    highest = most(most(highest, border), at_line) + noise + arch;

    // Over each wedge.
    upper_left = most(upper_left, highest);
    upper_right = most(upper_right, next_lane(highest));
    const lanes upper_width = upper_right - upper_left;
    const lanes missing = post_height + arch - (upper_left + share * upper_width) + ROUNDING * (fabs(post_height) + fabs(upper_width));
    const lanes raised = select((lanes)0.0f, most(missing, (lanes)0.0f), is_between);
    upper_left += raised;
    upper_right += raised;

    const lanes next_at_line = next_lane(at_line);
    const lanes dent = least(post_height - (at_line + share * (next_at_line - at_line)), (lanes)0.0f);
    const lanes lowered = select((lanes)0.0f, dent, is_between) - most(noise, next_lane(noise));
    const int_lanes is_whole = is_between | mask_of(cell == next_lane(cell));
    lanes left = select((lanes)NO_TERRAIN, at_line + lowered, is_whole);
    lanes right = select((lanes)NO_TERRAIN, next_at_line + lowered, is_whole);
    int_lanes is_better = mask_of(left + right > lower_left + lower_right);
    lower_left = select(lower_left, left, is_better);
    lower_right = select(lower_right, right, is_better);
    // A border that both rays cross.
    const int_lanes is_crossed = crosses & next_lane(crosses) & mask_of(cell == next_lane(cell));
    const lanes border_noise = most(noise, next_lane(noise)) + ROUNDING * fabs(border);
    left = border - border_noise;
    right = next_lane(border) - border_noise;
    is_better = is_crossed & mask_of(left + right > lower_left + lower_right);
    lower_left = select(lower_left, left, is_better);
    lower_right = select(lower_right, right, is_better);

    if ((line & 7) == 0) {
      // From here on: of targets above the eye where they are near, of those below it where they are far.
      const float reach_m = (sight.highest_m - sight.eye_m) - sight.eye_rest_m;
      const float reach = reach_m / (reach_m > 0.0f ? ahead : (float)last_line + 1.0f);
      const lanes horizon = least(lower_left, lower_right);
      const int_lanes is_open = mask_of(horizon <= reach + 4.0f * ROUNDING * (fabs(horizon) + fabs(reach))) &
                                mask_of(LANE_INDEX < (lanes)(LANES - 1));
      if (!any_lane(is_open)) {
        float slopes[LANES];
        store_lanes(slope, slopes);
        hide_rest(line + 1, last_line, major, minor, (int2)(major_step, minor_step), base, slopes[0], slopes[LANES - 1],
                  seen);
        return;
      }
    }

    before_low_m = low_m;
    before_high_m = high_m;
    terrain_m = line_m;
    last_ahead = (lanes)ahead;
  }
}
