// The picture of the billboards of clouds (C9): what they send toward the eye and let through.
// In:  billboards of kernels/clouds/billboard_project.cl, list, first and seen of kernels/clouds/billboard_tiles.cl,
// textures of
//      host/clouds/image/billboard_textures.h, scene_depth [height][width] near_m over the distance along the line of
//      sight to what hides the clouds behind it, 0 where nothing does.
// Out: image [height][width] RGBA, kcd/m^2, premultiplied; distance_m [height][width], mean distance of that
// light, 0
//      where there is none. Row 0 is at the bottom.
// Billboards are gathered in layers, each shared linearly between the two that it lies between, and all of a layer
// is mixed: so a picture changes steadily as billboards pass each other, whatever their order, and lets exactly as
// much light through as all of them do one by one.
#include "clouds/billboard_ray.clh"

// Pixels that let less through, half a step of 8 bits, are taken as full of what they have shown.
#define LEAST_THROUGH 2e-3f

// Pixels side by side: a block of the picture, whose rays meet the same particles and texels.
#if LANES == 1
#define BLOCK_PX 1
#define BLOCK_COLUMN 0
#define BLOCK_ROW 0
#else
#define BLOCK_PX 4
#define BLOCK_COLUMN (int_lanes)(0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3)
#define BLOCK_ROW (int_lanes)(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3)
#endif

// Sums over billboards of optical depth, and of that times light.
typedef struct {
  lanes depth, red, green, blue;
} Layer;

typedef struct {
  lanes red, green, blue, distance_m;
  lanes through;  // of what lies behind
} Sight;

