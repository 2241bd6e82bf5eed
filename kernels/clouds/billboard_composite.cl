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
#include "clouds/march/pixel_rays.clh"
#include "shared/clouds.h"
#include "simd/lane_exponents.clh"

// What a billboard does along rays: its optical depth, and its light over that of its sprite.
typedef struct {
  lanes depth;
  lanes light;
} BillboardSeen;

// No texel is more opaque than this, so that its depth is finite.
#define LEAST_CLEAR 1e-4f

// Integral of h (C1) from the point of a ray that is nearest to the middle, `square` radii^2 from it, to z
// radii on.
INLINE lanes density_integral(lanes square, lanes z) {
  // h = 1 - 22/9 q + 17/9 q^2 - 4/9 q^3 of q = square + z^2, in powers of z^2.
  const lanes k0 = fma(
      square, fma(square, fma(square, (lanes)(-4.0f / 9.0f), (lanes)(17.0f / 9.0f)), (lanes)(-22.0f / 9.0f)),
      (lanes)1.0f);
  const lanes k1 =
      fma(square, fma(square, (lanes)(-4.0f / 9.0f), (lanes)(34.0f / 27.0f)), (lanes)(-22.0f / 27.0f));
  const lanes k2 = fma(square, (lanes)(-4.0f / 15.0f), (lanes)(17.0f / 45.0f));
  const lanes z2 = z * z;
  return z * fma(z2, fma(z2, fma(z2, (lanes)(-4.0f / 63.0f), k2), k1), k0);
}

// The texels at places in level 0 ... level_px of a texture, bilinear: turn rightward and upward, and opacity
// where its mean is 1/3 and 2/3, all 0 ... 1.
typedef struct {
  lanes turn_x, turn_y, third, two_thirds;
} BillboardTexel;

INLINE BillboardTexel unpacked(uint_lanes texel, lanes share) {
  const BillboardTexel result = {share * convert_lanes(texel & 255u), share * convert_lanes((texel >> 8) & 255u),
                            share * convert_lanes((texel >> 16) & 255u), share * convert_lanes(texel >> 24)};
  return result;
}

INLINE BillboardTexel sum_of(BillboardTexel a, BillboardTexel b) {
  const BillboardTexel result = {a.turn_x + b.turn_x, a.turn_y + b.turn_y, a.third + b.third,
                            a.two_thirds + b.two_thirds};
  return result;
}

INLINE BillboardTexel texel_at(__global const uint* textures, uint first, int level_px, lanes x, lanes y,
                              float share) {
  const lanes column = floor(x), row = floor(y);
  const lanes in_x = x - column, in_y = y - row;
  const int last = level_px - 1;
  const int_lanes left = up_to(convert_int_lanes(column), last),
                  right = up_to(convert_int_lanes(column) + 1, last);
  const int_lanes low = (int)first + up_to(convert_int_lanes(row), last) * level_px;
  const int_lanes high = (int)first + up_to(convert_int_lanes(row) + 1, last) * level_px;
  const lanes upper = share / 255.0f * in_y, lower = share / 255.0f - upper;
  const BillboardTexel below =
      sum_of(unpacked(gathered_as(uint_lanes, textures, low + left), lower - lower * in_x),
             unpacked(gathered_as(uint_lanes, textures, low + right), lower * in_x));
  const BillboardTexel above =
      sum_of(unpacked(gathered_as(uint_lanes, textures, high + left), upper - upper * in_x),
             unpacked(gathered_as(uint_lanes, textures, high + right), upper * in_x));
  return sum_of(below, above);
}

// Places are -1 ... 1 over the texture.
INLINE BillboardTexel billboard_texel(__global const uint* textures, const CloudBillboard* billboard, lanes x, lanes y) {
  const float half_px = 0.5f * (float)billboard->level_px;
  BillboardTexel texel =
      texel_at(textures, billboard->texels, billboard->level_px, fma(x, (lanes)half_px, (lanes)(half_px - 0.5f)),
               fma(y, (lanes)half_px, (lanes)(half_px - 0.5f)), 1.0f - billboard->coarser);
  if (billboard->coarser > 0.0f) {
    const float quarter_px = 0.5f * half_px;
    const uint next = billboard->texels + (uint)(billboard->level_px * billboard->level_px);
    texel = sum_of(texel, texel_at(textures, next, billboard->level_px / 2,
                                   fma(x, (lanes)quarter_px, (lanes)(quarter_px - 0.5f)),
                                   fma(y, (lanes)quarter_px, (lanes)(quarter_px - 0.5f)), billboard->coarser));
  }
  return texel;
}

