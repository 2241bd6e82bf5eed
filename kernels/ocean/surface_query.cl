// The composed sea at points of the world: the label under each point is found first, as the surface moves sideways.
// In:  points; displacement, gradient, flow [cascades][n][n] float4 of ocean/surface_assemble.cl and
//      ocean/velocity_assemble.cl (flow is not read unless has_flow); waves, params (shared/query_params.h), rings
//      (GerstnerRingInTile of shared/gerstner_params.h); wake_maps of ocean/wake_map.cl, wakes (shared/wake.h); time as ocean/wave_phase.clh has it;
//      with SHOALS shoals, depths_m [rows][columns], shoal_shares (shared/shoal_params.h).
// Out: samples (shared/query_params.h), the surface of ocean/surface_compose.cl where it meets the point's vertical.
// The host sets VECTORS, of LANES points each, that a work-item takes.
// The label X solves X + d(X) = x. Steps X <- X - B (X + d(X) - x) end where the residual is small; the first is that
// of fixed-point iteration (B = 1), the others have B = (I + grad d)^-1 of the interpolated displacement: with B = 1
// they would go on for dozens of steps where crests are steep. A point under a fold has several labels: one of them is
// found. Points that are not finite get a residual that is not either.
#include "ocean/deformation.clh"
#include "ocean/gerstner_ring.clh"
#include "ocean/wake_layer.clh"
#include "shared/query_params.h"
#include "shared/shoal_params.h"
#include "simd/lanes.clh"

// What is left of waves over shoals (host/ocean/query/shoals.h): shares of the heights that they have in the open sea, at labels.
// Without SHOALS there are none: shares are the constant 1, and compilers leave them out.

// Shares of each cascade, [cascade][lane], and of the bands of Gerstner waves; what they are read from: depths_m [rows][columns]
// of a map, a table [SHOAL_STEPS][SHOAL_BANDS].
typedef struct {
  __global const ShoalMap *map;
  __global const float *depths_m, *table;
  float cascades[SHOAL_FIRST_GERSTNER * LANES];
  lanes gerstner_waves[SHOAL_BANDS - SHOAL_FIRST_GERSTNER];
} Shares;

#if SHOALS

INLINE float cascade_share(const Shares *shares, int cascade_and_lane) { return shares->cascades[cascade_and_lane]; }

INLINE lanes gerstner_share(const Shares *shares, int band) { return shares->gerstner_waves[band]; }

// Depth at a place in posts of the map, bilinear; beyond its edge it grows. A place that is not a number is deep.
INLINE float shoal_depth_m(__global const ShoalMap *map, __global const float *depths_m, float column, float row) {
  const float near_column = fmin(fmax(column, 0.0f), (float)(map->columns - 1));
  const float near_row = fmin(fmax(row, 0.0f), (float)(map->rows - 1));
  const int x = min((int)near_column, map->columns - 2), z = min((int)near_row, map->rows - 2);
  __global const float *near = depths_m + (size_t)z * map->columns + x, *far = near + map->columns;
  const float u = near_column - (float)x, v = near_row - (float)z;
  const float depth_m = mix(mix(near[0], near[1], u), mix(far[0], far[1], u), v);
  const float beyond_x_m = (column - near_column) / map->columns_per_m, beyond_z_m = (row - near_row) / map->rows_per_m;
  const float beyond_m = sqrt(beyond_x_m * beyond_x_m + beyond_z_m * beyond_z_m);
  return fmin(depth_m + SHOAL_STEEPEST * beyond_m, map->deepest_m);
}

