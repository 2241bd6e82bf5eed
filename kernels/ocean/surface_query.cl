// The composed sea at points of the world: the label under each point is found first, as the surface moves sideways.
// In:  points; displacement, gradient, flow [cascades][n][n] float4 of ocean/surface_assemble.cl and
//      ocean/velocity_assemble.cl (flow is not read unless has_flow); waves, rings (shared/trochoids.h); params; time
//      as ocean/wave_phase.clh has it.
// Out: samples (shared/surface_query.h), the surface of ocean/surface_compose.cl where it meets the point's vertical.
// The label X solves X + d(X) = x. Steps X <- X - B (X + d(X) - x) end where the residual is small; the first is that of
// fixed-point iteration (B = 1), the others have B = (I + grad d)^-1 of the interpolated displacement: with B = 1 they would
// go on for dozens of steps where crests are steep. A point under a fold has several labels: one of them is found. Points that are not finite get a
// residual that is not either.
#include "ocean/deformation.clh"
#include "ocean/trochoid_ring.clh"
#include "shared/surface_query.h"

#if LANES == 1
#define mask_of(condition) ((condition) ? -1 : 0)
#define any_lane(condition) (condition)
#else
#define mask_of(condition) (condition)
#define any_lane(condition) any(condition)
#endif
#define CASCADES 4
#define VECTORS 8  // of LANES points, that a work-item takes

// Where a point's tile lies in each patch, in 2^-32 of it, and in each wave.
typedef struct {
  uint_lanes patch_x[CASCADES], patch_z[CASCADES];
  uint_lanes wave[TROCHOID_WAVES];
} Tile;

// Labels in texels of a cascade, lane by lane: the high bits of a place are the texel, the others what lies beyond it.
typedef struct {
  uint x[CASCADES * LANES], z[CASCADES * LANES];
} Places;

// Fields of the displacement and what a step needs of its derivative.
typedef struct {
  lanes shift_x, height, shift_z, gradient_xz;
  lanes x_by_x, z_by_x, x_by_z, z_by_z;
} Moved;

// The fractions of turns in 2^-32 of one. The factor is 2^32 - 2^8: half a turn is an int.
FFT_INLINE uint_lanes fraction_of(lanes turns) {
  return as_uint_lanes(convert_int_lanes((turns - rint(turns)) * 4294967040.0f));
}

// tile * step / 2^32 modulo 2^32, of a signed tile and a step in 2^-64.
FFT_INLINE uint_lanes tile_place(int_lanes tile, uint high, uint low) {
  const uint_lanes whole = as_uint_lanes(tile);
  return whole * high + mul_hi(whole, (uint_lanes)low) - (as_uint_lanes(tile >> 31) & low);
}

FFT_INLINE void set_tile(__global const SurfaceQueryParams *params, __global const SurfaceQueryWave *waves, int_lanes tile_x,
                         int_lanes tile_z, uint ticks, float tick_fraction, Tile *tile) {
  for (int cascade = 0; cascade < params->cascade_count; ++cascade) {
    const uint high = as_uint(params->tile_step_high[cascade]), low = as_uint(params->tile_step_low[cascade]);
    tile->patch_x[cascade] = tile_place(tile_x, high, low);
    tile->patch_z[cascade] = tile_place(tile_z, high, low);
  }
  for (int wave = 0; wave < params->wave_count; ++wave) {
    tile->wave[wave] = as_uint(waves[wave].phase) + as_uint_lanes(tile_x) * as_uint(waves[wave].tile_step_x) +
                       as_uint_lanes(tile_z) * as_uint(waves[wave].tile_step_z) -
                       turns_since((uint_lanes)as_uint(waves[wave].rate), ticks, tick_fraction);
  }
}

FFT_INLINE void set_places(__global const SurfaceQueryParams *params, const Tile *tile, lanes x_m, lanes z_m,
                           Places *places) {
  for (int cascade = 0; cascade < params->cascade_count; ++cascade) {
    const float patches_per_m = params->patches_per_m[cascade];
    store_lanes(tile->patch_x[cascade] + fraction_of(x_m * patches_per_m), places->x + cascade * LANES);
    store_lanes(tile->patch_z[cascade] + fraction_of(z_m * patches_per_m), places->z + cascade * LANES);
  }
}

FFT_INLINE void wave_at(__global const SurfaceQueryWave *wave, uint_lanes tile, lanes x_m, lanes z_m, lanes *cosine,
                        lanes *sine) {
  cosine_sine_of_turns(tile + fraction_of(x_m * wave->turns_x_perm + z_m * wave->turns_z_perm), cosine, sine);
}

// The four texels around a place.
typedef struct {
  size_t near_left, near_right, far_left, far_right;
  float u, v;  // of the way to the right, to the far side
} Cell;