// What the pattern of a texel makes of a mean opacity (billboard_textures.h).
INLINE lanes patterned(BillboardTexel texel, lanes mean) {
  const lanes in_thirds = 3.0f * mean;
  const lanes thin = in_thirds * texel.third;
  const lanes middle = fma(in_thirds - 1.0f, texel.two_thirds - texel.third, texel.third);
  const lanes dense = fma(in_thirds - 2.0f, 1.0f - texel.two_thirds, texel.two_thirds);
  return select(select(dense, middle, mask_of(in_thirds < 2.0f)), thin, mask_of(in_thirds < 1.0f));
}

// Whether any of the rays meets the billboard.
INLINE bool see_billboard(__global const uint* textures, const CloudBillboard* billboard, PixelRays rays,
                         BillboardSeen* seen) {
  const float per_m = 1.0f / billboard->radius_m;
  const lanes along = fma((lanes)billboard->x, rays.x, fma((lanes)billboard->y, rays.y, billboard->z * rays.z));
  // Of the nearest point of the ray, from the middle, in radii.
  const lanes x = fma(along, rays.x, (lanes)-billboard->x) * per_m,
              y = fma(along, rays.y, (lanes)-billboard->y) * per_m;
  const lanes z = fma(along, rays.z, (lanes)-billboard->z) * per_m;
  const lanes square = fma(x, x, fma(y, y, z * z));
  const lanes half_chord = sqrt(most(1.0f - square, (lanes)0.0f));
  // From the eye or the ball's front to the scene or the ball's back.
  const lanes begin = most(-half_chord, along * -per_m);
  const lanes end = least(half_chord, (rays.scene_m - along) * per_m);
  const int_lanes meets = mask_of(end > begin);
  if (!any_lane(meets)) return false;
  const lanes depth = billboard->optical_depth * (density_integral(square, end) - density_integral(square, begin));
  seen->depth = select((lanes)0.0f, most(depth, (lanes)0.0f), meets);
  seen->light = 1.0f;
  if (billboard->pattern > 0.0f) {
    const lanes mean = 1.0f - exp_of(-seen->depth);
    const lanes right = fma(x, (lanes)billboard->right_x, fma(y, (lanes)billboard->right_y, z * billboard->right_z));
    const lanes up = fma(x, (lanes)billboard->up_x, fma(y, (lanes)billboard->up_y, z * billboard->up_z));
    const BillboardTexel texel = billboard_texel(textures, billboard, right, up);
    const lanes opacity = fma((lanes)billboard->pattern, patterned(texel, mean) - mean, mean);
    seen->depth = -log_of(most(1.0f - opacity, (lanes)LEAST_CLEAR));
    seen->light = fma((lanes)billboard->relief_x, fma(texel.turn_x, (lanes)2.0f, (lanes)-1.0f),
                      fma((lanes)billboard->relief_y, fma(texel.turn_y, (lanes)2.0f, (lanes)-1.0f), (lanes)1.0f));
  }
  return true;
}

// Marched pixels are no more opaque than this, so that their depth is finite.
#define MOST_OPACITY 0.999999f

// Pixels that let less through, half a step of 8 bits, are taken as full of what they have shown.
#define LEAST_THROUGH 2e-3f

// Sums over billboards of optical depth, and of that times light.
typedef struct {
  lanes depth, red, green, blue;
} Layer;

// What was marched, as if it were a billboard: light per depth, and how much of it is put in its place, 0 ... 1.
typedef struct {
  lanes red, green, blue, depth, distance_m, layer, done;
} Marched;