// Sets the shares at labels relative to a tile.
INLINE void set_shares(int_lanes tile_x, int_lanes tile_z, lanes x_m, lanes z_m, Shares *shares) {
  __global const ShoalMap *map = shares->map;
  float columns[LANES], rows[LANES];
  const lanes from_x_m = (convert_lanes(tile_x) - (float)map->tile_x) * SURFACE_QUERY_TILE_M - map->origin_x_m;
  const lanes from_z_m = (convert_lanes(tile_z) - (float)map->tile_z) * SURFACE_QUERY_TILE_M - map->origin_z_m;
  store_lanes((from_x_m + x_m) * map->columns_per_m, columns);
  store_lanes((from_z_m + z_m) * map->rows_per_m, rows);
  float gerstner_waves[(SHOAL_BANDS - SHOAL_FIRST_GERSTNER) * LANES];
  for (int lane = 0; lane < LANES; ++lane) {
    const float depth_m = fmax(shoal_depth_m(map, shares->depths_m, columns[lane], rows[lane]), 0.0f);
    const float place = sqrt(depth_m / map->deepest_m) * (float)(SHOAL_STEPS - 1);
    const int below = min((int)place, SHOAL_STEPS - 2);
    __global const float *shallower = shares->table + below * SHOAL_BANDS, *deeper = shallower + SHOAL_BANDS;
    const float u = place - (float)below;
    for (int band = 0; band < SHOAL_FIRST_GERSTNER; ++band) {
      shares->cascades[band * LANES + lane] = mix(shallower[band], deeper[band], u);
      const int of_gerstner_waves = band + SHOAL_FIRST_GERSTNER;
      gerstner_waves[band * LANES + lane] = mix(shallower[of_gerstner_waves], deeper[of_gerstner_waves], u);
    }
  }
  for (int band = 0; band < SHOAL_BANDS - SHOAL_FIRST_GERSTNER; ++band) {
    shares->gerstner_waves[band] = load_lanes(gerstner_waves + band * LANES);
  }
}

#else

INLINE void set_shares(int_lanes tile_x, int_lanes tile_z, lanes x_m, lanes z_m, Shares *shares) {}

INLINE float cascade_share(const Shares *shares, int cascade_and_lane) { return 1.0f; }

INLINE lanes gerstner_share(const Shares *shares, int band) { return (lanes)1.0f; }

#endif

#if LANES == 1
#define mask_of(condition) ((condition) ? -1 : 0)
#define any_lane(condition) (condition)
#else
#define mask_of(condition) (condition)
#define any_lane(condition) any(condition)
#endif
#define CASCADES 4

// Where a point's tile lies in each patch, in 2^-32 of it, and in each wave.
typedef struct {
  uint_lanes patch_x[CASCADES], patch_z[CASCADES];
  uint_lanes wave[GERSTNER_WAVES];
} Tile;

// The four texels of each cascade around LANES labels, and how far the labels are on the way to the right and to the far side.
typedef struct {
  uint near_left[CASCADES * LANES], near_right[CASCADES * LANES], far_left[CASCADES * LANES], far_right[CASCADES * LANES];
  float u[CASCADES * LANES], v[CASCADES * LANES];
} Cells;

// The fractions of turns in 2^-32 of one. The factor is 2^32 - 2^8: half a turn is an int.
INLINE uint_lanes fraction_of(lanes turns) {
  return as_uint_lanes(convert_int_lanes((turns - rint(turns)) * 4294967040.0f));
}

// tile * step / 2^32 modulo 2^32, of a signed tile and a step in 2^-64.
INLINE uint_lanes tile_place(int_lanes tile, uint high, uint low) {
  const uint_lanes whole = as_uint_lanes(tile);
  return whole * high + mul_hi(whole, (uint_lanes)low) - (as_uint_lanes(tile >> 31) & low);
}

INLINE void set_tile(__global const SurfaceQueryParams *params, __global const SurfaceQueryWave *waves, int_lanes tile_x,
                         int_lanes tile_z, uint ticks, float tick_fraction, Tile *tile) {
  for (int cascade = 0; cascade < params->cascade_count; ++cascade) {
    const uint high = as_uint(params->tile_step_high[cascade]), low = as_uint(params->tile_step_low[cascade]);
    tile->patch_x[cascade] = tile_place(tile_x, high, low);
    tile->patch_z[cascade] = tile_place(tile_z, high, low);
  }
  const lanes tiles_x = convert_lanes(tile_x), tiles_z = convert_lanes(tile_z);
  for (int wave = 0; wave < params->wave_count; ++wave) {
    // What steps of 2^-32 turns leave over grows to thousands of them far away.
    const lanes rest = tiles_x * waves[wave].tile_rest_x + tiles_z * waves[wave].tile_rest_z;
    tile->wave[wave] = as_uint(waves[wave].phase) + as_uint_lanes(tile_x) * as_uint(waves[wave].tile_step_x) +
                       as_uint_lanes(tile_z) * as_uint(waves[wave].tile_step_z) +
                       as_uint_lanes(convert_int_lanes(rest)) -
                       turns_since((uint_lanes)as_uint(waves[wave].rate), ticks, tick_fraction);
  }
}

