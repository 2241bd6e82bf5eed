// The picture of the puffs of clouds (C9): what they send toward the eye and let through.
// In:  puffs of kernels/clouds/puff_project.cl, list, first and seen of kernels/clouds/puff_tiles.cl,
// textures of
//      host/clouds/puff_textures.h, scene_depth [height][width] near_m over the distance along the line of
//      sight to what hides the clouds behind it, 0 where nothing does.
// Out: image [height][width] RGBA, kcd/m^2, premultiplied; distance_m [height][width], mean distance of that
// light, 0
//      where there is none. Row 0 is at the bottom.
// Puffs are gathered in layers, each shared linearly between the two that it lies between, and all of a layer
// is mixed: so a picture changes steadily as puffs pass each other, whatever their order, and lets exactly as
// much light through as all of them do one by one.
#include "clouds/puff_ray.clh"

// What is let through that nobody sees any more: half a step of 8 bits.
#define LEAST_THROUGH 2e-3f

// Sums over puffs of optical depth, and of that times light.
typedef struct {
  lanes depth, red, green, blue;
} Layer;

typedef struct {
  lanes red, green, blue, distance_m;
  lanes through;  // of what lies behind
} Sight;

// Puts a layer behind what is seen so far, and empties it.
FFT_INLINE void close_layer(Layer* layer, int index, Sight* sight) {
  const float distance_m =
      CLOUD_LAYER_M / CLOUD_LAYER_GROWTH * (exp(CLOUD_LAYER_GROWTH * (float)index) - 1.0f);
  const lanes through = sight->through * exp_of(-layer->depth);
  const lanes opacity = sight->through - through;
  const lanes mean = opacity / most(layer->depth, (lanes)1e-20f);
  sight->red = fma(mean, layer->red, sight->red);
  sight->green = fma(mean, layer->green, sight->green);
  sight->blue = fma(mean, layer->blue, sight->blue);
  sight->distance_m = fma(opacity, (lanes)distance_m, sight->distance_m);
  sight->through = through;
  layer->depth = layer->red = layer->green = layer->blue = 0.0f;
}

FFT_INLINE void add_to(Layer* layer, const CloudPuff* puff, PuffSeen seen, float share) {
  const lanes depth = share * seen.depth, light = depth * seen.light;
  layer->depth += depth;
  layer->red = fma(light, (lanes)puff->red, layer->red);
  layer->green = fma(light, (lanes)puff->green, layer->green);
  layer->blue = fma(light, (lanes)puff->blue, layer->blue);
}

FFT_INLINE Sight sight_of(__global const CloudPuff* puffs, __global const uint* list, int seen_count,
                          __global const uint* textures, PuffRays rays, float farthest_m) {
  Sight sight = {0.0f, 0.0f, 0.0f, 0.0f, 1.0f};
  Layer here = {0.0f, 0.0f, 0.0f, 0.0f}, next = {0.0f, 0.0f, 0.0f, 0.0f};
  int index = 0;
  for (int i = 0; i < seen_count; ++i) {
    const CloudPuff puff = puffs[list[i]];
    if (puff.distance_m - puff.radius_m > farthest_m) continue;
    PuffSeen seen;
    if (!see_puff(textures, &puff, rays, &seen)) continue;
    const int nearer = max((int)puff.layer, index);
    if (nearer > index) {
      close_layer(&here, index, &sight);
      if (nearer == index + 1) {
        here = next;
        next.depth = next.red = next.green = next.blue = 0.0f;
      } else {
        close_layer(&next, index + 1, &sight);
      }
      index = nearer;
      if (!any_lane(mask_of(sight.through > LEAST_THROUGH))) break;
    }
    // Rounding may put a puff before the one that it follows.
    const float share = clamp(puff.layer - (float)nearer, 0.0f, 1.0f);
    add_to(&here, &puff, seen, 1.0f - share);
    add_to(&next, &puff, seen, share);
  }
  close_layer(&here, index, &sight);
  close_layer(&next, index + 1, &sight);
  return sight;
}

