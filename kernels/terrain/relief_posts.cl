// Posts of the ground that is drawn near the eye: the map's surface and the relief of what covers it, finer than its posts
// (shared/terrain_relief.h). The octaves are those by which terrain/cover/ground_textures.clh turns the ground to the light, as
// far as they are larger than four steps of the first level.
// In:  heights [rows][columns] m, maxima, or with TILED the pool and pages of shared/terrain_tiles.h; field; view; relief and its discs; lakes with
//      the flags of their cells (shared/lakes.h); materials of the scene.
// Inout: relief_m [3][257][257] m, -FLT_MAX beyond a level's posts: that of `level` from those of level + 1, on whose surface its edges lie.
#include "terrain/cover/terrain_cover.clh"
#include "terrain/lakes/lake_hits.clh"
#include "terrain/relief.clh"

// Octaves end where their cells are seen so small, in distances.
#define FULL_CELLS 16.0f
#define LAST_CELLS 26.0f
// Relief is complete so high above the shore, of the sea and of lakes.
#define SHORE_RAMP_M 4.0f
// From below the eye on, outward and up, it leaves a bowl open, so that no camera above the map's surface is in it.
#define BOWL_DEPTH_M 1.6f
#define BOWL_STEEPNESS_PERM 0.2f

// What is seen of posts that are so far beside the picture may reach into it: as high as relief is.
#define BESIDE_M 6.0f

// Whether places, from the eye, are in a picture or near its edge.
INLINE int_lanes is_near_view(TerrainView view, lanes x_m, lanes y_m, lanes z_m, float beside_m) {
  const lanes ahead_m = x_m * view.forward_x + y_m * view.forward_y + z_m * view.forward_z;
  const float right = sqrt(view.right_x * view.right_x + view.right_y * view.right_y + view.right_z * view.right_z);
  const float up = sqrt(view.up_x * view.up_x + view.up_y * view.up_y + view.up_z * view.up_z);
  const lanes right_m = fabs(x_m * view.right_x + y_m * view.right_y + z_m * view.right_z) / right - right * ahead_m;
  const lanes up_m = fabs(x_m * view.up_x + y_m * view.up_y + z_m * view.up_z) / up - up * ahead_m;
  return mask_of(right_m <= beside_m * sqrt(1.0f + right * right)) & mask_of(up_m <= beside_m * sqrt(1.0f + up * up));
}

// How much of the relief's height each cover of the ground has.
typedef struct {
  lanes turf, stones, rock, sand;
} ReliefParts;

INLINE ReliefParts times(ReliefParts parts, lanes share) {
  const ReliefParts left = {parts.turf * share, parts.stones * share, parts.rock * share, parts.sand * share};
  return left;
}

// The ground's own cover, without its snow.
INLINE ReliefParts cover_parts(TerrainRelief relief, lanes height_m, lanes up) {
  ReliefParts parts = {(lanes)1.0f, (lanes)0.0f, (lanes)0.0f, (lanes)0.0f};
  const lanes soils = 0.85f * (1.0f - smoothstep((lanes)0.69f, (lanes)0.79f, up));
  parts.turf -= soils;
  parts.stones = 0.6f * soils;
  const lanes stony = smoothstep((lanes)-0.6f, (lanes)1.3f, (height_m - relief.tree_line_m) * (1.0f / 200.0f));
  parts.turf *= 1.0f - stony;
  parts.stones = mix(parts.stones, (lanes)1.0f, stony);
  const lanes rocky = 1.0f - smoothstep((lanes)0.73f, (lanes)0.82f, up);
  parts = times(parts, 1.0f - rocky);
  parts.rock = rocky;
  return parts;
}

INLINE lanes snow_share(TerrainRelief relief, lanes height_m, lanes up) {
  return smoothstep((lanes)-0.5f, (lanes)1.0f, (height_m - relief.snow_line_m) * (1.0f / 200.0f)) *
         smoothstep((lanes)0.62f, (lanes)0.74f, up);
}