// Of a place in 2^-32 of the patch the high bits are the texel, the others what lies beyond it.
INLINE void set_cells(__global const SurfaceQueryParams *params, const Tile *tile, lanes x_m, lanes z_m, Cells *cells) {
  const uint size = (uint)params->size, mask = size - 1u, below_texel = clz(mask), texel = 32u - below_texel;
  const float per_unit = 2.3283064365386963e-10f;  // 2^-32
  for (int cascade = 0; cascade < params->cascade_count; ++cascade) {
    const float patches_per_m = params->patches_per_m[cascade];
    const uint_lanes column = tile->patch_x[cascade] + fraction_of(x_m * patches_per_m);
    const uint_lanes row = tile->patch_z[cascade] + fraction_of(z_m * patches_per_m);
    const uint_lanes left = column >> below_texel, right = (left + 1u) & mask;
    const uint_lanes near = row >> below_texel, far = (near + 1u) & mask;
    const uint first = (uint)cascade * size * size;
    const int place = cascade * LANES;
    store_lanes(first + near * size + left, cells->near_left + place);
    store_lanes(first + near * size + right, cells->near_right + place);
    store_lanes(first + far * size + left, cells->far_left + place);
    store_lanes(first + far * size + right, cells->far_right + place);
    store_lanes(convert_lanes(column << texel) * per_unit, cells->u + place);
    store_lanes(convert_lanes(row << texel) * per_unit, cells->v + place);
  }
}

// Asks for what a map has there, so that it is on its way while the Gerstner waves are summed.
INLINE void fetch_cells(__global const float4 *map, int cascade_count, const Cells *cells) {
  for (int i = 0; i < cascade_count * LANES; ++i) {
    prefetch_line(map + cells->near_left[i]);
    prefetch_line(map + cells->near_right[i]);
    prefetch_line(map + cells->far_left[i]);
    prefetch_line(map + cells->far_right[i]);
  }
}

INLINE void wave_at(__global const SurfaceQueryWave *wave, uint_lanes tile, const Shares *shares, lanes x_m, lanes z_m,
                        lanes *cosine, lanes *sine) {
  cosine_sine_of_turns(tile + fraction_of(x_m * wave->turns_x_perm + z_m * wave->turns_z_perm), cosine, sine);
  const lanes share = gerstner_share(shares, wave->band);
  *cosine *= share;
  *sine *= share;
}

// Four fields of LANES points out of a float4 a point.
INLINE void split_fields(const float4 *points, lanes *a, lanes *b, lanes *c, lanes *d) {
#if LANES == 1
  *a = points[0].x, *b = points[0].y, *c = points[0].z, *d = points[0].w;
#else
  float fields[4][LANES];
  UNROLL for (int lane = 0; lane < LANES; ++lane) {
    fields[0][lane] = points[lane].x, fields[1][lane] = points[lane].y;
    fields[2][lane] = points[lane].z, fields[3][lane] = points[lane].w;
  }
  *a = load_lanes(fields[0]), *b = load_lanes(fields[1]), *c = load_lanes(fields[2]), *d = load_lanes(fields[3]);
#endif
}

// Adds a map's fields of all cascades.
INLINE void add_map(__global const float4 *map, int cascade_count, const Cells *cells, const Shares *shares, lanes *a,
                        lanes *b, lanes *c, lanes *d) {
  float4 sums[LANES];
  for (int lane = 0; lane < LANES; ++lane) {
    float4 sum = (float4)(0.0f);
    for (int i = lane; i < cascade_count * LANES; i += LANES) {
      sum += cascade_share(shares, i) *
             mix(mix(map[cells->near_left[i]], map[cells->near_right[i]], cells->u[i]),
                 mix(map[cells->far_left[i]], map[cells->far_right[i]], cells->u[i]), cells->v[i]);
    }
    sums[lane] = sum;
  }
  lanes sum_a, sum_b, sum_c, sum_d;
  split_fields(sums, &sum_a, &sum_b, &sum_c, &sum_d);
  *a += sum_a;
  *b += sum_b;
  *c += sum_c;
  *d += sum_d;
}

// The horizontal displacement and its derivative.
typedef struct {
  lanes x, z, x_by_x, z_by_x, x_by_z, z_by_z;
} Moved;

