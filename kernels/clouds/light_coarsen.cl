// Conductances of the coarser levels of each cloud, for light_diffuse.cl.
// In:    grids; the first cloud.
// Inout: faces [clouds][channels][4][LEVEL_CELLS], of the finest level as light_faces.cl left them; what leaves a cell
//        becomes the inverse of what all its ways take together.
// One work-group of GROUP_SIZE a channel (dimension 0) and cloud from the first on (1).
#include "clouds/light_levels.clh"

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void light_coarsen(
    __global const CloudGrid *restrict grids, int first_cloud, __global float *restrict faces) {
  const CloudGrid grid = grids[first_cloud + get_group_id(1)];
  faces += (get_group_id(1) * get_num_groups(0) + get_group_id(0)) * 4 * LEVEL_CELLS(grid);
  for (Level fine = finest_level(grid); !is_coarsest(fine); fine = coarser(fine)) {
    const Level level = coarser(fine);
    for (int i = (int)get_local_id(0); i < level_pieces(level); i += GROUP_SIZE) {
      const Piece piece = piece_of(level, i);
      lanes next_x = (lanes)0.0f, next_y = next_x, next_z = next_x, out = next_x;
      const int x = fine_place(level, piece.x), then = fine_step(fine, x);
      for (int child = 0; child < 4; ++child) {
        const int at = fine.start +
                       ((2 * piece.z + child / 2) * fine.size_y + 2 * piece.y + child % 2) * fine.pitch + x;
        out += pair_sums(load_lanes(faces + FACES_OUT(level) + at), load_lanes(faces + FACES_OUT(level) + at + then));
        // Of faces toward the next coarse cell the mean of four: those of the children on that side.
        next_x += later_of_pairs(load_lanes(faces + FACES_X + at), load_lanes(faces + FACES_X + at + then));
        if (child % 2 == 1)
          next_y += pair_sums(load_lanes(faces + FACES_Y(level) + at), load_lanes(faces + FACES_Y(level) + at + then));
        if (child / 2 == 1)
          next_z += pair_sums(load_lanes(faces + FACES_Z(level) + at), load_lanes(faces + FACES_Z(level) + at + then));
      }
      const lanes is_cell = cells_in_row(level, piece.x);
      // Twice the distance makes D / c^2 a quarter.
      store_lanes(0.0625f * is_cell * next_x, faces + FACES_X + piece.at);
      store_lanes(0.0625f * is_cell * next_y, faces + FACES_Y(level) + piece.at);
      store_lanes(0.0625f * is_cell * next_z, faces + FACES_Z(level) + piece.at);
      // Beyond a row light that is not there leaves, so that what is divided by is not zero.
      store_lanes(0.125f * is_cell * out + (1.0f - is_cell), faces + FACES_OUT(level) + piece.at);
    }
    wait_for_group();
  }
  for (Level level = finest_level(grid);; level = coarser(level)) {
    const int plane = level.pitch * level.size_y;
    for (int i = (int)get_local_id(0); i < level_pieces(level); i += GROUP_SIZE) {
      __global float *ways = faces + piece_of(level, i).at;
      const lanes all = (load_lanes(ways + FACES_X) + load_lanes(ways + FACES_X - 1)) +
                        (load_lanes(ways + FACES_Y(level)) + load_lanes(ways + FACES_Y(level) - level.pitch)) +
                        (load_lanes(ways + FACES_Z(level)) + load_lanes(ways + FACES_Z(level) - plane)) + load_lanes(ways + FACES_OUT(level));
      store_lanes(1.0f / all, ways + FACES_OUT(level));
    }
    if (is_coarsest(level)) break;
  }
}
