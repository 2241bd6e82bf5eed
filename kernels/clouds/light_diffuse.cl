// Solves the diffusion of light in each cloud (clouds/diffusion.clh) by multigrid: CYCLES V-cycles, sweeps over every
// other row, residuals averaged over eight cells, corrections interpolated. The first cycle's way down finds nothing yet.
// In:    grids, the first cloud, faces [clouds][channels][4][LEVEL_CELLS] of light_coarsen.cl.
// Inout: sources [clouds][3][LEVEL_CELLS], of the finest level as light_gather.cl left them.
// Out:   fluence [clouds][3][LEVEL_CELLS]; zeros before the first level and beyond the last.
// One work-group of GROUP_SIZE a colour (dimension 0) and cloud from the first on (1).
#include "clouds/light_levels.clh"

#define CYCLES 3
#define COARSEST_SWEEPS 12

// What comes of a neighbour. Where there is none, memory has a cell that another item of the group may be writing.
static inline lanes passed_on(lanes way, __global const float *fluence) {
#if LANES == 1
  return way > 0.0f ? way * *fluence : 0.0f;
#else
  return way * load_lanes(fluence);
#endif
}

static inline lanes flow_into(__global const float *restrict faces, __global const float *fluence, lanes left,
                              const Level level, int at) {
  const int plane = level.pitch * level.size_y;
  return (passed_on(load_lanes(faces + FACES_X + at), fluence + at + 1) + load_lanes(faces + FACES_X + at - 1) * left) +
         (passed_on(load_lanes(faces + FACES_Y(level) + at), fluence + at + level.pitch) +
          passed_on(load_lanes(faces + FACES_Y(level) + at - level.pitch), fluence + at - level.pitch)) +
         (passed_on(load_lanes(faces + FACES_Z(level) + at), fluence + at + plane) +
          passed_on(load_lanes(faces + FACES_Z(level) + at - plane), fluence + at - plane));
}

// Along a row each cell takes what its neighbours had before, but for the first of CLOUD_LEAST_CELLS side by side, which are
// one vector where there are vectors.
static inline void relax_row(__global const float *restrict faces, __global const float *restrict sources,
                             __global float *fluence, const Level level, int y, int z) {
  const int row = level.start + (z * level.size_y + y) * level.pitch;
#if LANES == 1
  float left = 0.0f;
#endif
  for (int at = row; at < row + level.pitch; at += LANES) {
#if LANES == 1
    if (at > row && (at - row) % CLOUD_LEAST_CELLS == 0) left = fluence[at - 1];
    const float before = fluence[at];
#else
    const lanes left = load_lanes(fluence + at - 1);
#endif
    store_lanes((load_lanes(sources + at) + flow_into(faces, fluence, left, level, at)) *
                    load_lanes(faces + FACES_OUT(level) + at),
                fluence + at);
#if LANES == 1
    left = before;
#endif
  }
}

// Rows of one colour of a chessboard, then those of the other.
static inline void relax(__global const float *restrict faces, __global const float *restrict sources,
                         __global float *fluence, const Level level, int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
#if GROUP_SIZE == 1
    // The other colour a plane behind the first, so that memory is passed once.
    for (int z = 0; z <= level.size_z; ++z) {
      if (z < level.size_z)
        for (int y = z % 2; y < level.size_y; y += 2) relax_row(faces, sources, fluence, level, y, z);
      if (z > 0)
        for (int y = z % 2; y < level.size_y; y += 2) relax_row(faces, sources, fluence, level, y, z - 1);
    }
#else
    const int rows_of_plane = level.size_y / 2;
    for (int colour = 0; colour < 2; ++colour) {
      for (int i = (int)get_local_id(0); i < rows_of_plane * level.size_z; i += GROUP_SIZE) {
        const int z = i / rows_of_plane;
        relax_row(faces, sources, fluence, level, i % rows_of_plane * 2 + (z + colour) % 2, z);
      }
      wait_for_group();
    }
#endif
  }
}

static inline lanes residual(__global const float *restrict faces, __global const float *restrict sources,
                             __global const float *fluence, const Level level, int at) {
  return load_lanes(sources + at) + flow_into(faces, fluence, load_lanes(fluence + at - 1), level, at) -
         load_lanes(fluence + at) / load_lanes(faces + FACES_OUT(level) + at);
}