// Octave k at places, of deviation 1, as noise_octave() has it for a point.
INLINE lanes octave_value(StepPlaces places, int octave) {
  const int cell_log2 = octave + FINEST_CELL_LOG2, low = (1 << cell_log2) - 1;
  const float scale = 1.0f / (float)(1 << cell_log2);
  const uint step_x = 0x8da6b343u, step_y = 0xd8163841u, step_z = 0xcb1ab31fu;
  const uint_lanes first = as_uint_lanes(places.x >> cell_log2) * step_x + as_uint_lanes(places.y >> cell_log2) * step_y +
                           as_uint_lanes(places.z >> cell_log2) * step_z + 0x9e3779b9u * (uint)octave;
  const lanes x = (convert_lanes(places.x & low) + places.in_x) * scale;
  const lanes y = (convert_lanes(places.y & low) + places.in_y) * scale;
  const lanes z = (convert_lanes(places.z & low) + places.in_z) * scale;
  lanes slope;
  const lanes share_x = fade(x, &slope), share_y = fade(y, &slope), share_z = fade(z, &slope);
  lanes layers[2];
  UNROLL for (int k = 0; k < 2; ++k) {
    const uint_lanes at_k = first + (uint)k * step_z;
    const lanes in_z = z - (float)k, far_x = x - 1.0f, far_y = y - 1.0f;
    const lanes n00 = noise_of_point(at_k, x, y, in_z).value, n10 = noise_of_point(at_k + step_x, far_x, y, in_z).value;
    const lanes n01 = noise_of_point(at_k + step_y, x, far_y, in_z).value;
    const lanes n11 = noise_of_point(at_k + (step_x + step_y), far_x, far_y, in_z).value;
    layers[k] = between(between(n00, n10, share_x), between(n01, n11, share_x), share_y);
  }
  return NOISE_SCALE * between(layers[0], layers[1], share_z);
}

// How much of an octave is left at this distance.
INLINE lanes octave_share(float cell_m, lanes distance_m) {
  return 1.0f - smoothstep((lanes)(FULL_CELLS * cell_m), (lanes)(LAST_CELLS * cell_m), distance_m);
}

// Lays the scene's materials over other parts. Their patches are those of the light, as fine as posts can show them.
INLINE ReliefParts under_materials(ReliefParts parts, Materials materials, NoisePlaces places, GroundPlaces place,
                                   lanes distance_m, float least_m) {
  const lanes none = (lanes)0.0f;
  const Reliefs flat = {{none, none, none}, none, none, none};
  const Footprints point = {none, none, {none, none, none}, {none, none, none}};
  Textures textures = {none, none, none, (lanes)1.0f, none, (lanes)1.0f, flat, flat, flat, flat};
  lanes seen;
  for (int i = 0; i < BROAD_OCTAVES; ++i)
    textures.broad = fma(level_octave(places.map, point, FIRST_BROAD_LOG2 + 2 * i, &seen), (lanes)0.577f, textures.broad);
  for (int octave = RELIEF_OCTAVES - 1; octave >= FINE_OCTAVES; --octave) {
    const float cell_m = FINEST_CELL_M * (float)(1 << octave);
    const lanes share = octave_share(cell_m, distance_m);
    if (cell_m < least_m || !any_lane(mask_of(share > 0.0f))) break;
    textures.patch = fma(share * octave_value(places.noise, octave), (lanes)0.378f, textures.patch);
    textures.patch_lost -= share * share * (1.0f / PATCH_OCTAVES);
  }
  textures.patch_lost = fmax(textures.patch_lost, none);
  const lanes slope_rad = acos(clamp(place.up, none, (lanes)1.0f));
  for (int i = 0; i < materials.count; ++i) {
    const TerrainMaterial material = materials.all[i];
    const lanes share = material_share(material, place, textures, slope_rad), rough = material.roughness * share;
    parts = times(parts, 1.0f - share);
    if (material.like == TERRAIN_LIKE_GRASS) parts.turf += rough;
    if (material.like == TERRAIN_LIKE_SCREE) parts.stones += rough;
    if (material.like == TERRAIN_LIKE_ROCK) parts.rock += rough;
    if (material.like == TERRAIN_LIKE_SAND) parts.sand += rough;
  }
  return parts;
}

