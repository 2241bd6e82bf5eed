// Particles of clouds as a camera sees them: nearest first, with the boxes of pixels that they may cover.
// In:  particles [count], sprites [count], order [count] indices of both, the farthest first; of each cloud the share that
//      billboards show.
// Out: billboards [count], the nearest first, of those that are seen; boxes [4][box_pitch] px: the left, right, lower
//      and upper edges, an empty one where nothing of the particle is seen. Row 0 is at the bottom.
#include "shared/cloud_image_params.h"
#include "shared/clouds.h"

#define GOLDEN_ANGLE 2.3999632f

// Radii, in pixels, between which a texture fades in: below, nothing of it would show.
#define FAINT_PX 1.5f
#define FULL_PX 4.0f
// Distances of the eye from the middle, in radii, between which it fades in: from inside there is none.
#define INSIDE 0.5f
#define OUTSIDE 1.5f
// The part of an octave in which a level gives way to the next.
#define FADING 0.3f

// Where the edges of a ball lie along an axis of the picture, in tangents of their angles to the line of
// sight: `across` and `ahead` from the eye, ahead > radius (Mara & McGuire 2013, eq. 3).
static inline float2 ball_edges(float across, float ahead, float radius) {
  const float square = fma(across, across, fma(ahead, ahead, -radius * radius));
  const float root = radius * sqrt(fmax(square, 0.0f));
  const float scale = 1.0f / fma(ahead, ahead, -radius * radius);
  return (float2)((across * ahead - root) * scale, (across * ahead + root) * scale);
}

