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
// Two kinds of ground are passed over many lines at a time:
// - nodes of the pyramid below the horizon of all wedges: their posts are hidden, and they raise no horizon;
// - level ground below the eye, such as water, where it is above the horizon: its posts are seen, and its last line is the
//   horizon.
//
// In:    heights [rows][columns] m, maxima of terrain/pyramid_base.cl and pyramid_reduce.cl, field (shared/terrain.h),
//        sight (shared/terrain_sight.h).
// inout: seen [rows][columns], SIGHT_UNDECIDED -> SIGHT_HIDDEN or SIGHT_VISIBLE, or as it was.
// A work-item takes SIGHT_FINE_PARTS (LANES - 1) wedges of the octant get_global_id(1). Near the eye it takes them together,
// as LANES - 1 wide ones, each still less than a cell wide.
#include "shared/terrain_sight.h"
#include "terrain/terrain.clh"

#if LANES == 16
#define next_lane(a) ((a).s123456789abcdeff)
#define last_lane(a) ((a).sf)
#else
#define next_lane(a) ((a).s12345677)
#define last_lane(a) ((a).s7)
#endif

// 16 roundings.
#define ROUNDING 1e-6f
#define NO_TERRAIN -1e30f
// Levels of the nodes that are passed over.
#define LEAST_NODE_LEVEL 2
#define MOST_NODE_LEVEL 6
// Lines of level ground that are passed over at a time.
#define LEVEL_LINES 8
#define PREFETCHED_LINES 12
#define PREFETCHED_ALONG_ROWS 40

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

// What a work-item looks over: the ground between its first ray and its last.
typedef struct {
  Axis major, minor;
  bool goes_along_z;           // the major axis
  int base;                    // the post at line 0 of both
  int major_step, minor_step;  // of posts, from line to line
  float first_slope, last_slope;
  float least_bend_m, most_bend_m;  // at a line's distance
  bool has_diagonal;                // posts lie on the last ray: the `diagonal` th beyond that of the line's number
  int diagonal;
} Fan;

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

// Marks the posts of a fan's lines that are within it by more than rounding, and those on the diagonal.
INLINE void mark_lines(Fan fan, int first_line, int last_line, uchar mark, __global uchar *restrict seen) {
  for (int line = first_line; line <= last_line; ++line) {
    const float ahead = (float)line - fan.major.fraction, rounding = 1e-6f + 5e-7f * ahead;
    const int first = max((int)ceil(fan.first_slope * ahead + fan.minor.fraction + rounding), 0);
    const int between = (int)floor(fan.last_slope * ahead + fan.minor.fraction - rounding);
    const int last = min(fan.has_diagonal ? line + fan.diagonal : between, fan.minor.last);
    __global uchar *of_line = seen + fan.base + line * fan.major_step;
    for (int post = first; post <= last; ++post) of_line[post * fan.minor_step] = mark;
  }
}

// The cells aside that a fan crosses from `near` to `far`, and those that rounding adds.
INLINE int2 cells_between(Fan fan, float near, float far) {
  const float first = min(fan.first_slope * near, fan.first_slope * far), last = fan.last_slope * far;
  const float2 ends = (float2)(first, last) + fan.minor.fraction + (0.01f + 5e-7f * far) * (float2)(-1.0f, 1.0f);
  return clamp(convert_int2(floor(ends)), (int2)0, (int2)(fan.minor.last - 1));
}

// The last line before which all ground of a fan from `line` on, and targets there, are below a horizon; line - 1 if none is.
INLINE int last_hidden_line(Fan fan, TerrainField field, TerrainSight sight, __global const float *restrict maxima_m, int line,
                            float horizon) {
  // Nodes begin at lines of the map that are multiples of their width.
  const int at = fan.major.origin + fan.major.step * (line - 1), first_cell = fan.major.step > 0 ? at : at - 1;
  int level = min(field.top_level, MOST_NODE_LEVEL);
  if (at != 0) level = min(level, 31 - (int)clz(at & -at));
  for (; level >= LEAST_NODE_LEVEL; --level) {
    const float near = (float)(line - 1) - fan.major.fraction, far = near + (float)(1 << level);
    const int2 cells = cells_between(fan, near, far);
    const int2 aside = fan.minor.step > 0 ? fan.minor.origin + cells : fan.minor.origin - 1 - cells.yx;
    const int2 nodes = aside >> level;
    float maximum_m = NO_TERRAIN;
    const int ahead = first_cell >> level;
    for (int node = nodes.x; node <= nodes.y; ++node) {
      const int x = fan.goes_along_z ? node : ahead, z = fan.goes_along_z ? ahead : node;
      maximum_m = max(maximum_m, maxima_m[maximum_places(field, level, (int4)x, (int4)z).x]);
    }
    const float most_m = ((maximum_m - sight.eye_m) - sight.eye_rest_m) + sight.target_above_m;
    const float rise = most_m / (most_m > 0.0f ? near : far), fall = fan.least_bend_m * near;
    const float margin = 4.0f * ROUNDING * (fabs(rise) + sight.target_above_m / near + fall + fabs(horizon));
    if (rise - fall + margin < horizon) return line - 1 + (1 << level);
  }
  return line - 1;
}