// Adds the displacement of all cascades and its derivative by differences across the cell: what a step needs exactly.
INLINE void add_displacement(__global const float4 *map, __global const SurfaceQueryParams *params, const Cells *cells,
                                 const Shares *shares, Moved *moved) {
  float4 sums[LANES], derivatives[LANES];
  for (int lane = 0; lane < LANES; ++lane) {
    float4 sum = (float4)(0.0f), derivative = (float4)(0.0f);
    for (int cascade = 0; cascade < params->cascade_count; ++cascade) {
      const int i = cascade * LANES + lane;
      const float4 near_left = map[cells->near_left[i]], far_left = map[cells->far_left[i]];
      const float4 along_near = map[cells->near_right[i]] - near_left, along_far = map[cells->far_right[i]] - far_left;
      const float4 near = near_left + cells->u[i] * along_near, across = far_left + cells->u[i] * along_far - near;
      const float share = cascade_share(shares, i);
      sum += share * (near + cells->v[i] * across);
      const float4 along = mix(along_near, along_far, cells->v[i]);
      derivative += share * params->texels_per_m[cascade] * (float4)(along.xz, across.xz);
    }
    sums[lane] = sum;
    derivatives[lane] = derivative;
  }
  lanes x, height, z, gradient_xz, x_by_x, z_by_x, x_by_z, z_by_z;
  split_fields(sums, &x, &height, &z, &gradient_xz);
  split_fields(derivatives, &x_by_x, &z_by_x, &x_by_z, &z_by_z);
  moved->x += x;
  moved->z += z;
  moved->x_by_x += x_by_x;
  moved->z_by_x += z_by_x;
  moved->x_by_z += x_by_z;
  moved->z_by_z += z_by_z;
}

// The label, relative to the tile, under points relative to it, and what shoals leave of the waves there. That shares
// differ from label to label is no part of the derivative: they do slowly.
INLINE void find_labels(__global const float4 *displacement, __global const SurfaceQueryParams *params,
                            __global const SurfaceQueryWave *waves, const Tile *tile, int_lanes tile_x, int_lanes tile_z,
                            lanes x_m, lanes z_m, lanes *label_x_m, lanes *label_z_m, Shares *shares) {
  lanes at_x = x_m, at_z = z_m;
  for (int step = 0; step < SURFACE_QUERY_MOST_STEPS; ++step) {
    // The Gerstner waves are the long waves and move the label farthest: the first step takes them alone.
    const bool takes_all = step > 0 || params->wave_count == 0;
    Cells cells;
    Moved moved = {(lanes)0.0f, (lanes)0.0f, (lanes)0.0f, (lanes)0.0f, (lanes)0.0f, (lanes)0.0f};
    if (takes_all) {
      set_cells(params, tile, at_x, at_z, &cells);
      fetch_cells(displacement, params->cascade_count, &cells);
    }
    set_shares(tile_x, tile_z, at_x, at_z, shares);
    for (int i = 0; i < params->wave_count; ++i) {
      lanes cosine, sine;
      wave_at(waves + i, tile->wave[i], shares, at_x, at_z, &cosine, &sine);
      moved.x += waves[i].shift_x_m * sine;
      moved.z += waves[i].shift_z_m * sine;
      moved.x_by_x += waves[i].gradient_xx * cosine;
      moved.x_by_z += waves[i].gradient_xz * cosine;
      moved.z_by_z += waves[i].gradient_zz * cosine;
    }
    moved.z_by_x = moved.x_by_z;
    if (takes_all) add_displacement(displacement, params, &cells, shares, &moved);
    const lanes off_x = at_x + moved.x - x_m, off_z = at_z + moved.z - z_m;
    const int_lanes is_far = mask_of(off_x * off_x + off_z * off_z > params->tolerance_m * params->tolerance_m);
    if (takes_all && !any_lane(is_far)) break;
    const lanes xx = 1.0f + moved.x_by_x, zz = 1.0f + moved.z_by_z;
    const lanes scale =
        1.0f / fmax(xx * zz - moved.x_by_z * moved.z_by_x, (lanes)LEAST_DETERMINANT);
    const lanes step_x = step == 0 ? off_x : scale * (zz * off_x - moved.x_by_z * off_z);
    const lanes step_z = step == 0 ? off_z : scale * (xx * off_z - moved.z_by_x * off_x);
    at_x -= select((lanes)0.0f, step_x, is_far);
    at_z -= select((lanes)0.0f, step_z, is_far);
  }
  *label_x_m = at_x;
  *label_z_m = at_z;
}