FFT_INLINE float farthest_of(lanes scene_m) {
#if LANES == 1
  return scene_m;
#else
  const float8 eight = max(scene_m.lo, scene_m.hi);
  const float4 four = max(eight.lo, eight.hi);
  const float2 two = max(four.lo, four.hi);
  return max(two.x, two.y);
#endif
}

FFT_INLINE PuffRays rays_of(CloudPictureParams params, lanes column, float row, lanes scene_depth) {
  const lanes across = ((column + 0.5f) * (2.0f / (float)params.width_px) - 1.0f) * params.half_width;
  const float above = ((row + 0.5f) * (2.0f / (float)params.height_px) - 1.0f) * params.half_height;
  const lanes scale = 1.0f / sqrt(fma(across, across, (lanes)fma(above, above, 1.0f)));
  const PuffRays rays = {
      scale * fma(across, (lanes)params.right_x, (lanes)fma(above, params.up_x, params.forward_x)),
      scale * fma(across, (lanes)params.right_y, (lanes)fma(above, params.up_y, params.forward_y)),
      scale * fma(across, (lanes)params.right_z, (lanes)fma(above, params.up_z, params.forward_z)),
      params.near_m / (scene_depth * scale)};
  return rays;
}

__kernel void puff_composite(__global const CloudPuff* restrict puffs, __global const int* restrict first,
                             __global const int* restrict seen, __global const uint* restrict list,
                             __global const uint* restrict textures,
                             __global const float* restrict scene_depth, CloudPictureParams params,
                             __global float* restrict image, __global float* restrict distance_m) {
#if LANES == 1
  const int column = (int)get_global_id(0), first_row = (int)get_global_id(1), last_row = first_row;
  if (column >= params.width_px || first_row >= params.height_px) return;
  const int tile = first_row / CLOUD_TILE_PX * params.tile_columns + column / CLOUD_TILE_PX;
#else
  const int tile = (int)get_global_id(0);
  const int column = tile % params.tile_columns * CLOUD_TILE_PX;
  const int first_row = tile / params.tile_columns * CLOUD_TILE_PX;
  const int last_row = min(first_row + CLOUD_TILE_PX, params.height_px) - 1;
#endif
  const lanes columns = (float)column + LANE_INDEX;
  // A picture may end within a tile: lanes beyond its edge see what the last one does, and write nothing.
  const int_lanes places = min(convert_int_lanes(columns), (int_lanes)(params.width_px - 1));
  for (int row = first_row; row <= last_row; ++row) {
    const int begin = row * params.width_px;
    const PuffRays rays =
        rays_of(params, convert_lanes(places), (float)row, gathered(scene_depth, begin + places));
    const Sight sight =
        sight_of(puffs, list + first[tile], seen[tile], textures, rays, farthest_of(rays.scene_m));
    const lanes opacity = 1.0f - sight.through;
    const lanes mean_m = sight.distance_m / most(opacity, (lanes)1e-20f);
    __global float* target = image + 4 * (size_t)(begin + column);
    __global float* distances = distance_m + begin + column;
#if LANES > 1
    if (column + LANES > params.width_px) {
      float lane_values[5][LANES];
      store_lanes(sight.red, lane_values[0]);
      store_lanes(sight.green, lane_values[1]);
      store_lanes(sight.blue, lane_values[2]);
      store_lanes(opacity, lane_values[3]);
      store_lanes(mean_m, lane_values[4]);
      for (int lane = 0; column + lane < params.width_px; ++lane) {
        for (int c = 0; c < 4; ++c) target[4 * lane + c] = lane_values[c][lane];
        distances[lane] = lane_values[4][lane];
      }
      continue;
    }
#endif
    store_interleaved_4(sight.red, sight.green, sight.blue, opacity, target);
    store_lanes(mean_m, distances);
  }
}
