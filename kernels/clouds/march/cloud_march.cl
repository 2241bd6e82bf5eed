// The picture of clouds that are large on the screen: along the ray of each pixel, what each piece of the way scatters toward
// the eye, in the delta-scaled medium (kernels/clouds/light_grid.clh): suns' light that comes straight from them, with the
// phase of the whole way (phase tables), and what was scattered before, of sources. Sky that is only scattered nearly
// forward is seen too: the scaled medium lets more of it through than the true one.
// In:  volumes [volume_count], whose boxes may overlap; cells [slots][1 + suns][CLOUD_MARCH_CELLS]: density and depths of
//      kernels/clouds/march in pairs along x; blocks and sources; grids, looks, lights; phases in pairs along angles;
//      squares of the noise of lumps (host/clouds/light/lump_noise.h); the camera, with places in the axes of the volumes; scene_depth as
//      billboard_composite.cl has it.
// Out: image [height][width] RGBA, kcd/m^2, premultiplied; distance_m [height][width], of their mean. Row 0 is at the bottom.
#include "clouds/march/march_pairs.clh"
#include "clouds/march/march_source.clh"
#include "clouds/march/march_volume.clh"
#include "clouds/march/pixel_rays.clh"
#include "simd/lane_exponents.clh"

// Longest piece in optical depths of the scaled medium, shortest in cells, and longest in cells where all light comes
// through and where hardly any does: little is seen of what lies deep.
#define PIECE_DEPTH 0.4f
#define LEAST_PIECE 0.25f
#define LONGEST_PIECE 1.0f
#define LONGEST_DEEP_PIECE 4.0f
// What was scattered before changes little in this share of an edge of its cells.
#define SOURCE_EDGES 0.6f
// What lies behind this little of the scaled light is not looked at, and taken to be as what lies before.
#define LEAST_KEPT 3e-2f
// Lumps smaller than particles: what they add to the density and take from it, and pixels of a texel of noise between
// which they fade in. No density is below 0, so that its mean would rise by LUMP_MEAN of their strength's cube, within
// 2 % up to a strength of 1.6.
#define LUMP_STRENGTH 1.5f
#define LUMP_MEAN 0.063f
#define FAINT_TEXEL_PX 0.25f
#define CLEAR_TEXEL_PX 0.8f
// Where volumes overlap, rays go through one after the other in parts of this length, in the smaller of their cells.
#define SLICE_CELLS 2.0f
// Directions this near to level see sky and ground, mixed.
#define LEVEL_SINE 0.05f
// Metres further than anything is seen.
#define BEYOND 1e30f

// Where values between the middles of cells are sampled.
typedef struct {
  int_lanes first;
  lanes x, y, z;  // weights of the next ones
  int row, plane;
} Trilinear;

INLINE Trilinear trilinear_at(lanes x, lanes y, lanes z, int size_x, int size_y, int size_z) {
  // Beyond the middles of the outer cells all is as there.
  const lanes at_x = least(most(x - 0.5f, (lanes)0.0f), (lanes)((float)size_x - 1.001f));
  const lanes at_y = least(most(y - 0.5f, (lanes)0.0f), (lanes)((float)size_y - 1.001f));
  const lanes at_z = least(most(z - 0.5f, (lanes)0.0f), (lanes)((float)size_z - 1.001f));
  const int_lanes i = convert_int_lanes(at_x), j = convert_int_lanes(at_y), k = convert_int_lanes(at_z);
  const Trilinear at = {(k * size_y + j) * size_x + i, at_x - convert_lanes(i), at_y - convert_lanes(j),
                        at_z - convert_lanes(k),       size_x,                  size_x * size_y};
  return at;
}

INLINE lanes mixed(lanes a, lanes b, lanes share) { return fma(share, b - a, a); }

// Of values in pairs along x.
INLINE lanes sampled(__global const uint *restrict pairs, Trilinear at) {
  const lanes low = mixed(mixed_pair(gathered_pairs(pairs, at.first), at.x),
                          mixed_pair(gathered_pairs(pairs + at.row, at.first), at.x), at.y);
  pairs += at.plane;
  const lanes high = mixed(mixed_pair(gathered_pairs(pairs, at.first), at.x),
                           mixed_pair(gathered_pairs(pairs + at.row, at.first), at.x), at.y);
  return mixed(low, high, at.z);
}

