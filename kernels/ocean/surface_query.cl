// The composed sea at points of the world: the label under each point is found first, as the surface moves sideways.
// In:  points; the cascades' waves, as SOURCE says where they are read from: QUERY_FRAME_MAPS, QUERY_MAPS or QUERY_MODES of
//      shared/query_params.h; waves, params (shared/query_params.h), rings (GerstnerRingInTile of shared/gerstner_params.h);
//      wake_maps of ocean/wakes/wake_map.cl, wakes (shared/wake.h); time as ocean/wave_phase.clh has it; with SHOALS shoals,
//      depths_m [rows][columns], shoal_shares (shared/shoal_params.h).
// Out: samples (SurfaceQueryShifted of shared/query_params.h, or its first floats), the surface of ocean/surface_compose.cl where
//      it meets the point's vertical.
// The host sets VECTORS, of LANES points each, that a work-item takes. With QUERY_MODES a group of GROUP work-items takes one
// point, which is in all lanes.
// The label X solves X + d(X) = x. Steps X <- X - B (X + d(X) - x) end where the residual is small; the first is that
// of fixed-point iteration (B = 1), the others have B = (I + grad d)^-1 of the interpolated displacement: with B = 1
// they would go on for dozens of steps where crests are steep. A point under a fold has several labels: one of them is
// found. Points that are not finite get a residual that is not either.
#include "ocean/deformation.clh"
#include "ocean/gerstner_ring.clh"
#include "ocean/query_place.clh"
#include "ocean/wakes/wake_layer.clh"
#include "shared/query_params.h"
#if SOURCE == QUERY_FRAME_MAPS
#include "ocean/frame_cells.clh"
#elif SOURCE == QUERY_MAPS
#include "ocean/spline_cells.clh"
#else
#include "ocean/mode_sums.clh"
#endif

INLINE void wave_at(__global const SurfaceQueryWave *wave, uint_lanes tile, const Shares *shares, lanes x_m, lanes z_m,
                        lanes *cosine, lanes *sine) {
  cosine_sine_of_turns(tile + fraction_of(x_m * wave->turns_x_perm + z_m * wave->turns_z_perm), cosine, sine);
  const lanes share = gerstner_share(shares, wave->band);
  *cosine *= share;
  *sine *= share;
}

// Cascades that a step counts. The Gerstner waves are the longest and move the label farthest: the first step takes them alone.
// Then come the longest cascade and the others: where short waves are read, the label has found its place among longer ones.
INLINE int cascades_in(__global const SurfaceQueryParams *params, int step) {
  const int before = params->wave_count > 0 ? 1 : 0, all = params->cascade_count;
  if (SOURCE == QUERY_FRAME_MAPS) return step >= before ? all : 0;
  return step > before ? all : min(max(step - before + 1, 0), all);
}

