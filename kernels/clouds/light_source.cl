// Where scattered light arises in the clouds' grids, for light_diffuse.cl: from the suns' beams, and through the box's
// sides from sky and ground.
// In:  grids, looks, light, medium, beams. Global size: items that share the cells, clouds.
// Out: of the finest level of each cloud, faces [clouds][4][LEVEL_CELLS] and sources [clouds][3][LEVEL_CELLS].
#include "clouds/diffusion.clh"
#include "clouds/lane_exponents.clh"

// Light of a sun that a cell scatters on, over its transport extinction: what leans along the beam.
static inline lanes leaning(__global const float *medium, __global const float *beam, int at, float transport,
                            float empty) {
  const lanes extinction = load_lanes(medium + at);
  return extinction * load_lanes(beam + at) / transport_extinction(extinction, transport, empty);
}

// What comes of a sun: its light where it is scattered, and how its lean grows across the cell. Reads beyond a row are of
// numbers that do not count.
static inline lanes lit_by(const CloudGrid grid, const CloudScattering look, const CloudSunLight from,
                           __global const float *medium, __global const float *beam, const Piece piece) {
  const float scattered = look.albedo_green * (1.0f - look.forward_share);
  const float transport = transport_share(look), empty = empty_extinction(grid);
  const int at = piece.at - FIRST_LEVEL, row = grid.size_x, plane = grid.size_x * grid.size_y;
  const float speed =
      fmax(fmax(fabs(from.x) / grid.cell_x, fabs(from.y) / grid.cell_y), fabs(from.z) / grid.cell_z);
  // The mean over a cell of e^-x around its middle is sinh(x) / x there.
  const lanes extinction = load_lanes(medium + at);
  const lanes half_depth =
      least(most(0.5f / speed * (1.0f - forward_albedo(look)) * extinction, (lanes)1e-3f), (lanes)40.0f);
  const lanes kept = exp_of(-half_depth);
  const lanes mean = (1.0f / kept - kept) / (2.0f * half_depth);

  const float last_x = (float)(grid.size_x - 1);
  const lanes x = (float)piece.x + LANE_INDEX;
  const lanes right = leaning(medium, beam, at + 1, transport, empty);
  const lanes left = leaning(medium, beam, at - 1, transport, empty);
  lanes gain = from.x / grid.cell_x * (select((lanes)0.0f, right, mask_of(x < last_x)) -
                                       select((lanes)0.0f, left, mask_of(x > 0.0f)));
  if (piece.y + 1 < grid.size_y) gain += from.y / grid.cell_y * leaning(medium, beam, at + row, transport, empty);
  if (piece.y > 0) gain -= from.y / grid.cell_y * leaning(medium, beam, at - row, transport, empty);
  if (piece.z + 1 < grid.size_z) gain += from.z / grid.cell_z * leaning(medium, beam, at + plane, transport, empty);
  if (piece.z > 0) gain -= from.z / grid.cell_z * leaning(medium, beam, at - plane, transport, empty);
  return scattered * (extinction * load_lanes(beam + at) * mean + 0.5f * look.scaled_mean_cosine * gain);
}

static inline lanes side_conductances(float cell, lanes transport) {
  return 1.0f / (cell * (2.0f + 1.5f * cell * transport));
}

static inline lanes conductances(float cell, lanes here, lanes next) {
  return 2.0f / (3.0f * cell * cell * (here + next));
}

__kernel void light_source(__global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
                           const CloudLightParams light, __global const float *restrict medium,
                           __global const float *restrict beams, __global float *restrict faces,
                           __global float *restrict sources) {
  const size_t cloud = get_global_id(1);
  const CloudGrid grid = grids[cloud];
  const CloudScattering look = looks[cloud];
  medium += cloud * LEVEL_CELLS + FIRST_LEVEL;
  beams += FIRST_BEAM + cloud * CLOUD_SUNS * CELLS;
  faces += cloud * 4 * LEVEL_CELLS;
  sources += cloud * 3 * LEVEL_CELLS;
  const Level level = finest_level(grid);
  const float transport = transport_share(look), empty = empty_extinction(grid);
  const float last_x = (float)(grid.size_x - 1);
  const int last_y = grid.size_y - 1, last_z = grid.size_z - 1;
  for (int i = (int)get_global_id(0); i < level_pieces(level); i += (int)get_global_size(0)) {
    const Piece piece = piece_of(level, i);
    __global const float *cells = medium + piece.at - FIRST_LEVEL;
    const lanes x = (float)piece.x + LANE_INDEX;
    const lanes here = transport_extinction(load_lanes(cells), transport, empty);
    const lanes right = transport_extinction(load_lanes(cells + 1), transport, empty);
    store_lanes(select((lanes)0.0f, conductances(grid.cell_x, here, right), mask_of(x < last_x)),
                faces + FACES_X + piece.at);
    lanes up = (lanes)0.0f, back = (lanes)0.0f;
    if (piece.y < last_y)
      up = conductances(grid.cell_y, here, transport_extinction(load_lanes(cells + grid.size_x), transport, empty));
    if (piece.z < last_z)
      back = conductances(grid.cell_z, here,
                          transport_extinction(load_lanes(cells + grid.size_x * grid.size_y), transport, empty));
    store_lanes(up, faces + FACES_Y + piece.at);
    store_lanes(back, faces + FACES_Z + piece.at);

    // Sides see half of each hemisphere; top and bottom one.
    lanes beside = select((lanes)0.0f, side_conductances(grid.cell_x, here), mask_of(x < 0.5f) | mask_of(x > last_x - 0.5f));
    if (piece.z == 0 || piece.z == last_z) beside += side_conductances(grid.cell_z, here);
    lanes below = (lanes)0.0f, above = (lanes)0.0f;
    if (piece.y == 0) below = side_conductances(grid.cell_y, here);
    if (piece.y == last_y) above = side_conductances(grid.cell_y, here);
    store_lanes(beside + below + above, faces + FACES_OUT + piece.at);
    const lanes of_sky = 4.0f * PI * (0.5f * beside + above), of_ground = 4.0f * PI * (0.5f * beside + below);
    lanes red = light.sky_red * of_sky + light.ground_red * of_ground;
    lanes green = light.sky_green * of_sky + light.ground_green * of_ground;
    lanes blue = light.sky_blue * of_sky + light.ground_blue * of_ground;
    for (int sun = 0; sun < light.sun_count; ++sun) {
      const CloudSunLight from = light.suns[sun];
      const lanes amount = lit_by(grid, look, from, medium, beams + sun * CELLS, piece);
      red += from.red * amount;
      green += from.green * amount;
      blue += from.blue * amount;
    }
    store_lanes(red, sources + piece.at);
    store_lanes(green, sources + LEVEL_CELLS + piece.at);
    store_lanes(blue, sources + 2 * LEVEL_CELLS + piece.at);
  }
}