// One of four values of a word.
INLINE lanes lump_of(uint_lanes square, int corner) { return convert_lanes((square >> (uint)(8 * corner)) & 255u); }

INLINE lanes mixed_square(uint_lanes square, lanes x, lanes y) {
  return mixed(mixed(lump_of(square, 0), lump_of(square, 1), x), mixed(lump_of(square, 2), lump_of(square, 3), x), y);
}

// Of noise that goes on at its sides, at a place in texels.
INLINE lanes lump_at(__global const uint *restrict noise, lanes x, lanes y, lanes z) {
  const lanes low_x = floor(x), low_y = floor(y), low_z = floor(z);
  const int last = CLOUD_LUMP_TEXELS - 1, plane = CLOUD_LUMP_TEXELS * CLOUD_LUMP_TEXELS;
  const int_lanes in_plane = (convert_int_lanes(low_y) & last) * CLOUD_LUMP_TEXELS + (convert_int_lanes(low_x) & last);
  const int_lanes k = (convert_int_lanes(low_z) & last) * plane, next_k = (k + plane) & (last * plane);
  const lanes in_x = x - low_x, in_y = y - low_y;
  const lanes low = mixed_square(gathered_pairs(noise, k + in_plane), in_x, in_y);
  const lanes high = mixed_square(gathered_pairs(noise, next_k + in_plane), in_x, in_y);
  return fma(mixed(low, high, z - low_z), (lanes)CLOUD_LUMP_STEP, (lanes)CLOUD_LUMP_LEAST);
}

// 1/sr, at a place of a table's rows and after a way of this depth (clouds/phase.clh).
INLINE lanes phase_of(__global const uint *restrict table, lanes angle_place, lanes depth) {
  const lanes u = depth / (depth + CLOUD_PHASE_DEPTH_SCALE) * (float)CLOUD_PHASE_DEPTHS;
  const int_lanes row = up_to(convert_int_lanes(u), CLOUD_PHASE_DEPTHS - 2);
  const int_lanes column = up_to(convert_int_lanes(angle_place), CLOUD_PHASE_ANGLES - 2);
  const lanes down = least(u - convert_lanes(row), (lanes)1.0f), right = angle_place - convert_lanes(column);
  const int_lanes first = row * CLOUD_PHASE_ANGLES + column;
  return mixed(mixed_pair(gathered_pairs(table, first), right),
               mixed_pair(gathered_pairs(table + CLOUD_PHASE_ANGLES, first), right), down);
}

// Along an axis, the distances at which rays enter and leave, given how far the walls are, in metres.
INLINE void clip(lanes direction, float low_m, float high_m, lanes *enter, lanes *leave) {
  const lanes safe = select(direction, (lanes)1e-12f, mask_of(fabs(direction) < 1e-12f));
  const lanes a = low_m / safe, b = high_m / safe;
  *enter = most(*enter, least(a, b));
  *leave = least(*leave, most(a, b));
}

// How far along an axis a block ends, from the place in blocks of a ray that crosses one in a_speed, in metres.
INLINE lanes to_edge(lanes place, lanes a_speed) {
  const lanes inside = place - floor(place);
  return select(-inside, 1.0f - inside, mask_of(a_speed > 0.0f)) * a_speed;
}

// Metres in which a ray crosses a block along an axis, with the sign of its direction.
INLINE lanes crossing(lanes direction, float block_m) {
  return block_m / select(direction, (lanes)1e-9f, mask_of(fabs(direction) < 1e-9f));
}

// What has been seen of a cloud: light of the scaled medium of each colour, what that lets through, and depth of the true
// one.
typedef struct {
  lanes light[3], distance_m;
  lanes kept[CHANNELS];
  lanes depth;
} March;

INLINE lanes most_kept(const March *march) {
#if CHANNELS == 1
  return march->kept[0];
#else
  return most(march->kept[0], most(march->kept[1], march->kept[2]));
#endif
}

typedef struct {
  __global const uint *cells, *phases, *noise;
  __global const int *blocks;
  __global const uint *sources;
  int source_pitch;  // of its values
} MarchedArrays;

// The box of a volume as rays see it.
typedef struct {
  lanes ray_x, ray_y, ray_z;  // directions along its axes
  float low_x, low_y, low_z;  // from the eye, in metres
} SeenBox;

