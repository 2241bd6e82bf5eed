// Where scattered light arises in the clouds' grids, for light_diffuse.cl: from the suns' beams, and through the box's
// sides from sky and ground.
// In:  grids, looks, lights, medium, absorption, beams; the first cloud. Global size: items that share the cells, clouds
//      from it on.
// Out: of the finest level of each of these clouds, faces [clouds][channels][4][LEVEL_CELLS] and sources [clouds][3][LEVEL_CELLS].
#include "clouds/diffusion.clh"
#include "simd/lane_exponents.clh"

// A channel of a cloud's medium, from its first cell on.
typedef struct {
  __global const float *extinction, *absorption;
  float empty;
} Medium;

static inline lanes transport_at(const Medium medium, const CloudScattering look, int at) {
  return transport_extinction(look, medium.empty, load_lanes(medium.extinction + at), load_lanes(medium.absorption + at));
}

// Light of a sun that a cell scatters on, over its transport extinction: what leans along the beam.
static inline lanes leaning(const Medium medium, const CloudScattering look, __global const float *beam, int at) {
  const lanes extinction = load_lanes(medium.extinction + at), absorption = load_lanes(medium.absorption + at);
  return (extinction - absorption) * load_lanes(beam + at) /
         transport_extinction(look, medium.empty, extinction, absorption);
}

// What comes of a sun: its light where it is scattered, and how its lean grows across the cell. Reads beyond a row are of
// numbers that do not count.
static inline lanes lit_by(const CloudGrid grid, const CloudScattering look, const CloudLightSource from,
                           const Medium medium, __global const float *beam, const Piece piece) {
  const int at = piece.at - FIRST_LEVEL(grid), row = grid.size_x, plane = grid.size_x * grid.size_y;
  const float speed =
      fmax(fmax(fabs(from.x) / grid.cell_x, fabs(from.y) / grid.cell_y), fabs(from.z) / grid.cell_z);
  // The mean over a cell of e^-x around its middle is sinh(x) / x there.
  const lanes extinction = load_lanes(medium.extinction + at), absorption = load_lanes(medium.absorption + at);
  const lanes half_depth =
      least(most(0.5f / speed * scaled_extinction(look, extinction, absorption), (lanes)1e-3f), (lanes)40.0f);
  const lanes kept = exp_of(-half_depth);
  const lanes mean = (1.0f / kept - kept) / (2.0f * half_depth);

  const float last_x = (float)(grid.size_x - 1);
  const lanes x = (float)piece.x + LANE_INDEX;
  const lanes right = leaning(medium, look, beam, at + 1), left = leaning(medium, look, beam, at - 1);
  lanes gain = from.x / grid.cell_x * (select((lanes)0.0f, right, mask_of(x < last_x)) -
                                       select((lanes)0.0f, left, mask_of(x > 0.0f)));
  if (piece.y + 1 < grid.size_y) gain += from.y / grid.cell_y * leaning(medium, look, beam, at + row);
  if (piece.y > 0) gain -= from.y / grid.cell_y * leaning(medium, look, beam, at - row);
  if (piece.z + 1 < grid.size_z) gain += from.z / grid.cell_z * leaning(medium, look, beam, at + plane);
  if (piece.z > 0) gain -= from.z / grid.cell_z * leaning(medium, look, beam, at - plane);
  return (1.0f - look.forward_share) *
         ((extinction - absorption) * load_lanes(beam + at) * mean + 0.5f * look.scaled_mean_cosine * gain);
}

// What a side of the box lets out of a cell beside it: 1 / (c (2 + c / (2 D))), D = 1 / (3 s).
static inline lanes side_conductances(float cell, lanes transport) {
  return 1.0f / (cell * (2.0f + 1.5f * cell * transport));
}

static inline lanes conductances(float cell, lanes here, lanes next) {
  return 2.0f / (3.0f * cell * cell * (here + next));
}