// Whether all posts of a rectangle are at one height, and perhaps some beside it. Maps of fewer columns are never level.
INLINE bool is_level(__global const float *restrict heights_m, int columns, int2 x, int2 z, float height_m) {
  if (columns < 8) return false;
  int8 differs = (int8)0;
  for (int row = z.x; row <= z.y; ++row) {
    __global const float *of_row = heights_m + row * columns;
    for (int column = x.x; column <= x.y; column += 8)
      differs |= vload8(0, of_row + min(column, columns - 8)) != (float8)height_m;
  }
  const int4 four = differs.lo | differs.hi;
  return as_long(four.lo | four.hi) == 0;
}

// How far above the eye a fan's ground from the line before `line` on is, for LEVEL_LINES, where it is level and below the
// eye, and rises in the eye's picture all the way; else NO_TERRAIN.
INLINE float level_ground(Fan fan, TerrainField field, TerrainSight sight, __global const float *restrict heights_m, int line) {
  const float near = (float)(line - 1) - fan.major.fraction, far = near + (float)LEVEL_LINES;
  const int2 cells = cells_between(fan, near, far), posts = (int2)(cells.x, cells.y + 1);
  const int2 lines = (int2)(line - 1, line - 1 + LEVEL_LINES);
  __global const float *last = heights_m + fan.base + lines.y * fan.major_step;
  const float height_m = last[posts.x * fan.minor_step];
  if (height_m != last[posts.y * fan.minor_step]) return NO_TERRAIN;
  const float above_m = (height_m - sight.eye_m) - sight.eye_rest_m;
  // The Earth falls away by less than what brings the ground nearer to the horizon.
  if (-0.999f * above_m <= fan.most_bend_m * far * far) return NO_TERRAIN;
  const int2 ahead = fan.major.origin + fan.major.step * lines, aside = fan.minor.origin + fan.minor.step * posts;
  const int2 x = fan.goes_along_z ? aside : ahead, z = fan.goes_along_z ? ahead : aside;
  const bool is_one_height = is_level(heights_m, field.columns, (int2)(min(x.x, x.y), max(x.x, x.y)),
                                      (int2)(min(z.x, z.y), max(z.x, z.y)), height_m);
  return is_one_height ? above_m : NO_TERRAIN;
}

// Brings what is ahead of a fan into the cache: rows, or along rows one of them at a time.
INLINE void prefetch_lines(Fan fan, __global const float *restrict heights_m, int line) {
  const float ahead = (float)line - fan.major.fraction;
  __global const float *at = heights_m + fan.base + line * fan.major_step;
  if (fan.goes_along_z) {
    const float then = ahead + PREFETCHED_LINES;
    at += PREFETCHED_LINES * fan.major_step;
    prefetch_line(at + (int)(fan.first_slope * then) * fan.minor_step);
    prefetch_line(at + (int)(fan.last_slope * then + 1.0f) * fan.minor_step);
  } else {
    const float slope = mix(fan.first_slope, fan.last_slope, (float)(line % LANES) * (1.0f / (LANES - 1)));
    at += PREFETCHED_ALONG_ROWS * fan.major_step;
    prefetch_line(at + (int)(slope * (ahead + PREFETCHED_ALONG_ROWS)) * fan.minor_step);
  }
}

// Rays where they cross a line: in cells of a post and the next, `place` cells from the first.
typedef struct {
  int_lanes cell;
  lanes place;
} Crossings;