INLINE SeenBox seen_box(const CloudMarchVolume volume, CloudImageParams params, PixelRays rays) {
  const float3 eye_m = in_volume(volume, (float3)(params.eye_x_m, params.eye_y_m, params.eye_z_m));
  const SeenBox box = {fma(rays.x, (lanes)volume.right_x, fma(rays.y, (lanes)volume.right_y, rays.z * volume.right_z)),
                       fma(rays.x, (lanes)volume.up_x, fma(rays.y, (lanes)volume.up_y, rays.z * volume.up_z)),
                       fma(rays.x, (lanes)volume.sun_x, fma(rays.y, (lanes)volume.sun_y, rays.z * volume.sun_z)),
                       volume.low_x - eye_m.x,
                       volume.low_y - eye_m.y,
                       volume.low_z - eye_m.z};
  return box;
}

// Distances at which rays enter and leave a volume; both BEYOND where they miss it.
INLINE void find_ends(const CloudMarchVolume volume, CloudImageParams params, PixelRays rays, lanes *enter, lanes *leave) {
  const SeenBox box = seen_box(volume, params, rays);
  *enter = 0.0f, *leave = rays.scene_m;
  clip(box.ray_x, box.low_x, box.low_x + (float)volume.size_x * volume.cell_m, enter, leave);
  clip(box.ray_y, box.low_y, box.low_y + (float)volume.size_y * volume.cell_m, enter, leave);
  clip(box.ray_z, box.low_z, box.low_z + (float)volume.size_z * volume.cell_m, enter, leave);
  const int_lanes hits = mask_of(*enter < *leave);
  *enter = select((lanes)BEYOND, *enter, hits);
  *leave = select((lanes)BEYOND, *leave, hits);
}