// Adds the wakes: height, slopes, and, as they fade with depth, the rate at which the surface rises and the head.
INLINE void add_wakes(__global const float4 *maps, __global const WakeLayer *wakes, int wake_count, float depth_m,
                          int_lanes tile_x, int_lanes tile_z, lanes label_x_m, lanes label_z_m, lanes *height,
                          lanes *slope_x, lanes *slope_z, lanes *velocity_y, lanes *head) {
  for (int i = 0; i < wake_count; ++i) {
    const lanes from_x = convert_lanes(tile_x - wakes[i].tile_x) * SURFACE_QUERY_TILE_M - wakes[i].origin_x_m;
    const lanes from_z = convert_lanes(tile_z - wakes[i].tile_z) * SURFACE_QUERY_TILE_M - wakes[i].origin_z_m;
    float columns[LANES], rows[LANES];
    store_lanes((from_x + label_x_m) * wakes[i].cells_per_m, columns);
    store_lanes((from_z + label_z_m) * wakes[i].cells_per_m, rows);
    float4 sums[LANES];
    for (int lane = 0; lane < LANES; ++lane) sums[lane] = wake_layer_at(maps, wakes + i, columns[lane], rows[lane]);
    lanes rise, by_x, by_z, rate;
    split_fields(sums, &rise, &by_x, &by_z, &rate);
    const float left = exp(-wakes[i].decay_radpm * depth_m);
    *height += rise;
    *slope_x += by_x;
    *slope_z += by_z;
    *velocity_y += left * rate;
    *head += left * rise;
  }
}

// All that there is at LANES labels, for the points above them.
INLINE void sample_labels(__global const float4 *displacement, __global const float4 *gradient,
                              __global const float4 *flow, __global const SurfaceQueryWave *waves,
                              __global const GerstnerRingInTile *rings, __global const float4 *wake_maps,
                              __global const WakeLayer *wakes, int wake_count,
                              __global const SurfaceQueryParams *params, const Tile *tile, const Shares *shares,
                              int_lanes tile_x, int_lanes tile_z, lanes x_m, lanes z_m, lanes label_x_m, lanes label_z_m,
                              float *fields) {
  Cells cells;
  set_cells(params, tile, label_x_m, label_z_m, &cells);
  fetch_cells(gradient, params->cascade_count, &cells);
  if (params->has_flow) fetch_cells(flow, params->cascade_count, &cells);
  lanes shift_x = (lanes)0.0f, shift_z = shift_x, height = shift_x, slope_x = shift_x, slope_z = shift_x;
  lanes xx = shift_x, xz = shift_x, zz = shift_x;
  lanes velocity_x = shift_x, velocity_y = shift_x, velocity_z = shift_x, head = shift_x;
  for (int i = 0; i < params->wave_count; ++i) {
    lanes cosine, sine;
    wave_at(waves + i, tile->wave[i], shares, label_x_m, label_z_m, &cosine, &sine);
    shift_x += waves[i].shift_x_m * sine;
    height += waves[i].height_m * cosine;
    shift_z += waves[i].shift_z_m * sine;
    slope_x += waves[i].slope_x * sine;
    slope_z += waves[i].slope_z * sine;
    xx += waves[i].gradient_xx * cosine;
    xz += waves[i].gradient_xz * cosine;
    zz += waves[i].gradient_zz * cosine;
    velocity_x += waves[i].velocity_x_mps * cosine;
    velocity_y += waves[i].velocity_y_mps * sine;
    velocity_z += waves[i].velocity_z_mps * cosine;
    head += waves[i].head_m * cosine;
  }
  add_map(displacement, params->cascade_count, &cells, shares, &shift_x, &height, &shift_z, &xz);
  add_map(gradient, params->cascade_count, &cells, shares, &slope_x, &slope_z, &xx, &zz);
  if (params->has_flow) {
    add_map(flow, params->cascade_count, &cells, shares, &velocity_x, &velocity_y, &velocity_z, &head);
  }
  for (int i = 0; i < params->ring_count; ++i) {
    const lanes from_x = convert_lanes(tile_x - rings[i].tile_x) * SURFACE_QUERY_TILE_M - rings[i].ring.centre_x_m;
    const lanes from_z = convert_lanes(tile_z - rings[i].tile_z) * SURFACE_QUERY_TILE_M - rings[i].ring.centre_z_m;
    lanes ring_height = (lanes)0.0f;
    add_ring(&rings[i].ring, from_x + label_x_m, from_z + label_z_m, &ring_height, &slope_x, &slope_z);
    height += ring_height;
    head += ring_height * exp(-6.2831853072f * params->depth_m / rings[i].ring.wavelength_m);
  }
  add_wakes(wake_maps, wakes, wake_count, params->depth_m, tile_x, tile_z, label_x_m, label_z_m, &height, &slope_x,
            &slope_z, &velocity_y, &head);
  xx += 1.0f;
  zz += 1.0f;
  const lanes jacobian = xx * zz - xz * xz;
  const lanes determinant = LIMITED_DETERMINANT(jacobian);
  const lanes off_x = label_x_m + shift_x - x_m, off_z = label_z_m + shift_z - z_m;
  store_lanes(height, fields);
  store_lanes((zz * slope_x - xz * slope_z) / determinant, fields + LANES);
  store_lanes((xx * slope_z - xz * slope_x) / determinant, fields + 2 * LANES);
  store_lanes(sqrt(off_x * off_x + off_z * off_z), fields + 3 * LANES);
  const lanes pressure_pa = params->weight_papm * (params->depth_m + head - height);
  const bool has_flow = params->has_flow != 0;
  store_lanes(has_flow ? velocity_x : (lanes)0.0f, fields + 4 * LANES);
  store_lanes(has_flow ? velocity_y : (lanes)0.0f, fields + 5 * LANES);
  store_lanes(has_flow ? velocity_z : (lanes)0.0f, fields + 6 * LANES);
  store_lanes(has_flow ? pressure_pa : (lanes)0.0f, fields + 7 * LANES);
}