FFT_INLINE Cell cell_at(const Places *places, int cascade, int lane, int size) {
  const uint column = places->x[cascade * LANES + lane], row = places->z[cascade * LANES + lane];
  const uint mask = (uint)size - 1u, below_texel = clz(mask), texel = 32u - below_texel;
  const uint left = column >> below_texel, right = (left + 1u) & mask;
  const uint near = row >> below_texel, far = (near + 1u) & mask;
  const size_t first = (size_t)cascade * size * size;
  const float per_unit = 2.3283064365386963e-10f;  // 2^-32
  const Cell cell = {first + near * size + left, first + near * size + right, first + far * size + left,
                     first + far * size + right, (float)(column << texel) * per_unit, (float)(row << texel) * per_unit};
  return cell;
}

FFT_INLINE float4 blend(__global const float4 *map, const Cell *cell) {
  return mix(mix(map[cell->near_left], map[cell->near_right], cell->u),
             mix(map[cell->far_left], map[cell->far_right], cell->u), cell->v);
}

// Four fields of LANES points out of a float4 a point.
FFT_INLINE void split_fields(const float4 *points, lanes *a, lanes *b, lanes *c, lanes *d) {
#if LANES == 1
  *a = points[0].x, *b = points[0].y, *c = points[0].z, *d = points[0].w;
#else
  float fields[4][LANES];
  FFT_UNROLL for (int lane = 0; lane < LANES; ++lane) {
    fields[0][lane] = points[lane].x, fields[1][lane] = points[lane].y;
    fields[2][lane] = points[lane].z, fields[3][lane] = points[lane].w;
  }
  *a = load_lanes(fields[0]), *b = load_lanes(fields[1]), *c = load_lanes(fields[2]), *d = load_lanes(fields[3]);
#endif
}

// A field of all cascades.
FFT_INLINE void sum_map(__global const float4 *map, __global const SurfaceQueryParams *params, const Places *places,
                        lanes *a, lanes *b, lanes *c, lanes *d) {
  float4 sums[LANES];
  for (int lane = 0; lane < LANES; ++lane) {
    float4 sum = (float4)(0.0f);
    for (int cascade = 0; cascade < params->cascade_count; ++cascade) {
      const Cell cell = cell_at(places, cascade, lane, params->size);
      sum += blend(map, &cell);
    }
    sums[lane] = sum;
  }
  split_fields(sums, a, b, c, d);
}

// The displacement of all cascades and its derivative, by differences across the cell: what a step needs exactly.
FFT_INLINE void sum_displacement(__global const float4 *map, __global const SurfaceQueryParams *params,
                                 const Places *places, Moved *moved) {
  float4 sums[LANES], derivatives[LANES];
  for (int lane = 0; lane < LANES; ++lane) {
    float4 sum = (float4)(0.0f), derivative = (float4)(0.0f);
    for (int cascade = 0; cascade < params->cascade_count; ++cascade) {
      const Cell cell = cell_at(places, cascade, lane, params->size);
      const float4 near_left = map[cell.near_left], far_left = map[cell.far_left];
      const float4 along_near = map[cell.near_right] - near_left, along_far = map[cell.far_right] - far_left;
      const float4 near = near_left + cell.u * along_near, across = far_left + cell.u * along_far - near;
      sum += near + cell.v * across;
      const float4 along = mix(along_near, along_far, cell.v);
      derivative += params->texels_per_m[cascade] * (float4)(along.xz, across.xz);
    }
    sums[lane] = sum;
    derivatives[lane] = derivative;
  }
  split_fields(sums, &moved->shift_x, &moved->height, &moved->shift_z, &moved->gradient_xz);
  split_fields(derivatives, &moved->x_by_x, &moved->z_by_x, &moved->x_by_z, &moved->z_by_z);
}