// Cells are at least `least_cell` and at most one more; rays beyond the map are in the last cell.
INLINE Crossings crossings_at(Fan fan, lanes slope, int line, int_lanes least_cell, int_lanes most_cell) {
  const float ahead = (float)line - fan.major.fraction, ahead_rest = ((float)line - ahead) - fan.major.fraction;
  const lanes way = slope * ahead, whole = floor(way);
  const lanes aside = (way - whole) + (fma(slope, (lanes)ahead, -way) + slope * ahead_rest + fan.minor.fraction);
  const int_lanes whole_cell = convert_int_lanes(whole) + convert_int_lanes(floor(aside));
  Crossings crossings;
  crossings.cell = min(clamp(whole_cell, least_cell, most_cell), (int_lanes)(fan.minor.last - 1));
  crossings.place = aside + convert_lanes(convert_int_lanes(whole) - crossings.cell);
  return crossings;
}

// What rays have met up to a line: heights of the posts of their cells there, and of the ground along them above the eye,
// less what the Earth falls away.
typedef struct {
  int_lanes cell;
  lanes place, low_m, high_m, terrain_m, ahead;
} Behind;

// Before `line`, the first.
INLINE Behind behind_eye(Fan fan, TerrainSight sight, __global const float *restrict heights_m, int line) {
  const int column = min((int)fan.minor.fraction, fan.minor.last - 1);
  __global const float *at = heights_m + fan.base + (line - 1) * fan.major_step + column * fan.minor_step;
  const Behind behind = {(int_lanes)column,
                         (lanes)(fan.minor.fraction - (float)column),
                         (lanes)at[0],
                         (lanes)at[fan.minor_step],
                         (lanes)(-sight.eye_above_m),
                         (lanes)0.0f};
  return behind;
}

// Before `line`, any other.
INLINE Behind behind_line(Fan fan, TerrainSight sight, __global const float *restrict heights_m, lanes slope, lanes bend_m,
                          int line) {
  const Crossings last = crossings_at(fan, slope, line - 1, (int_lanes)0, (int_lanes)(fan.minor.last - 1));
  const int_lanes at = fan.base + (line - 1) * fan.major_step + last.cell * fan.minor_step;
  Behind behind;
  behind.cell = last.cell;
  behind.place = last.place;
  behind.low_m = gathered(heights_m, at);
  behind.high_m = gathered(heights_m + fan.minor_step, at);
  behind.ahead = (lanes)((float)(line - 1) - fan.major.fraction);
  const lanes fall_m = bend_m * (behind.ahead * behind.ahead);
  behind.terrain_m = above_eye(sight, behind.low_m) + behind.place * (behind.high_m - behind.low_m) - fall_m;
  return behind;
}