// Puts a layer behind what is seen so far, and empties it.
INLINE void close_layer(Layer* layer, float distance_m, Sight* sight) {
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

INLINE void add_to(Layer* layer, const CloudBillboard* billboard, BillboardSeen seen, float share) {
  const lanes depth = share * seen.depth, light = depth * seen.light;
  layer->depth += depth;
  layer->red = fma(light, (lanes)billboard->red, layer->red);
  layer->green = fma(light, (lanes)billboard->green, layer->green);
  layer->blue = fma(light, (lanes)billboard->blue, layer->blue);
}

// Where the layer behind one begins: layers grow by e^CLOUD_LAYER_GROWTH.
INLINE float behind(float layer_m) {
  return fma(layer_m, CLOUD_LAYER_RATIO, CLOUD_LAYER_M / CLOUD_LAYER_GROWTH * (CLOUD_LAYER_RATIO - 1.0f));
}

// What is seen of pixels that are nearly full already.
INLINE void fill(Sight* sight) {
  const lanes scale = 1.0f / (1.0f - sight->through);
  sight->red *= scale;
  sight->green *= scale;
  sight->blue *= scale;
  sight->distance_m *= scale;
  sight->through = 0.0f;
}

INLINE Sight sight_of(__global const CloudBillboard* billboards, __global const uint* list, int seen_count,
                          __global const uint* textures, BillboardRays rays, float farthest_m) {
  Sight sight = {0.0f, 0.0f, 0.0f, 0.0f, 1.0f};
  Layer here = {0.0f, 0.0f, 0.0f, 0.0f}, next = {0.0f, 0.0f, 0.0f, 0.0f};
  int index = 0;
  float layer_m = 0.0f;
  for (int i = 0; i < seen_count; ++i) {
    const CloudBillboard billboard = billboards[list[i]];
    if (billboard.distance_m - billboard.radius_m > farthest_m) continue;
    BillboardSeen seen;
    if (!see_billboard(textures, &billboard, rays, &seen)) continue;
    const int nearer = max((int)billboard.layer, index);
    if (nearer > index) {
      close_layer(&here, layer_m, &sight);
      if (nearer == index + 1) {
        here = next;
        next.depth = next.red = next.green = next.blue = 0.0f;
      } else {
        close_layer(&next, behind(layer_m), &sight);
      }
      index = nearer;
      layer_m = billboard.layer_m;
      if (!any_lane(mask_of(sight.through > LEAST_THROUGH))) {
        fill(&sight);
        return sight;
      }
    }
    // Rounding may put a billboard before the one that it follows.
    const float share = clamp(billboard.layer - (float)nearer, 0.0f, 1.0f);
    add_to(&here, &billboard, seen, 1.0f - share);
    add_to(&next, &billboard, seen, share);
  }
  close_layer(&here, layer_m, &sight);
  close_layer(&next, behind(layer_m), &sight);
  return sight;
}

INLINE float farthest_of(lanes scene_m) {
#if LANES == 1
  return scene_m;
#else
  const float8 eight = max(scene_m.lo, scene_m.hi);
  const float4 four = max(eight.lo, eight.hi);
  const float2 two = max(four.lo, four.hi);
  return max(two.x, two.y);
#endif
}

INLINE BillboardRays rays_of(CloudImageParams params, lanes column, lanes row, lanes scene_depth) {
  const lanes across = ((column + 0.5f) * (2.0f / (float)params.width_px) - 1.0f) * params.half_width;
  const lanes above = ((row + 0.5f) * (2.0f / (float)params.height_px) - 1.0f) * params.half_height;
  const lanes scale = 1.0f / sqrt(fma(across, across, fma(above, above, (lanes)1.0f)));
  const BillboardRays rays = {
      scale * fma(across, (lanes)params.right_x, fma(above, (lanes)params.up_x, (lanes)params.forward_x)),
      scale * fma(across, (lanes)params.right_y, fma(above, (lanes)params.up_y, (lanes)params.forward_y)),
      scale * fma(across, (lanes)params.right_z, fma(above, (lanes)params.up_z, (lanes)params.forward_z)),
      params.near_m / (scene_depth * scale)};
  return rays;
}

// Puts the pixels of a block whose corner this is where they belong, those within the picture.
INLINE void write_block(Sight sight, int column, int row, CloudImageParams params,
                            __global float* restrict image, __global float* restrict distance_m) {
  const lanes opacity = 1.0f - sight.through;
  const lanes mean_m = sight.distance_m / most(opacity, (lanes)1e-20f);
  const int begin = row * params.width_px + column;
#if LANES == 1
  store_interleaved_4(sight.red, sight.green, sight.blue, opacity, image + 4 * (size_t)begin);
  distance_m[begin] = mean_m;
#else
  const lanes low_rb = interleave_low(sight.red, sight.blue), high_rb = interleave_high(sight.red, sight.blue);
  const lanes low_ga = interleave_low(sight.green, opacity), high_ga = interleave_high(sight.green, opacity);
  const lanes texels[BLOCK_PX] = {interleave_low(low_rb, low_ga), interleave_high(low_rb, low_ga),
                                  interleave_low(high_rb, high_ga), interleave_high(high_rb, high_ga)};
  const float4 distances[BLOCK_PX] = {mean_m.lo.lo, mean_m.lo.hi, mean_m.hi.lo, mean_m.hi.hi};
  const int columns = min(BLOCK_PX, params.width_px - column), rows = min(BLOCK_PX, params.height_px - row);
  for (int y = 0; y < rows; ++y) {
    const int place = begin + y * params.width_px;
    if (columns == BLOCK_PX) {
      store_lanes(texels[y], image + 4 * (size_t)place);
      vstore4(distances[y], 0, distance_m + place);
      continue;
    }
    float values[4 * BLOCK_PX], row_m[BLOCK_PX];
    store_lanes(texels[y], values);
    vstore4(distances[y], 0, row_m);
    for (int x = 0; x < columns; ++x) {
      vstore4(vload4(x, values), 0, image + 4 * (size_t)(place + x));
      distance_m[place + x] = row_m[x];
    }
  }
#endif
}

__kernel void billboard_composite(__global const CloudBillboard* restrict billboards, __global const int* restrict first,
                             __global const int* restrict seen, __global const uint* restrict list,
                             __global const uint* restrict textures,
                             __global const float* restrict scene_depth, CloudImageParams params,
                             __global float* restrict image, __global float* restrict distance_m) {
#if LANES == 1
  const int left = (int)get_global_id(0), bottom = (int)get_global_id(1), right = left + 1, top = bottom + 1;
  if (left >= params.width_px || bottom >= params.height_px) return;
  const int tile = bottom / CLOUD_TILE_PX * params.tile_columns + left / CLOUD_TILE_PX;
#else
  const int tile = (int)get_global_id(0);
  const int left = tile % params.tile_columns * CLOUD_TILE_PX;
  const int bottom = tile / params.tile_columns * CLOUD_TILE_PX;
  const int right = min(left + CLOUD_TILE_PX, params.width_px);
  const int top = min(bottom + CLOUD_TILE_PX, params.height_px);
#endif
  for (int row = bottom; row < top; row += BLOCK_PX) {
    for (int column = left; column < right; column += BLOCK_PX) {
      // A picture may end within a block: pixels beyond its edge see what the last ones do.
      const int_lanes columns = up_to(column + BLOCK_COLUMN, params.width_px - 1);
      const int_lanes rows = up_to(row + BLOCK_ROW, params.height_px - 1);
      const lanes depth = gathered(scene_depth, rows * params.width_px + columns);
      const BillboardRays rays = rays_of(params, convert_lanes(columns), convert_lanes(rows), depth);
      const Sight sight =
          sight_of(billboards, list + first[tile], seen[tile], textures, rays, farthest_of(rays.scene_m));
      write_block(sight, column, row, params, image, distance_m);
    }
  }
}