// The label, relative to the tile, under points relative to it, what shoals leave of the waves there, and how the cascades move
// it. That shares differ from label to label is no part of the derivative: they do slowly.
INLINE void find_labels(const Source *source, __global const SurfaceQueryParams *params,
                            __global const SurfaceQueryWave *waves, const Tile *tile, int_lanes tile_x, int_lanes tile_z,
                            lanes x_m, lanes z_m, lanes *label_x_m, lanes *label_z_m, Shares *shares, Cells *cells,
                            Moved *cascades) {
  const Moved still = {(lanes)0.0f, (lanes)0.0f, (lanes)0.0f, (lanes)0.0f, (lanes)0.0f, (lanes)0.0f};
  lanes at_x = x_m, at_z = z_m;
  int wanted[LANES];
  for (int lane = 0; lane < LANES; ++lane) wanted[lane] = 1;
  for (int step = 0; step < SURFACE_QUERY_MOST_STEPS; ++step) {
    const int cascade_count = cascades_in(params, step);
    const bool takes_all = cascade_count == params->cascade_count;
    Moved moved = still;
    *cascades = still;
    if (cascade_count > 0) {
      set_cells(params, tile, at_x, at_z, cells);
      fetch_displacement(source, params, cascade_count, wanted, cells);
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
    if (cascade_count > 0) add_displacement(source, params, cascade_count, wanted, cells, shares, cascades);
    const lanes off_x = at_x + moved.x + cascades->x - x_m, off_z = at_z + moved.z + cascades->z - z_m;
    const int_lanes is_far = mask_of(off_x * off_x + off_z * off_z > params->tolerance_m * params->tolerance_m);
    if (takes_all && (!any_lane(is_far) || step == SURFACE_QUERY_MOST_STEPS - 1)) break;
    const lanes xx = 1.0f + moved.x_by_x + cascades->x_by_x, zz = 1.0f + moved.z_by_z + cascades->z_by_z;
    const lanes xz = moved.x_by_z + cascades->x_by_z, zx = moved.z_by_x + cascades->z_by_x;
    const lanes scale = 1.0f / fmax(xx * zz - xz * zx, (lanes)LEAST_DETERMINANT);
    const lanes step_x = step == 0 ? off_x : scale * (zz * off_x - xz * off_z);
    const lanes step_z = step == 0 ? off_z : scale * (xx * off_z - zx * off_x);
    at_x -= select((lanes)0.0f, step_x, is_far);
    at_z -= select((lanes)0.0f, step_z, is_far);
    // Labels that stay where they are have what was summed there, once all cascades were in it.
    if (takes_all) store_lanes(is_far, wanted);
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
INLINE void sample_labels(const Source *source, __global const SurfaceQueryWave *waves,
                              __global const GerstnerRingInTile *rings, __global const float4 *wake_maps,
                              __global const WakeLayer *wakes, int wake_count,
                              __global const SurfaceQueryParams *params, const Tile *tile, const Shares *shares,
                              const Cells *cells, const Moved *cascades, int_lanes tile_x, int_lanes tile_z, lanes x_m,
                              lanes z_m, lanes label_x_m, lanes label_z_m, float *fields) {
  fetch_water(source, params, cells);
  const lanes none = (lanes)0.0f;
  Water water = {none, none, none, none, none, none, none, none, none, none, none, none, none, none, none};
  for (int i = 0; i < params->wave_count; ++i) {
    lanes cosine, sine;
    wave_at(waves + i, tile->wave[i], shares, label_x_m, label_z_m, &cosine, &sine);
    water.shift_x += waves[i].shift_x_m * sine;
    water.height += waves[i].height_m * cosine;
    water.shift_z += waves[i].shift_z_m * sine;
    water.slope_x += waves[i].slope_x * sine;
    water.slope_z += waves[i].slope_z * sine;
    water.xx += waves[i].gradient_xx * cosine;
    water.xz += waves[i].gradient_xz * cosine;
    water.zz += waves[i].gradient_zz * cosine;
    water.velocity_x += waves[i].velocity_x_mps * cosine;
    water.velocity_y += waves[i].velocity_y_mps * sine;
    water.velocity_z += waves[i].velocity_z_mps * cosine;
    water.head += waves[i].head_m * cosine;
    const float omega = waves[i].omega_radps;
    water.acceleration_x += omega * waves[i].velocity_x_mps * sine;
    water.acceleration_y -= omega * waves[i].velocity_y_mps * cosine;
    water.acceleration_z += omega * waves[i].velocity_z_mps * sine;
  }
  add_water(source, params, cells, shares, cascades, &water);
  for (int i = 0; i < params->ring_count; ++i) {
    const lanes from_x = convert_lanes(tile_x - rings[i].tile_x) * SURFACE_QUERY_TILE_M - rings[i].ring.centre_x_m;
    const lanes from_z = convert_lanes(tile_z - rings[i].tile_z) * SURFACE_QUERY_TILE_M - rings[i].ring.centre_z_m;
    lanes ring_height = (lanes)0.0f;
    add_ring(&rings[i].ring, from_x + label_x_m, from_z + label_z_m, &ring_height, &water.slope_x, &water.slope_z);
    water.height += ring_height;
    water.head += ring_height * exp(-6.2831853072f * params->depth_m / rings[i].ring.wavelength_m);
  }
  add_wakes(wake_maps, wakes, wake_count, params->depth_m, tile_x, tile_z, label_x_m, label_z_m, &water.height,
            &water.slope_x, &water.slope_z, &water.velocity_y, &water.head);
  const lanes xx = 1.0f + water.xx, xz = water.xz, zz = 1.0f + water.zz;
  const lanes jacobian = xx * zz - xz * xz;
  const lanes determinant = LIMITED_DETERMINANT(jacobian);
  const lanes off_x = label_x_m + water.shift_x - x_m, off_z = label_z_m + water.shift_z - z_m;
  const lanes slope_x = (zz * water.slope_x - xz * water.slope_z) / determinant;
  const lanes slope_z = (xx * water.slope_z - xz * water.slope_x) / determinant;
  const lanes missed2 = off_x * off_x + off_z * off_z;
  lanes height = water.height;
#if SOURCE != QUERY_FRAME_MAPS
  // A label that was found is off by so little that the surface is straight up to the point.
  height -= select((lanes)0.0f, slope_x * off_x + slope_z * off_z,
                   mask_of(missed2 <= params->tolerance_m * params->tolerance_m));
#endif
  store_lanes(height, fields);
  store_lanes(slope_x, fields + LANES);
  store_lanes(slope_z, fields + 2 * LANES);
  store_lanes(sqrt(missed2), fields + 3 * LANES);
  // Of what is not asked for nothing is told.
  const float flow = params->has_flow != 0 ? 1.0f : 0.0f, rate = SOURCE == QUERY_FRAME_MAPS ? 0.0f : flow;
  store_lanes(flow * water.velocity_x, fields + 4 * LANES);
  store_lanes(flow * water.velocity_y, fields + 5 * LANES);
  store_lanes(flow * water.velocity_z, fields + 6 * LANES);
  store_lanes(flow * params->weight_papm * (params->depth_m + water.head - water.height), fields + 7 * LANES);
  store_lanes(rate * water.acceleration_x, fields + 8 * LANES);
  store_lanes(rate * water.acceleration_y, fields + 9 * LANES);
  store_lanes(rate * water.acceleration_z, fields + 10 * LANES);
  store_lanes((lanes)params->error_rms_m, fields + 11 * LANES);
  store_lanes(water.shift_x, fields + 12 * LANES);
  store_lanes(water.shift_z, fields + 13 * LANES);
}

#define SAMPLE_FLOATS 14

#if SOURCE == QUERY_MODES && LANES == 1
__attribute__((reqd_work_group_size(GROUP, 1, 1)))
#endif
__kernel void surface_query(__global const SurfaceQueryPoint *restrict points, QUERY_SOURCE_PARAMETERS,
                            __global const SurfaceQueryWave *restrict waves,
                            __global const GerstnerRingInTile *restrict rings,
                            __global const float4 *restrict wake_maps, __global const WakeLayer *restrict wakes,
                            int wake_count,
#if SHOALS
                            __global const ShoalMap *restrict shoals, __global const float *restrict depths_m,
                            __global const float *restrict shoal_shares,
#endif
                            __global const SurfaceQueryParams *restrict params, int point_count, uint ticks,
                            float tick_fraction, __global float *restrict samples) {
#if SOURCE == QUERY_MODES && LANES == 1
  __local float scratch[SCRATCH_FLOATS];
#endif
  const Source source = QUERY_SOURCE;
#if SOURCE == QUERY_MODES
  const int start = (int)get_group_id(0), end = start + 1, step = 1;
#else
  const int start = (int)get_global_id(0) * VECTORS * LANES, end = min(start + VECTORS * LANES, point_count), step = LANES;
#endif
  for (int first = start; first < end; first += step) {
    int tiles_x[LANES], tiles_z[LANES];
    float xs_m[LANES], zs_m[LANES];
    for (int lane = 0; lane < LANES; ++lane) {
      // Lanes beyond the last point work on it too.
      const SurfaceQueryPoint point = points[min(first + lane, end - 1)];
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
    Cells cells;
    Moved cascades;
    find_labels(&source, params, waves, &tile, tile_x, tile_z, x_m, z_m, &label_x_m, &label_z_m, &shares, &cells, &cascades);
    float fields[SAMPLE_FLOATS * LANES];
    sample_labels(&source, waves, rings, wake_maps, wakes, wake_count, params, &tile, &shares, &cells, &cascades, tile_x,
                  tile_z, x_m, z_m, label_x_m, label_z_m, fields);
    const int floats = params->sample_floats;
    for (int lane = 0; lane < min(step, end - first); ++lane) {
      __global float *sample = samples + (size_t)(first + lane) * floats;
      for (int i = 0; i < floats; ++i) sample[i] = fields[i * LANES + lane];
    }
  }
}