// Puts what lies before a layer behind what is seen so far.
INLINE void put_before(Marched* marched, lanes index, Sight* sight) {
  const lanes share = least(most(index - marched->layer, marched->done), (lanes)1.0f);
  const lanes depth = (share - marched->done) * marched->depth;
  if (!any_lane(mask_of(depth > 0.0f))) return;
  const lanes through = sight->through * exp_of(-depth), opacity = sight->through - through;
  sight->red = fma(opacity, marched->red, sight->red);
  sight->green = fma(opacity, marched->green, sight->green);
  sight->blue = fma(opacity, marched->blue, sight->blue);
  sight->distance_m = fma(opacity, marched->distance_m, sight->distance_m);
  sight->through = through;
  marched->done = share;
}

// Mixes what lies in a layer into it.
INLINE void mix_in(Marched* marched, lanes index, Layer* layer) {
  const lanes share = least(most(index + 1.0f - marched->layer, marched->done), (lanes)1.0f);
  const lanes depth = (share - marched->done) * marched->depth;
  layer->depth += depth;
  layer->red = fma(depth, marched->red, layer->red);
  layer->green = fma(depth, marched->green, layer->green);
  layer->blue = fma(depth, marched->blue, layer->blue);
  marched->done = share;
}

// Puts a layer behind what is seen so far, and empties it.
INLINE void close_layer(Layer* layer, int index, float distance_m, Marched* marched, Sight* sight) {
  put_before(marched, (lanes)(float)index, sight);
  mix_in(marched, (lanes)(float)index, layer);
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
                          __global const uint* textures, PixelRays rays, float farthest_m, Marched* marched) {
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
      close_layer(&here, index, layer_m, marched, &sight);
      if (nearer == index + 1) {
        here = next;
        next.depth = next.red = next.green = next.blue = 0.0f;
      } else {
        close_layer(&next, index + 1, behind(layer_m), marched, &sight);
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
  close_layer(&here, index, layer_m, marched, &sight);
  close_layer(&next, index + 1, behind(layer_m), marched, &sight);
  put_before(marched, (lanes)INFINITY, &sight);
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

__kernel void billboard_composite(__global const CloudBillboard* restrict billboards, __global const int* restrict first,
                             __global const int* restrict seen, __global const uint* restrict list,
                             __global const uint* restrict textures,
                             __global const float* restrict scene_depth, int has_marched,
                             __global const float* restrict marched, __global const float* restrict marched_m,
                             CloudImageParams params, __global float* restrict image, __global float* restrict distance_m) {
  int left, bottom, right, top;
  set_own_pixels(params, &left, &bottom, &right, &top);
  if (left >= right || bottom >= top) return;
  const int tile = bottom / CLOUD_TILE_PX * params.tile_columns + left / CLOUD_TILE_PX;
  for (int row = bottom; row < top; row += BLOCK_PX) {
    for (int column = left; column < right; column += BLOCK_PX) {
      // A picture may end within a block: pixels beyond its edge see what the last ones do.
      const int_lanes columns = up_to(column + BLOCK_COLUMN, params.width_px - 1);
      const int_lanes rows = up_to(row + BLOCK_ROW, params.height_px - 1);
      const lanes depth = gathered(scene_depth, rows * params.width_px + columns);
      const PixelRays rays = rays_of(params, convert_lanes(columns), convert_lanes(rows), depth);
      Marched marched_here = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
      if (has_marched) {
        const int_lanes place = rows * params.width_px + columns;
        const lanes opacity = least(gathered(marched + 3, 4 * place), (lanes)MOST_OPACITY);
        const lanes an_opacity = 1.0f / most(opacity, (lanes)1e-20f);
        marched_here.red = an_opacity * gathered(marched, 4 * place);
        marched_here.green = an_opacity * gathered(marched + 1, 4 * place);
        marched_here.blue = an_opacity * gathered(marched + 2, 4 * place);
        marched_here.depth = -log_of(1.0f - opacity);
        marched_here.distance_m = gathered(marched_m, place);
        marched_here.layer =
            log_of(fma(marched_here.distance_m, (lanes)(CLOUD_LAYER_GROWTH / CLOUD_LAYER_M), (lanes)1.0f)) / CLOUD_LAYER_GROWTH;
      }
      const Sight sight = sight_of(billboards, list + first[tile], seen[tile], textures, rays, farthest_of(rays.scene_m),
                                   &marched_here);
      write_block(sight, column, row, params, image, distance_m);
    }
  }
}