// Means of the residuals of eight cells, as sources of the coarser level.
static inline void restrict_residuals(__global const float *restrict faces, __global float *sources,
                                      __global float *fluence, const Level fine, bool is_first) {
  const Level level = coarser(fine);
  for (int i = (int)get_local_id(0); i < level_pieces(level); i += GROUP_SIZE) {
    const Piece piece = piece_of(level, i);
    const int x = fine_place(level, piece.x), then = fine_step(fine, x);
    lanes sum = (lanes)0.0f;
    for (int child = 0; child < 4; ++child) {
      const int at =
          fine.start + ((2 * piece.z + child / 2) * fine.size_y + 2 * piece.y + child % 2) * fine.pitch + x;
      lanes found[2];
      for (int half_row = 0; half_row < 2; ++half_row) {
        const int cell = at + half_row * then;
        found[half_row] = is_first ? load_lanes(sources + cell) : residual(faces, sources, fluence, fine, cell);
      }
      sum += pair_sums(found[0], found[1]);
    }
    store_lanes(0.125f * cells_in_row(level, piece.x) * sum, sources + piece.at);
    store_lanes((lanes)0.0f, fluence + piece.at);
  }
  wait_for_group();
}

// Four rows of the coarser level around a row of the finer one.
typedef struct {
  __global const float *near, *near_y, *near_z, *far;
} Rows;

#if LANES == 1
#define rows_at(rows, x) \
  mix(mix((rows).near[x], (rows).near_y[x], 0.25f), mix((rows).near_z[x], (rows).far[x], 0.25f), 0.25f)
#else
#define rows_at(rows, x)                                                          \
  mix(mix(vload8(0, (rows).near + (x)), vload8(0, (rows).near_y + (x)), 0.25f),   \
      mix(vload8(0, (rows).near_z + (x)), vload8(0, (rows).far + (x)), 0.25f), 0.25f)
#endif

// Their values at LANES cells of the finer row from `x` on: between middles 3 : 1 along each axis, as far as there are
// neighbours.
static inline lanes between_rows(const Rows rows, int x, int last) {
#if LANES == 1
  const int near_x = x / 2;
  return mix(rows_at(rows, near_x), rows_at(rows, clamp(near_x + 2 * (x % 2) - 1, 0, last)), 0.25f);
#else
  const int first = x / 2;
  const int8 cells = first + (int8)(0, 1, 2, 3, 4, 5, 6, 7);
  const float8 here = rows_at(rows, first);
  const float8 before = select(rows_at(rows, first - 1), here, cells == 0);
  const float8 after = select(rows_at(rows, first + 1), here, cells == last);
  lanes found;
  found.even = mix(here, before, 0.25f);
  found.odd = mix(here, after, 0.25f);
  return found;
#endif
}

static inline void interpolate(__global float *fluence, const Level level, bool is_first) {
  const Level coarse = coarser(level);
  for (int i = (int)get_local_id(0); i < level_pieces(level); i += GROUP_SIZE) {
    const Piece piece = piece_of(level, i);
    if (piece.x >= level.size_x) continue;
    const int near_y = piece.y / 2, far_y = clamp(near_y + 2 * (piece.y % 2) - 1, 0, coarse.size_y - 1);
    const int near_z = piece.z / 2, far_z = clamp(near_z + 2 * (piece.z % 2) - 1, 0, coarse.size_z - 1);
    __global const float *near_plane = fluence + coarse.start + near_z * coarse.size_y * coarse.pitch;
    __global const float *far_plane = fluence + coarse.start + far_z * coarse.size_y * coarse.pitch;
    const Rows rows = {near_plane + near_y * coarse.pitch, near_plane + far_y * coarse.pitch,
                       far_plane + near_y * coarse.pitch, far_plane + far_y * coarse.pitch};
    const lanes found = between_rows(rows, piece.x, coarse.size_x - 1);
    store_lanes(is_first ? found : found + load_lanes(fluence + piece.at), fluence + piece.at);
  }
  wait_for_group();
}

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void light_diffuse(
    __global const CloudGrid *restrict grids, __global const float *restrict faces, int first_cloud, int channels,
    __global float *restrict sources, __global float *restrict fluence) {
  const size_t cloud = get_group_id(1), colour = get_group_id(0);
  const CloudGrid grid = grids[first_cloud + cloud];
  faces += (cloud * channels + (channels == 1 ? 0 : colour)) * 4 * LEVEL_CELLS(grid);
  sources += (cloud * 3 + colour) * LEVEL_CELLS(grid);
  fluence += (cloud * 3 + colour) * LEVEL_CELLS(grid);
  int coarsest = 0;
  for (Level level = finest_level(grid); !is_coarsest(level); level = coarser(level)) ++coarsest;
  for (int cycle = 0; cycle < CYCLES; ++cycle) {
    const bool is_first = cycle == 0;
    // Down to the coarsest level and up again.
    for (int step = 0; step <= 2 * coarsest; ++step) {
      const Level level = level_of(grid, min(step, 2 * coarsest - step));
      if (step > coarsest) interpolate(fluence, level, is_first);
      const int sweeps = step == coarsest ? COARSEST_SWEEPS : (is_first && step < coarsest ? 0 : 1);
      relax(faces, sources, fluence, level, sweeps);
      if (step < coarsest) restrict_residuals(faces, sources, fluence, level, is_first);
    }
  }
}