__kernel void billboard_project(__global const CloudParticle* restrict particles,
                           __global const CloudSprite* restrict sprites, __global const uint* restrict order,
                           int has_shares, __global const float* restrict shares, CloudImageParams params,
                           __global CloudBillboard* restrict billboards,
                           __global float* restrict boxes) {
  const int place = (int)get_global_id(0);
  __global float *left = boxes + place, *right = left + params.box_pitch;
  __global float *bottom = right + params.box_pitch, *top = bottom + params.box_pitch;
  *left = 1.0f;
  *right = 0.0f;
  *bottom = 1.0f;
  *top = 0.0f;
  if (place >= params.count) return;
  const uint index = order[params.count - 1 - place];
  const CloudParticle particle = particles[index];
  CloudSprite sprite = sprites[index];
  if (has_shares) sprite.optical_depth *= shares[particle.cloud];
  const float3 forward = (float3)(params.forward_x, params.forward_y, params.forward_z);
  const float3 rightward = (float3)(params.right_x, params.right_y, params.right_z);
  const float3 upward = (float3)(params.up_x, params.up_y, params.up_z);
  const float3 way =
      (float3)(particle.x - params.eye_x_m, particle.y - params.eye_y_m, particle.z - params.eye_z_m);
  const float distance_m = length(way);
  const float radius = particle.radius;
  const float across = dot(way, rightward), above = dot(way, upward), ahead = dot(way, forward);

  // Nothing is seen behind the eye, nor beside the picture. Numbers that are none fail these too.
  const float beside =
      (fabs(across) - params.half_width * ahead) / sqrt(1.0f + params.half_width * params.half_width);
  const float over =
      (fabs(above) - params.half_height * ahead) / sqrt(1.0f + params.half_height * params.half_height);
  const bool is_seen = ahead > -radius && beside < radius && over < radius && sprite.optical_depth > 0.0f &&
                       sprite.optical_depth < INFINITY && isfinite(sprite.red + sprite.green + sprite.blue);
  if (!is_seen) return;  // nobody reads the billboard of an empty box
  float2 columns = (float2)(-1.0f, 1.0f), rows = (float2)(-1.0f, 1.0f);
  if (ahead > 1.01f * radius) {
    columns = ball_edges(across, ahead, radius) / params.half_width;
    rows = ball_edges(above, ahead, radius) / params.half_height;
  }
  const float half_columns = 0.5f * (float)params.width_px, half_rows = 0.5f * (float)params.height_px;
  *left = fma(columns.x, half_columns, half_columns);
  *right = fma(columns.y, half_columns, half_columns);
  *bottom = fma(rows.x, half_rows, half_rows);
  *top = fma(rows.y, half_rows, half_rows);

  CloudBillboard billboard;
  billboard.x = way.x;
  billboard.y = way.y;
  billboard.z = way.z;
  billboard.radius_m = radius;
  billboard.optical_depth = sprite.optical_depth / CLOUD_CHORD;
  billboard.red = sprite.red;
  billboard.green = sprite.green;
  billboard.blue = sprite.blue;
  billboard.distance_m = distance_m;

  // The texture turns with the line of sight as little as it can, from a level direction that each particle
  // has of its own: it whirls only about the opposite direction, where a few of many do.
  const float own = GOLDEN_ANGLE * (float)(particle.id & 0xffffu);
  const float3 from = (float3)(cos(own), 0.0f, sin(own));
  const float3 toward_eye = -way / fmax(distance_m, 1e-6f);
  const float3 middle = (from + toward_eye) / fmax(1.0f + dot(from, toward_eye), 1e-3f);
  const float3 side = (float3)(-from.z, 0.0f, from.x), high = (float3)(0.0f, 1.0f, 0.0f);
  const float3 texture_side = side - dot(side, toward_eye) * middle;
  const float3 texture_high = high - dot(high, toward_eye) * middle;
  const float c = cos(particle.turn), s = sin(particle.turn);
  const float3 texture_right = c * texture_side + s * texture_high,
               texture_up = c * texture_high - s * texture_side;
  billboard.right_x = texture_right.x;
  billboard.right_y = texture_right.y;
  billboard.right_z = texture_right.z;
  billboard.up_x = texture_up.x;
  billboard.up_y = texture_up.y;
  billboard.up_z = texture_up.z;
  const float3 sun = (float3)(params.sun_x, params.sun_y, params.sun_z);

  // Layers grow with distance: their depth is CLOUD_LAYER_M + CLOUD_LAYER_GROWTH distance.
  billboard.layer = log(fma(distance_m, CLOUD_LAYER_GROWTH / CLOUD_LAYER_M, 1.0f)) / CLOUD_LAYER_GROWTH;
  billboard.layer_m = CLOUD_LAYER_M / CLOUD_LAYER_GROWTH * (exp(CLOUD_LAYER_GROWTH * floor(billboard.layer)) - 1.0f);

  const float radius_px =
      0.5f * (float)params.height_px / params.half_height * radius / fmax(distance_m, radius);
  billboard.pattern = smoothstep(FAINT_PX, FULL_PX, radius_px) * smoothstep(INSIDE, OUTSIDE, distance_m / radius);
  billboard.relief_x = params.relief * billboard.pattern * dot(sun, texture_right);
  billboard.relief_y = params.relief * billboard.pattern * dot(sun, texture_up);

  // The level whose texels are as large as pixels, or the next finer one.
  const float level =
      clamp(log2(0.5f * (float)CLOUD_TEXTURE_SIZE / radius_px), 0.0f, (float)(CLOUD_TEXTURE_LEVELS - 1));
  const int finer = min((int)level, CLOUD_TEXTURE_LEVELS - 2);
  billboard.coarser = smoothstep(1.0f - FADING, 1.0f, level - (float)finer);
  billboard.level_px = CLOUD_TEXTURE_SIZE >> finer;
  // Levels above it have 4/3 (size^2 - level_px^2) texels.
  billboard.texels = min(particle.texture, 2u * CLOUD_TEXTURES - 1u) * CLOUD_TEXTURE_TEXELS +
                (uint)(4 * (CLOUD_TEXTURE_SIZE * CLOUD_TEXTURE_SIZE - billboard.level_px * billboard.level_px) / 3);
  billboards[place] = billboard;
}