// Metres that the relief adds at a place, so far from the eye, of octaves whose cells are `least_m` or more.
INLINE lanes relief_height(TerrainField field, NoisePlaces places, ReliefParts parts, lanes distance_m, float reach_m,
                           float least_m) {
  const float map_cell_m = 1.0f / max(field.cells_per_m_x, field.cells_per_m_z);
  const lanes within = 1.0f - smoothstep((lanes)(0.5f * reach_m), (lanes)reach_m, distance_m);
  lanes height_m = (lanes)0.0f;
  for (int octave = RELIEF_OCTAVES - 1; octave >= 0; --octave) {
    const float cell_m = FINEST_CELL_M * (float)(1 << octave), shown = clamp(2.0f - cell_m / map_cell_m, 0.0f, 1.0f);
    const lanes share = within * octave_share(cell_m, distance_m);
    if (cell_m < least_m || !any_lane(mask_of(share > 0.0f))) break;
    if (shown == 0.0f) continue;
    const lanes noise = octave_value(places.noise, octave);
    // Slopes of lumps are those of |n|, whatever their deviation is.
    const lanes lump = sqrt(fma(noise, noise, (lanes)0.01f)) - MEAN_ABSOLUTE;
    const lanes value = noise * (parts.turf * turf_slopes[octave] + parts.sand * sand_slopes[octave]) +
                        lump * (parts.stones * stone_slopes[octave] - parts.rock * rock_slopes[octave]);
    height_m = fma(share, shown * (cell_m / NOISE_SLOPE) * value, height_m);
  }
  return height_m;
}