// Goes through a part of a volume behind this depth, where rays go on. `arrays` are those of its slot.
INLINE void march_through(const CloudMarchVolume volume, const CloudGrid grid, const CloudScattering look,
                          __global const CloudLightParams *restrict light, MarchedArrays arrays, CloudImageParams params,
                          PixelRays rays, int_lanes goes_on, lanes enter, lanes leave, lanes depth_before, March *march) {
  const SeenBox box = seen_box(volume, params, rays);
  lanes angle_places[CLOUD_SUNS];
  for (int sun = 0; sun < light->sun_count; ++sun) {
    const CloudLightSource from = light->suns[sun];
    // As phase_angle_place(): light goes along -from, and on to the eye along -ray.
    const lanes cosine = fma(rays.x, (lanes)from.x, fma(rays.y, (lanes)from.y, rays.z * from.z));
    angle_places[sun] = sqrt(acos(clamp(cosine, (lanes)-1.0f, (lanes)1.0f)) / 3.14159265f) * (float)(CLOUD_PHASE_ANGLES - 1);
  }
  const float a_cell = 1.0f / volume.cell_m;
  const lanes speed_x = a_cell * box.ray_x, speed_y = a_cell * box.ray_y, speed_z = a_cell * box.ray_z;
  const float block_m = (float)CLOUD_MARCH_BLOCK * volume.cell_m, a_block = 1.0f / (float)CLOUD_MARCH_BLOCK;
  const lanes cross_x = crossing(box.ray_x, block_m), cross_y = crossing(box.ray_y, block_m),
              cross_z = crossing(box.ray_z, block_m);
  const int block_columns = volume.size_x / CLOUD_MARCH_BLOCK, block_rows = volume.size_y / CLOUD_MARCH_BLOCK;
  const int block_planes = volume.size_z / CLOUD_MARCH_BLOCK;
  const float3 own_cell = grid_cell(grid);  // of the light's grid
  const float source_m = SOURCE_EDGES * fmin(own_cell.x, fmin(own_cell.y, own_cell.z));
  // A piece whose lumps are all empty is gone through before any source is known, and shows none of it.
  lanes shared[3] = {0.0f, 0.0f, 0.0f}, albedo[CHANNELS], scaled[CHANNELS];
  lanes sourced_to = -1.0f;  // how far along the rays `shared` holds
  for (int channel = 0; channel < CHANNELS; ++channel) {
    albedo[channel] = 1.0f - look.absorbed_share;
    scaled[channel] = 1.0f - look.forward_share * albedo[channel];
  }
  // Lumps stay with the cloud.
  const float a_lump = 1.0f / volume.lump_m, lump_px = 0.5f * (float)params.height_px / params.half_height * volume.lump_m;
  const float lump_x = a_lump * (params.eye_x_m - volume.anchor_x), lump_y = a_lump * (params.eye_y_m - volume.anchor_y),
              lump_z = a_lump * (params.eye_z_m - volume.anchor_z);
  lanes way = enter, rough = PIECE_DEPTH * a_cell;
  // A ray crosses no more blocks and no more pieces of cells than these.
  const int most_pieces = 8 * (volume.size_x + volume.size_y + volume.size_z);
  for (int number = 0; number < most_pieces; ++number) {
    const lanes x = fma(way, speed_x, (lanes)(-a_cell * box.low_x)), y = fma(way, speed_y, (lanes)(-a_cell * box.low_y)),
                z = fma(way, speed_z, (lanes)(-a_cell * box.low_z));
    const lanes block_x = a_block * x, block_y = a_block * y, block_z = a_block * z;
    const int_lanes block = (up_to(convert_int_lanes(block_z), block_planes - 1) * block_rows +
                             up_to(convert_int_lanes(block_y), block_rows - 1)) * block_columns +
                            up_to(convert_int_lanes(block_x), block_columns - 1);
    const int_lanes holds = -gathered_ints(arrays.blocks, block) & goes_on;
    const lanes past = least(least(to_edge(block_x, cross_x), to_edge(block_y, cross_y)), to_edge(block_z, cross_z)) +
                       0.01f * volume.cell_m;
    const lanes longest =
        volume.cell_m * mixed((lanes)LONGEST_DEEP_PIECE, (lanes)LONGEST_PIECE, most_kept(march));
    lanes piece = least(most(PIECE_DEPTH / rough, (lanes)(LEAST_PIECE * volume.cell_m)), longest);
    piece = least(select(past, piece, holds), leave - way);
    if (any_lane(holds)) {
      const lanes half_piece = 0.5f * piece;
      const Trilinear at = trilinear_at(fma(half_piece, speed_x, x), fma(half_piece, speed_y, y), fma(half_piece, speed_z, z), volume.size_x,
                                        volume.size_y, volume.size_z);
      lanes extinction = select((lanes)0.0f, sampled(arrays.cells, at), holds);
      if (any_lane(mask_of(extinction > 0.0f))) {
        const lanes middle = way + half_piece;
        const lanes texel_px = lump_px / most(middle, (lanes)1.0f);
        if (volume.lumps > 0.0f && any_lane(mask_of(texel_px > FAINT_TEXEL_PX))) {
          const lanes strength =
              LUMP_STRENGTH * volume.lumps *
              clamp((texel_px - FAINT_TEXEL_PX) / (CLEAR_TEXEL_PX - FAINT_TEXEL_PX), (lanes)0.0f, (lanes)1.0f);
          const lanes lump = lump_at(arrays.noise, fma(middle, rays.x * a_lump, (lanes)lump_x),
                                     fma(middle, rays.y * a_lump, (lanes)lump_y), fma(middle, rays.z * a_lump, (lanes)lump_z));
          extinction *= most(fma(strength, lump, (lanes)1.0f), (lanes)0.0f) /
                        fma(strength * strength * strength, (lanes)LUMP_MEAN, (lanes)1.0f);
        }
        if (any_lane(mask_of(extinction > 0.0f) & mask_of(middle > sourced_to))) {
          const lanes source_at = way + 0.5f * source_m;
          const Trilinear in_grid = trilinear_at(
              fma(source_at, rays.x, (lanes)(params.eye_x_m - grid.low_x)) / own_cell.x,
              fma(source_at, rays.y, (lanes)(params.eye_y_m - grid.low_y)) / own_cell.y,
              fma(source_at, rays.z, (lanes)(params.eye_z_m - grid.low_z)) / own_cell.z, grid.size_x, grid.size_y,
              grid.size_z);
          for (int colour = 0; colour < 3; ++colour)
            shared[colour] = sampled(arrays.sources + colour * arrays.source_pitch, in_grid);
#if CHANNELS > 1
          for (int channel = 0; channel < CHANNELS; ++channel) {
            albedo[channel] = 1.0f - sampled(arrays.sources + (3 + channel) * arrays.source_pitch, in_grid);
            scaled[channel] = 1.0f - look.forward_share * albedo[channel];
          }
#endif
          sourced_to = way + source_m;
        }
        lanes shown[3] = {shared[0], shared[1], shared[2]}, lit[CHANNELS];
        const lanes eye_depth = fma(extinction, half_piece, depth_before + march->depth);
        for (int sun = 0; sun < light->sun_count; ++sun) {
          const lanes sun_depth = sampled(arrays.cells + (1 + sun) * CLOUD_MARCH_CELLS, at);
          for (int channel = 0; channel < CHANNELS; ++channel)
            lit[channel] = exp_of(-sun_depth * scaled[channel]) *
                           phase_of(arrays.phases, angle_places[sun], albedo[channel] * (eye_depth + sun_depth));
          shown[0] = fma(lit[0], (lanes)light->suns[sun].red, shown[0]);
          shown[1] = fma(lit[CHANNELS / 2], (lanes)light->suns[sun].green, shown[1]);
          shown[2] = fma(lit[CHANNELS - 1], (lanes)light->suns[sun].blue, shown[2]);
        }
        const lanes depth = extinction * piece;
        lanes given[CHANNELS];
        for (int channel = 0; channel < CHANNELS; ++channel) {
          const lanes through = exp_of(-depth * scaled[channel]);
          given[channel] = march->kept[channel] * (1.0f - through) * albedo[channel] / scaled[channel];
          march->kept[channel] *= through;
        }
        for (int colour = 0; colour < 3; ++colour)
          march->light[colour] = fma(given[CHANNELS == 1 ? 0 : colour], shown[colour], march->light[colour]);
        march->distance_m =
            fma(exp_of(-march->depth) - exp_of(-march->depth - depth), middle, march->distance_m);
        march->depth += depth;
        rough = select(rough, most(extinction * scaled[0], (lanes)1e-6f), holds);
      } else {
        rough = select(rough, (lanes)1e-6f, holds);
      }
    }
    way += select((lanes)0.0f, piece, goes_on);
    goes_on &= mask_of(way < leave) & mask_of(most_kept(march) > LEAST_KEPT);
    if (!any_lane(goes_on)) return;
  }
}

