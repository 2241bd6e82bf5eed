// Extinction and conductances of the coarser levels of each cloud, for light_diffuse.cl.
// In:    grids.
// Inout: medium [clouds][LEVEL_CELLS], faces [clouds][4][LEVEL_CELLS], of the finest level as light_density.cl and
//        light_source.cl left them.
// One work-group of GROUP_SIZE a cloud.
#include "clouds/light_levels.clh"

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void light_coarsen(
    __global const CloudGrid *restrict grids, __global float *restrict medium, __global float *restrict faces) {
  const size_t cloud = get_group_id(0);
  medium += cloud * LEVEL_CELLS;
  faces += cloud * 4 * LEVEL_CELLS;
  for (Level fine = finest_level(grids[cloud]); !is_coarsest(fine); fine = coarser(fine)) {
    const Level level = coarser(fine);
    for (int i = (int)get_local_id(0); i < level_pieces(level); i += GROUP_SIZE) {
      const Piece piece = piece_of(level, i);
      lanes density = (lanes)0.0f, next_x = density, next_y = density, next_z = density, out = density;
      const int x = fine_place(level, piece.x), then = fine_step(fine, x);
      for (int child = 0; child < 4; ++child) {
        const int at = fine.start +
                       ((2 * piece.z + child / 2) * fine.size_y + 2 * piece.y + child % 2) * fine.pitch + x;
        density += pair_sums(load_lanes(medium + at), load_lanes(medium + at + then));
        out += pair_sums(load_lanes(faces + FACES_OUT + at), load_lanes(faces + FACES_OUT + at + then));
        // Of faces toward the next coarse cell the mean of four: those of the children on that side.
        next_x += later_of_pairs(load_lanes(faces + FACES_X + at), load_lanes(faces + FACES_X + at + then));
        if (child % 2 == 1)
          next_y += pair_sums(load_lanes(faces + FACES_Y + at), load_lanes(faces + FACES_Y + at + then));
        if (child / 2 == 1)
          next_z += pair_sums(load_lanes(faces + FACES_Z + at), load_lanes(faces + FACES_Z + at + then));
      }
      const lanes is_cell = cells_in_row(level, piece.x);
      store_lanes(0.125f * is_cell * density, medium + piece.at);
      // Twice the distance makes D / c^2 a quarter.
      store_lanes(0.0625f * is_cell * next_x, faces + FACES_X + piece.at);
      store_lanes(0.0625f * is_cell * next_y, faces + FACES_Y + piece.at);
      store_lanes(0.0625f * is_cell * next_z, faces + FACES_Z + piece.at);
      // Beyond a row light that is not there leaves, so that what is divided by is not zero.
      store_lanes(0.125f * is_cell * out + (1.0f - is_cell), faces + FACES_OUT + piece.at);
    }
    wait_for_group();
  }
}