__kernel void relief_posts(__global const float *restrict heights_m, __global const float *restrict maxima_m,
                           TerrainField field, TerrainView view, const TerrainRelief relief,
                           __global const TerrainReliefDisc *restrict discs, __global const LakeWater *restrict lakes,
                           __global const uchar *restrict lake_cells, int lake_count,
                           __global const TerrainMaterial *restrict materials, int material_count, int level,
                           __global float *restrict relief_m) {
  const Terrain terrain = {heights_m, maxima_m, field};
  const int first = (int)get_global_id(0) * LANES, row = (int)get_global_id(1);
  if (first >= TERRAIN_RELIEF_POSTS) return;
  __global float *of_row = relief_m + (size_t)(level * TERRAIN_RELIEF_POSTS + row) * TERRAIN_RELIEF_POSTS + first;
  const int count = min(LANES, TERRAIN_RELIEF_POSTS - first);
  const ReliefLevel side = relief_level(field, relief, level);
  const int last_x = side.cells_x, last_z = side.cells_z, log2_steps = side.steps_log2;
  if (first > last_x || row > last_z) {
    for (int lane = 0; lane < count; ++lane) of_row[lane] = -FLT_MAX;
    return;
  }
  const float step = 1.0f / (float)(1 << log2_steps);
  const int_lanes all = (int_lanes)-1, column = up_to(first + convert_int_lanes(LANE_INDEX), last_x);
  const int_lanes x = column + side.first_x, z = (int_lanes)(row + side.first_z);
  const int_lanes cell_x = up_to(x >> log2_steps, field.cells_x - 1), cell_z = up_to(z >> log2_steps, field.cells_z - 1);
  const lanes u = convert_lanes(x - (cell_x << log2_steps)) * step, v = convert_lanes(z - (cell_z << log2_steps)) * step;
  const SurfacePlaces surface = surface_place(terrain, cell_x, cell_z, u, v, all);
  const lanes east_m = (convert_lanes(cell_x - relief.eye_cell_x) + (u - relief.eye_fraction_x)) / field.cells_per_m_x;
  const lanes south_m = (convert_lanes(cell_z - relief.eye_cell_z) + (v - relief.eye_fraction_z)) / field.cells_per_m_z;
  const lanes rise_m = surface.height_m - relief.eye_height_m, level_square = east_m * east_m + south_m * south_m;
  const lanes distance_m = sqrt(level_square + rise_m * rise_m);
  lanes added_m = (lanes)0.0f;
  const float cell_m = 1.0f / min(field.cells_per_m_x, field.cells_per_m_z), beside_m = BESIDE_M + 4.0f * cell_m * step;
  const int_lanes is_seen = mask_of(distance_m < relief.reach_m) & is_near_view(view, east_m, rise_m, south_m, beside_m);
  if (any_lane(is_seen & mask_of(surface.height_m > relief.shore_m))) {
    const Slopes slopes = slopes_under(terrain, cell_x, cell_z, u, v, (lanes)0.0f, all);
    const lanes up = rsqrt(1.0f + slopes.x * slopes.x + slopes.z * slopes.z);
    // None at the map's edges, where it ends.
    const lanes to_edge = fmin(fmin(convert_lanes(cell_x) + u, convert_lanes(field.cells_x - cell_x) - u),
                               fmin(convert_lanes(cell_z) + v, convert_lanes(field.cells_z - cell_z) - v));
    lanes strength = relief.strength * smoothstep((lanes)0.0f, (lanes)1.0f, to_edge) *
                           clamp((surface.height_m - relief.shore_m) * (1.0f / SHORE_RAMP_M), (lanes)0.0f, (lanes)1.0f) /
                           fmax(up, (lanes)0.4f);
    for (int i = 0; i < relief.discs; ++i) {
      const TerrainReliefDisc disc = discs[i];
      const lanes x_m = east_m - disc.east_m, z_m = south_m - disc.south_m;
      strength *= 1.0f - disc.share * (1.0f - smoothstep((lanes)disc.radius_m, (lanes)(disc.radius_m + disc.ramp_m),
                                                         sqrt(x_m * x_m + z_m * z_m)));
    }
    const Lakes all_lakes = {lakes, lake_cells, lake_count};
    const LakeBanks bank = lake_bank(all_lakes, all, cell_x, cell_z, u, v, surface.height_m);
    const lanes above_bank = clamp(bank.above_m * (1.0f / SHORE_RAMP_M), (lanes)0.0f, (lanes)1.0f);
    strength *= 1.0f - bank.nearness * (1.0f - above_bank);
    const NoisePlaces places = noise_places(field, cell_x, cell_z, u, v, surface.height_m);
    const float finest_m = cell_m / (float)(1 << relief.finest_log2);
    ReliefParts parts = cover_parts(relief, surface.height_m, up);
    if (material_count > 0) {
      const Materials of_scene = {materials, material_count};
      const GroundPlaces place = {surface.height_m, up, (lanes)0.0f, (lanes)0.0f, (lanes)0.0f, bank};
      parts = under_materials(parts, of_scene, places, place, distance_m, 4.0f * finest_m);
    }
    parts = times(parts, 1.0f - snow_share(relief, surface.height_m, up));
    added_m = strength * relief_height(field, places, parts, distance_m, relief.reach_m, 4.0f * finest_m);
  }
  const lanes away_m = sqrt(level_square);
  const lanes open_m = fmax(away_m * (1.0f + BOWL_STEEPNESS_PERM * away_m) - rise_m - BOWL_DEPTH_M, (lanes)0.0f);
  lanes height_m = surface.height_m + fmin(added_m, open_m);

  if (level + 1 < relief.levels) {
    // Edges are where the coarser level has them.
    const int_lanes is_side = mask_of(column == 0) | mask_of(column == last_x);
    const int_lanes is_end = row == 0 || row == last_z ? all : (int_lanes)0;
    if (any_lane(is_side | is_end)) {
      const int ratio = 1 << TERRAIN_RELIEF_RATIO_LOG2, above = level + 1;
      const ReliefLevel coarse = relief_level(field, relief, above);
      const int_lanes coarse_x = (x >> TERRAIN_RELIEF_RATIO_LOG2) - coarse.first_x;
      const int_lanes coarse_z = (z >> TERRAIN_RELIEF_RATIO_LOG2) - coarse.first_z;
      const lanes rest = convert_lanes(select(z, x, is_end) & (ratio - 1)) * (1.0f / (float)ratio);
      const int_lanes begin = above * (TERRAIN_RELIEF_POSTS * TERRAIN_RELIEF_POSTS) + coarse_z * TERRAIN_RELIEF_POSTS + coarse_x;
      const int_lanes next = begin + select((int_lanes)0, select((int_lanes)TERRAIN_RELIEF_POSTS, (int_lanes)1, is_end),
                                            mask_of(rest > 0.0f));
      const int_lanes is_edge = is_side | is_end;
      const lanes from_m = gathered(relief_m, select((int_lanes)0, begin, is_edge));
      const lanes to_m = gathered(relief_m, select((int_lanes)0, next, is_edge));
      height_m = select(height_m, from_m + rest * (to_m - from_m), is_edge);
    }
  }
  float heights[LANES];
  store_lanes(height_m, heights);
  for (int lane = 0; lane < count; ++lane) of_row[lane] = first + lane <= last_x ? heights[lane] : -FLT_MAX;
}