__kernel void cloud_march(__global const CloudMarchVolume *restrict volumes, int volume_count,
                          __global const uint *restrict cells, __global const int *restrict blocks, __global const uint *restrict sources,
                          __global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
                          __global const CloudLightParams *restrict lights, __global const uint *restrict phases,
                          __global const uint *restrict noise, __global const float *restrict scene_depth, CloudImageParams params,
                          __global float *restrict image, __global float *restrict distance_m) {
  int left, bottom, right, top;
  set_own_pixels(params, &left, &bottom, &right, &top);
  for (int row = bottom; row < top; row += BLOCK_PX) {
    for (int column = left; column < right; column += BLOCK_PX) {
      const int_lanes columns = up_to(column + BLOCK_COLUMN, params.width_px - 1);
      const int_lanes rows = up_to(row + BLOCK_ROW, params.height_px - 1);
      const lanes scene = gathered(scene_depth, rows * params.width_px + columns);
      const PixelRays rays = rays_of(params, convert_lanes(columns), convert_lanes(rows), scene);
      const lanes up = clamp(fma(rays.y, (lanes)(0.5f / LEVEL_SINE), (lanes)0.5f), (lanes)0.0f, (lanes)1.0f);
      lanes enter[CLOUD_MARCH_VOLUMES], leave[CLOUD_MARCH_VOLUMES], way = BEYOND;
      int most_slices = 2 * volume_count;
      for (int i = 0; i < volume_count; ++i) {
        find_ends(volumes[i], params, rays, &enter[i], &leave[i]);
        way = least(way, enter[i]);
        // A ray crosses no more slices of cells than these.
        most_slices += volumes[i].size_x + volumes[i].size_y + volumes[i].size_z;
      }
      // Of the scaled medium and of the true one.
      lanes kept[3] = {1.0f, 1.0f, 1.0f}, through = 1.0f;
      lanes light[3] = {0.0f, 0.0f, 0.0f}, distance = 0.0f;
      lanes sky[3] = {0.0f, 0.0f, 0.0f};  // behind what is seen of clouds
      int_lanes goes_on = mask_of(way < BEYOND);
      for (int slice = 0; slice < most_slices && any_lane(goes_on); ++slice) {
        // To the next end of a volume, or a slice where there are several.
        lanes end = BEYOND, slice_m = BEYOND;
        int_lanes inside = 0;
        for (int i = 0; i < volume_count; ++i) {
          const int_lanes is_before = mask_of(enter[i] > way), is_in = ~is_before & mask_of(leave[i] > way);
          end = least(end, select(select((lanes)BEYOND, leave[i], is_in), enter[i], is_before));
          slice_m = select(slice_m, least(slice_m, (lanes)(SLICE_CELLS * volumes[i].cell_m)), is_in);
          inside -= is_in;
        }
        end = select(end, least(end, way + slice_m), mask_of(inside > 1));
        for (int i = 0; i < volume_count; ++i) {
          const int_lanes is_in = goes_on & mask_of(enter[i] <= way) & mask_of(leave[i] > way);
          if (!any_lane(is_in)) continue;
          const CloudMarchVolume volume = volumes[i];
          const size_t slot = volume.slot;
          const CloudScattering look = looks[volume.cloud];
          __global const CloudLightParams *lit_by = lights + volume.cloud;
          const MarchedArrays arrays = {
              cells + slot * (1 + lit_by->sun_count) * CLOUD_MARCH_CELLS,
              phases + (size_t)look.phase_table * CLOUD_PHASE_DEPTHS * CLOUD_PHASE_ANGLES,
              noise, blocks + slot * CLOUD_MARCH_BLOCKS, sources + slot * grids[volume.cloud].room * SOURCE_VALUES,
              grids[volume.cloud].room};
          March march;
          march.light[0] = march.light[1] = march.light[2] = march.distance_m = march.depth = 0.0f;
          for (int channel = 0; channel < CHANNELS; ++channel) march.kept[channel] = 1.0f;
          march_through(volume, grids[volume.cloud], look, lit_by, arrays, params, rays, is_in, way, end,
                        -log_of(most(through, (lanes)1e-30f)), &march);
          if (!any_lane(mask_of(march.depth > 0.0f))) continue;
          const float skies[3] = {lit_by->sky_red, lit_by->sky_green, lit_by->sky_blue};
          const float ground[3] = {lit_by->ground_red, lit_by->ground_green, lit_by->ground_blue};
          // Billboards show the rest of the cloud, and behind a part of it is not the sky, but the rest.
          const lanes own_through = exp_of(-march.depth), seen_through = exp_of(-volume.share * march.depth);
          const lanes share = (1.0f - seen_through) / most(1.0f - own_through, (lanes)1e-6f);
          distance = fma(through * share, march.distance_m, distance);
          const int_lanes is_full = mask_of(most_kept(&march) <= LEAST_KEPT);
          for (int colour = 0; colour < 3; ++colour) {
            const lanes own_kept = march.kept[CHANNELS == 1 ? 0 : colour];
            // What is as good as full is taken as full of what it has shown.
            const lanes own_light = march.light[colour] * select((lanes)1.0f, 1.0f / (1.0f - own_kept), is_full);
            const lanes scattered = select(own_kept - own_through, (lanes)0.0f, is_full);
            const lanes beyond = mixed((lanes)ground[colour], (lanes)skies[colour], up);
            light[colour] = fma(kept[colour] * share, fma((1.0f - volume.share) * scattered, beyond, own_light), light[colour]);
            kept[colour] *= fma(volume.share, scattered, seen_through);
            sky[colour] = fma(through * (1.0f - seen_through), beyond, sky[colour]);
          }
          through *= seen_through;
        }
        way = end;
        goes_on &= mask_of(way < BEYOND) & mask_of(most(kept[0], most(kept[1], kept[2])) > LEAST_KEPT);
      }
      for (int colour = 0; colour < 3; ++colour)
        light[colour] = fma((kept[colour] - through) / most(1.0f - through, (lanes)1e-6f), sky[colour], light[colour]);
      const Sight sight = {light[0], light[1], light[2], distance, through};
      write_block(sight, column, row, params, image, distance_m);
    }
  }
}