__kernel void horizon_sweep(__global const float *restrict heights_m, __global const float *restrict maxima_m,
                            TerrainField field, TerrainSight sight, __global uchar *restrict seen) {
  const int octant = (int)get_global_id(1);
  const bool goes_along_z = (octant & 1) != 0;
  const Axis axis_x = axis_of(sight.cell_x, sight.fraction_x, field.cells_x, sight.bend_x_m,
                              (octant & (goes_along_z ? 4 : 2)) == 0);
  const Axis axis_z = axis_of(sight.cell_z, sight.fraction_z, field.cells_z, sight.bend_z_m,
                              (octant & (goes_along_z ? 2 : 4)) == 0);
  const Axis major = goes_along_z ? axis_z : axis_x, minor = goes_along_z ? axis_x : axis_z;
  const float major_share = goes_along_z ? sight.radius_share_z : sight.radius_share_x;
  const float minor_share = goes_along_z ? sight.radius_share_x : sight.radius_share_z;

  int last_line = major.last;
  if (major_share > 0.0f) last_line = min(last_line, (int)min(rsqrt(major_share) + 1.5f, 1e9f));
  const int spaces = last_line + 1;  // between rays, less than a cell at the last line
  const int first_ray = (int)get_global_id(0) * SIGHT_FINE_PARTS * (LANES - 1);
  if (first_ray > spaces + 1) return;
  const int first_line = 1 + (int)major.fraction, last_coarse_line = max((spaces - 1) / SIGHT_FINE_PARTS, first_line - 1);
  // What the wide wedges know when the others begin.
  float coarse_slopes[LANES], coarse_upper_left[LANES], coarse_upper_right[LANES], coarse_lower_left[LANES],
      coarse_lower_right[LANES];

  for (int part = 0; part <= SIGHT_FINE_PARTS; ++part) {
    const bool is_coarse = part == 0;
    // The first ray is aside of the axis, so that posts on it are between rays.
    const float first_number = (float)first_ray - 0.5f + (is_coarse ? 0.0f : (float)((part - 1) * (LANES - 1)));
    const lanes number = first_number + LANE_INDEX * (is_coarse ? (float)SIGHT_FINE_PARTS : 1.0f);
    if (first_number > (float)(spaces + 1)) break;
    const lanes slope = least(number / (float)spaces, (lanes)1.0f);
    const lanes per_gap = 1.0f / most(next_lane(slope) - slope, (lanes)1e-9f);
    const lanes bend_m = major.bend_m + minor.bend_m * (slope * slope);  // at a line's distance
    // Between rays the Earth's curve arches above straight lines, by so much at a line's distance.
    const float spaces_here = is_coarse ? (float)spaces / SIGHT_FINE_PARTS : (float)spaces;
    const float arch_m = 0.25f * minor.bend_m / (spaces_here * spaces_here);
    const float first_slope = slope.s0, last_slope = last_lane(slope), least_slope = max(first_slope, 0.0f);
    const float between_fractions = minor.fraction - major.fraction;
    const Fan fan = {major,
                     minor,
                     goes_along_z,
                     axis_z.origin * field.columns + axis_x.origin,
                     major.step * (goes_along_z ? field.columns : 1),
                     minor.step * (goes_along_z ? 1 : field.columns),
                     first_slope,
                     last_slope,
                     major.bend_m + minor.bend_m * (least_slope * least_slope),
                     major.bend_m + minor.bend_m * (last_slope * last_slope),
                     last_slope == 1.0f && between_fractions == floor(between_fractions),
                     (int)between_fractions};
    const int minor_step = fan.minor_step;

    lanes upper_left = (lanes)NO_TERRAIN, upper_right = (lanes)NO_TERRAIN;
    lanes lower_left = (lanes)NO_TERRAIN, lower_right = (lanes)NO_TERRAIN;
    Behind behind;
    if (is_coarse || last_coarse_line < first_line) {
      behind = behind_eye(fan, sight, heights_m, first_line);
    } else {
      behind = behind_line(fan, sight, heights_m, slope, bend_m, last_coarse_line + 1);
      const int_lanes coarse = ((part - 1) * (LANES - 1) + convert_int_lanes((lanes)LANE_INDEX)) / SIGHT_FINE_PARTS;
      const lanes from = gathered(coarse_slopes, coarse), to = gathered(coarse_slopes + 1, min(coarse, (int_lanes)(LANES - 2)));
      const lanes per_coarse_gap = 1.0f / most(to - from, (lanes)1e-9f);
      const lanes left = (slope - from) * per_coarse_gap, right = (next_lane(slope) - from) * per_coarse_gap;
      const lanes uppers = gathered(coarse_upper_left, coarse), upper_width = gathered(coarse_upper_right, coarse) - uppers;
      const lanes lowers = gathered(coarse_lower_left, coarse), lower_width = gathered(coarse_lower_right, coarse) - lowers;
      const lanes upper_noise = ROUNDING * (fabs(uppers) + fabs(upper_width));
      const lanes lower_noise = ROUNDING * (fabs(lowers) + fabs(lower_width));
      upper_left = uppers + left * upper_width + upper_noise;
      upper_right = uppers + right * upper_width + upper_noise;
      lower_left = lowers + left * lower_width - lower_noise;
      lower_right = lowers + right * lower_width - lower_noise;
    }
    int_lanes cell = behind.cell;
    lanes place = behind.place, before_low_m = behind.low_m, before_high_m = behind.high_m;
    lanes terrain_m = behind.terrain_m, last_ahead = behind.ahead;
    int_lanes is_wedge = mask_of(convert_lanes(cell) + place <= (float)minor.last) & mask_of(LANE_INDEX < (lanes)(LANES - 1));
    float horizon = least_lane(select((lanes)-NO_TERRAIN, least(lower_left, lower_right), is_wedge));  // of no wedge lower

    const int end_line = is_coarse ? min(last_coarse_line, last_line) : last_line;
    for (int line = is_coarse ? first_line : last_coarse_line + 1; line <= end_line; ++line) {
      const int first_of_all = line;
      while (line <= end_line) {
        int end = line - 1;
        if (horizon > 0.5f * NO_TERRAIN) end = min(last_hidden_line(fan, field, sight, maxima_m, line, horizon), end_line);
        if (end >= line) {
          mark_lines(fan, line, end, SIGHT_HIDDEN, seen);
          line = end + 1;
          continue;
        }
        end = line - 1 + LEVEL_LINES;
        const float far = (float)end - major.fraction, far_aside = last_slope * far + 1.0f;
        if (end > end_line || major_share * (far * far) + minor_share * (far_aside * far_aside) > 0.999f) break;
        const float level_m = level_ground(fan, field, sight, heights_m, line);
        if (level_m == NO_TERRAIN) break;
        const float first_ahead = (float)line - major.fraction;
        const float lowest = level_m / first_ahead - fan.most_bend_m * first_ahead;
        const float upper = -least_lane(select((lanes)-NO_TERRAIN, -most(upper_left, upper_right), is_wedge));
        if (lowest - 4.0f * ROUNDING * (fabs(lowest) + fabs(upper)) <= upper) break;
        mark_lines(fan, line, end, SIGHT_VISIBLE, seen);
        const lanes picture = level_m / far - bend_m * far;
        const float noise = 2.0f * ROUNDING * (fabs(level_m) / far + fan.most_bend_m * far);
        upper_left = picture + noise + arch_m * far;
        upper_right = next_lane(upper_left);
        lower_left = picture - noise;
        lower_right = next_lane(lower_left);
        horizon = level_m / far - fan.most_bend_m * far - noise;
        line = end + 1;
      }
      if (line > first_of_all) {
        behind = behind_line(fan, sight, heights_m, slope, bend_m, line);
        cell = behind.cell;
        place = behind.place;
        before_low_m = behind.low_m;
        before_high_m = behind.high_m;
        terrain_m = behind.terrain_m;
        last_ahead = behind.ahead;
        is_wedge = mask_of(convert_lanes(cell) + place <= (float)minor.last) & mask_of(LANE_INDEX < (lanes)(LANES - 1));
      }
      if (line > end_line) break;

      const float ahead = (float)line - major.fraction;
      const float per_cell = 1.0f / ahead;
      const int_lanes last_cell = cell;
      const lanes last_place = place;
      const Crossings crossings = crossings_at(fan, slope, line, cell, cell + 1);
      cell = crossings.cell;
      place = crossings.place;
      if (!any_lane(mask_of(convert_lanes(cell) + place <= (float)minor.last + 1.0f))) break;

      prefetch_lines(fan, heights_m, line);
      const int row = fan.base + line * fan.major_step;
      const int_lanes at = row + cell * minor_step;
      const lanes low_m = gathered(heights_m, at);
      const lanes high_m = gathered(heights_m + minor_step, at);
      const int_lanes crosses = mask_of(cell != last_cell);
      // Cells follow each other, so that a post of the last cell is also one of the next.
      const lanes behind_low_m = select(before_low_m, before_high_m, crosses);
      const lanes last_high_m = select(high_m, low_m, crosses);
      lanes behind_high_m = before_high_m, last_low_m = low_m;
      if (any_lane(crosses)) {
        behind_high_m = gathered(heights_m + minor_step, at - fan.major_step);
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
      const float arch = arch_m * ahead;
      highest = most(most(highest, border), at_line) + noise + arch;

      // Over each wedge.
      upper_left = most(upper_left, highest);
      upper_right = most(upper_right, next_lane(highest));
      const lanes upper_width = upper_right - upper_left;
      const lanes post_noise = ROUNDING * (fabs(post_height) + fabs(upper_width));
      const lanes missing = post_height + arch - (upper_left + share * upper_width) + post_noise;
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

      horizon = least_lane(select((lanes)-NO_TERRAIN, least(lower_left, lower_right), is_wedge));
      is_wedge = mask_of(convert_lanes(cell) + place <= (float)minor.last) & mask_of(LANE_INDEX < (lanes)(LANES - 1));

      before_low_m = low_m;
      before_high_m = high_m;
      terrain_m = line_m;
      last_ahead = (lanes)ahead;
    }
    if (is_coarse) {
      store_lanes(slope, coarse_slopes);
      store_lanes(upper_left, coarse_upper_left);
      store_lanes(upper_right, coarse_upper_right);
      store_lanes(lower_left, coarse_lower_left);
      store_lanes(lower_right, coarse_lower_right);
    }
  }
}