__kernel void surface_query(__global const SurfaceQueryPoint *restrict points, __global const float4 *restrict displacement,
                            __global const float4 *restrict gradient, __global const float4 *restrict flow,
                            __global const SurfaceQueryWave *restrict waves,
                            __global const GerstnerRingInTile *restrict rings,
                            __global const float4 *restrict wake_maps, __global const WakeLayer *restrict wakes,
                            int wake_count,
#if SHOALS
                            __global const ShoalMap *restrict shoals, __global const float *restrict depths_m,
                            __global const float *restrict shoal_shares,
#endif
                            __global const SurfaceQueryParams *restrict params, int point_count, uint ticks,
                            float tick_fraction, __global SurfaceQuerySample *restrict samples) {
  const int start = (int)get_global_id(0) * VECTORS * LANES;
  for (int first = start; first < min(start + VECTORS * LANES, point_count); first += LANES) {
    int tiles_x[LANES], tiles_z[LANES];
    float xs_m[LANES], zs_m[LANES];
    for (int lane = 0; lane < LANES; ++lane) {
      // Lanes beyond the last point work on it too.
      const SurfaceQueryPoint point = points[min(first + lane, point_count - 1)];
      tiles_x[lane] = point.tile_x, tiles_z[lane] = point.tile_z;
      xs_m[lane] = point.x_m, zs_m[lane] = point.z_m;
    }
    const int_lanes tile_x = load_lanes(tiles_x), tile_z = load_lanes(tiles_z);
    const lanes x_m = load_lanes(xs_m), z_m = load_lanes(zs_m);
    Tile tile;
    set_tile(params, waves, tile_x, tile_z, ticks, tick_fraction, &tile);
    lanes label_x_m, label_z_m;
    Shares shares;
#if SHOALS
    shares.map = shoals, shares.depths_m = depths_m, shares.table = shoal_shares;
#endif
    find_labels(displacement, params, waves, &tile, tile_x, tile_z, x_m, z_m, &label_x_m, &label_z_m, &shares);
    set_shares(tile_x, tile_z, label_x_m, label_z_m, &shares);
    float fields[8 * LANES];
    sample_labels(displacement, gradient, flow, waves, rings, wake_maps, wakes, wake_count, params, &tile, &shares, tile_x,
                  tile_z, x_m, z_m, label_x_m, label_z_m, fields);
    for (int lane = 0; lane < min(LANES, point_count - first); ++lane) {
      const SurfaceQuerySample sample = {fields[lane],
                                         fields[LANES + lane],
                                         fields[2 * LANES + lane],
                                         fields[3 * LANES + lane],
                                         fields[4 * LANES + lane],
                                         fields[5 * LANES + lane],
                                         fields[6 * LANES + lane],
                                         fields[7 * LANES + lane]};
      samples[first + lane] = sample;
    }
  }
}