// The label, relative to the tile, under points relative to it.
FFT_INLINE void find_labels(__global const float4 *displacement, __global const SurfaceQueryParams *params,
                            __global const SurfaceQueryWave *waves, const Tile *tile, lanes x_m, lanes z_m,
                            lanes *label_x_m, lanes *label_z_m) {
  lanes at_x = x_m, at_z = z_m;
  for (int step = 0; step < SURFACE_QUERY_MOST_STEPS; ++step) {
    Places places;
    Moved moved;
    set_places(params, tile, at_x, at_z, &places);
    sum_displacement(displacement, params, &places, &moved);
    for (int i = 0; i < params->wave_count; ++i) {
      lanes cosine, sine;
      wave_at(waves + i, tile->wave[i], at_x, at_z, &cosine, &sine);
      moved.shift_x += waves[i].shift_x_m * sine;
      moved.shift_z += waves[i].shift_z_m * sine;
      moved.x_by_x += waves[i].gradient_xx * cosine;
      moved.x_by_z += waves[i].gradient_xz * cosine;
      moved.z_by_x += waves[i].gradient_xz * cosine;
      moved.z_by_z += waves[i].gradient_zz * cosine;
    }
    const lanes off_x = at_x + moved.shift_x - x_m, off_z = at_z + moved.shift_z - z_m;
    const int_lanes is_far = mask_of(off_x * off_x + off_z * off_z > params->tolerance_m * params->tolerance_m);
    if (!any_lane(is_far)) break;
    const lanes xx = 1.0f + moved.x_by_x, zz = 1.0f + moved.z_by_z;
    const lanes scale =
        1.0f / fmax(xx * zz - moved.x_by_z * moved.z_by_x, (lanes)SURFACE_QUERY_LEAST_DETERMINANT);
    const lanes step_x = step == 0 ? off_x : scale * (zz * off_x - moved.x_by_z * off_z);
    const lanes step_z = step == 0 ? off_z : scale * (xx * off_z - moved.z_by_x * off_x);
    at_x -= select((lanes)0.0f, step_x, is_far);
    at_z -= select((lanes)0.0f, step_z, is_far);
  }
  *label_x_m = at_x;
  *label_z_m = at_z;
}

// All that there is at LANES labels, for the points above them.
FFT_INLINE void sample_labels(__global const float4 *displacement, __global const float4 *gradient,
                              __global const float4 *flow, __global const SurfaceQueryWave *waves,
                              __global const TrochoidRingInTile *rings, __global const SurfaceQueryParams *params,
                              const Tile *tile, int_lanes tile_x, int_lanes tile_z, lanes x_m, lanes z_m, lanes label_x_m,
                              lanes label_z_m, float *fields) {
  Places places;
  set_places(params, tile, label_x_m, label_z_m, &places);
  lanes shift_x, height, shift_z, xz, slope_x, slope_z, xx, zz;
  sum_map(displacement, params, &places, &shift_x, &height, &shift_z, &xz);
  sum_map(gradient, params, &places, &slope_x, &slope_z, &xx, &zz);
  lanes velocity_x = (lanes)0.0f, velocity_y = (lanes)0.0f, velocity_z = (lanes)0.0f, head = (lanes)0.0f;
  if (params->has_flow) sum_map(flow, params, &places, &velocity_x, &velocity_y, &velocity_z, &head);
  for (int i = 0; i < params->wave_count; ++i) {
    lanes cosine, sine;
    wave_at(waves + i, tile->wave[i], label_x_m, label_z_m, &cosine, &sine);
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
  for (int i = 0; i < params->ring_count; ++i) {
    const lanes from_x = convert_lanes(tile_x - rings[i].tile_x) * SURFACE_QUERY_TILE_M - rings[i].ring.centre_x_m;
    const lanes from_z = convert_lanes(tile_z - rings[i].tile_z) * SURFACE_QUERY_TILE_M - rings[i].ring.centre_z_m;
    lanes ring_height = (lanes)0.0f;
    add_ring(&rings[i].ring, from_x + label_x_m, from_z + label_z_m, &ring_height, &slope_x, &slope_z);
    height += ring_height;
    head += ring_height * exp(-6.2831853072f * params->depth_m / rings[i].ring.wavelength_m);
  }
  xx += 1.0f;
  zz += 1.0f;
  const lanes jacobian = xx * zz - xz * xz;
  const lanes determinant = LIMITED_DETERMINANT(jacobian);
  const lanes off_x = label_x_m + shift_x - x_m, off_z = label_z_m + shift_z - z_m;
  store_lanes(height, fields);
  store_lanes((zz * slope_x - xz * slope_z) / determinant, fields + LANES);
  store_lanes((xx * slope_z - xz * slope_x) / determinant, fields + 2 * LANES);
  store_lanes(sqrt(off_x * off_x + off_z * off_z), fields + 3 * LANES);
  store_lanes(velocity_x, fields + 4 * LANES);
  store_lanes(velocity_y, fields + 5 * LANES);
  store_lanes(velocity_z, fields + 6 * LANES);
  const lanes pressure_pa = params->weight_papm * (params->depth_m + head - height);
  store_lanes(params->has_flow ? pressure_pa : (lanes)0.0f, fields + 7 * LANES);
}

__kernel void surface_query(__global const SurfaceQueryPoint *restrict points, __global const float4 *restrict displacement,
                            __global const float4 *restrict gradient, __global const float4 *restrict flow,
                            __global const SurfaceQueryWave *restrict waves,
                            __global const TrochoidRingInTile *restrict rings,
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
    find_labels(displacement, params, waves, &tile, x_m, z_m, &label_x_m, &label_z_m);
    float fields[8 * LANES];
    sample_labels(displacement, gradient, flow, waves, rings, params, &tile, tile_x, tile_z, x_m, z_m, label_x_m,
                  label_z_m, fields);
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