__kernel void light_source(__global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
                           __global const CloudLightParams *restrict lights, __global const float *restrict medium,
                           __global const float *restrict absorption, __global const float *restrict beams,
                           int first_cloud, int channels, __global float *restrict faces,
                           __global float *restrict sources) {
  const size_t number = get_global_id(1), cloud = first_cloud + number;
  const CloudGrid grid = grids[cloud];
  const CloudScattering look = looks[cloud];
  const CloudLightParams light = lights[cloud];
  beams += CLOUD_BEAM_MARGIN + cloud * light.sun_count * channels * grid.room;
  faces += number * channels * 4 * LEVEL_CELLS(grid);
  sources += number * 3 * LEVEL_CELLS(grid);
  const Level level = finest_level(grid);
  const int last_y = grid.size_y - 1, last_z = grid.size_z - 1, row = grid.size_x, plane = grid.size_x * grid.size_y;
  const float last_x = (float)(grid.size_x - 1);
  for (int i = (int)get_global_id(0); i < channels * level_pieces(level); i += (int)get_global_size(0)) {
    const int channel = i % channels;
    const Piece piece = piece_of(level, i / channels);
    const int at = piece.at - FIRST_LEVEL(grid);
    const Medium of_channel = {medium + cloud * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid),
                               absorption + (cloud * channels + channel) * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid),
                               empty_extinction(grid)};
    __global float *ways = faces + channel * 4 * LEVEL_CELLS(grid) + piece.at;
    const lanes x = (float)piece.x + LANE_INDEX;
    const lanes here = transport_at(of_channel, look, at);
    const lanes right = conductances(grid.cell_x, here, transport_at(of_channel, look, at + 1));
    store_lanes(select((lanes)0.0f, right, mask_of(x < last_x)), ways + FACES_X);
    lanes up = (lanes)0.0f, back = (lanes)0.0f;
    if (piece.y < last_y) up = conductances(grid.cell_y, here, transport_at(of_channel, look, at + row));
    if (piece.z < last_z) back = conductances(grid.cell_z, here, transport_at(of_channel, look, at + plane));
    store_lanes(up, ways + FACES_Y(level));
    store_lanes(back, ways + FACES_Z(level));

    // Sides see half of each hemisphere; top and bottom one.
    lanes beside = select((lanes)0.0f, side_conductances(grid.cell_x, here), mask_of(x < 0.5f) | mask_of(x > last_x - 0.5f));
    if (piece.z == 0 || piece.z == last_z) beside += side_conductances(grid.cell_z, here);
    lanes below = (lanes)0.0f, above = (lanes)0.0f;
    if (piece.y == 0) below = side_conductances(grid.cell_y, here);
    if (piece.y == last_y) above = side_conductances(grid.cell_y, here);
    store_lanes(beside + below + above + load_lanes(of_channel.absorption + at), ways + FACES_OUT(level));
    const lanes of_sky = 4.0f * PI * (0.5f * beside + above), of_ground = 4.0f * PI * (0.5f * beside + below);
    lanes red = light.above_red * of_sky + light.below_red * of_ground;
    lanes green = light.above_green * of_sky + light.below_green * of_ground;
    lanes blue = light.above_blue * of_sky + light.below_blue * of_ground;
    for (int sun = 0; sun < light.sun_count; ++sun) {
      const CloudLightSource from = light.suns[sun];
      const lanes amount = lit_by(grid, look, from, of_channel, beams + (sun * channels + channel) * grid.room, piece);
      red += from.red * amount;
      green += from.green * amount;
      blue += from.blue * amount;
    }
    // One channel is that of all colours.
    if (channels == 1 || channel == 0) store_lanes(red, sources + piece.at);
    if (channels == 1 || channel == 1) store_lanes(green, sources + LEVEL_CELLS(grid) + piece.at);
    if (channels == 1 || channel == 2) store_lanes(blue, sources + 2 * LEVEL_CELLS(grid) + piece.at);
  }
}
