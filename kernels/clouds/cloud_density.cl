// Density of a cloud in bricks of 8 x 8 x 8 cells: metaballs, or a shape in their place, frayed by noise.
// C1 ... C3:
//   D = max(0, (1 - b) I + b strength turbulence)^wisp where I > 0, else 0; b = blend min(1, I / edge),
// I the implicit density, turbulence in (0, 1): the logistic function of a fractal sum of gradient noise, which
// spreads it about evenly.
// In: brick_index [n]: which brick of the grid each work-group computes, x fastest; begin [n + 1] and entries:
//     the balls that touch it; balls, places relative to the corner of the grid; octaves [params.octaves];
//     with SHAPE instead of balls: a grid of bricks (host/base/cloud_volume.h), whose corner and cell are
//     shape_corner and shape_cell of cells of the grid.
// Out: density [n][8 z][8 y][8 x].
// A work-group computes one brick of 64 rows of 8 cells along x, each work-item ROWS of them: 1 where lanes are
// work-items, all 64 on CPUs, which else keep 64 states across the barriers.
#include "clouds/metaball.clh"
#include "clouds/noise_lattice.clh"
#include "shared/cloud_field.h"
#include "shared/clouds.h"

#ifdef SHAPE
// A volume of bricks (host/base/cloud_volume.h) between its cells' middles.

// Density of cell (x, y, z), 0 beyond the grid.
static inline float volume_cell(__global const int* restrict bricks, __global const float* restrict density,
                                int bricks_x, int bricks_y, int bricks_z, int x, int y, int z) {
  if (min(min(x, y), z) < 0) return 0.0f;
  const int brick_x = x / CLOUD_BRICK_CELLS, brick_y = y / CLOUD_BRICK_CELLS, brick_z = z / CLOUD_BRICK_CELLS;
  if (brick_x >= bricks_x || brick_y >= bricks_y || brick_z >= bricks_z) return 0.0f;
  const int brick = bricks[(brick_z * bricks_y + brick_y) * bricks_x + brick_x];
  if (brick < 0) return 0.0f;
  const int cell = ((z % CLOUD_BRICK_CELLS) * CLOUD_BRICK_CELLS + y % CLOUD_BRICK_CELLS) * CLOUD_BRICK_CELLS +
                   x % CLOUD_BRICK_CELLS;
  return density[(size_t)brick * (CLOUD_BRICK_CELLS * CLOUD_BRICK_CELLS * CLOUD_BRICK_CELLS) + cell];
}

// Trilinear at a place in cells from the corner of the grid.
static inline float volume_sample(__global const int* restrict bricks, __global const float* restrict density,
                                  int bricks_x, int bricks_y, int bricks_z, float x, float y, float z) {
  const float low_x = floor(x - 0.5f), low_y = floor(y - 0.5f), low_z = floor(z - 0.5f);
  float sum = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    const int dx = corner & 1, dy = (corner >> 1) & 1, dz = corner >> 2;
    const float weight = (1.0f - fabs(x - 0.5f - low_x - (float)dx)) *
                         (1.0f - fabs(y - 0.5f - low_y - (float)dy)) *
                         (1.0f - fabs(z - 0.5f - low_z - (float)dz));
    sum += weight * volume_cell(bricks, density, bricks_x, bricks_y, bricks_z, (int)low_x + dx,
                                (int)low_y + dy, (int)low_z + dz);
  }
  return sum;
}

#endif

#define LANES (CLOUD_BRICK_CELLS * CLOUD_BRICK_CELLS / ROWS)

// Fixed-point place of the first cell of a brick, 2^-32 wavelengths.
static inline ulong brick_place(int whole, uint fraction, uint step, int brick) {
  return (((ulong)(uint)whole << 32) | fraction) + (ulong)(brick * CLOUD_BRICK_CELLS) * step;
}

static inline int points_from(ulong place, uint step) {
  return (int)((place + (ulong)(CLOUD_BRICK_CELLS - 1) * step) >> 32) - (int)(place >> 32) + 2;
}

static inline float fraction_of(ulong place) { return (float)(uint)(place & 0xffffffffu) * 0x1p-32f; }

__kernel __attribute__((reqd_work_group_size(LANES, 1, 1))) void cloud_density(
    const CloudFieldParams params, __global const CloudOctave* restrict octaves,
    __global const uint* restrict brick_index,
#ifdef SHAPE
    __global const int* restrict shape_bricks, __global const float* restrict shape_density,
    const int shape_bricks_x, const int shape_bricks_y, const int shape_bricks_z, const float shape_corner_x,
    const float shape_corner_y, const float shape_corner_z, const float shape_cell,
#else
    __global const uint* restrict begin, __global const uint* restrict entries,
    __global const CloudBall* restrict balls,
#endif
    __global float* restrict density) {
  const int brick = (int)get_group_id(0), lane = (int)get_local_id(0);
  const int index = (int)brick_index[brick];
  const int brick_x = index % params.bricks_x, brick_y = index / params.bricks_x % params.bricks_y;
  const int brick_z = index / params.bricks_x / params.bricks_y;
  const float8 steps = (float8)(0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f);

  float8 implicit[ROWS], sum[ROWS];  // sum: of the octaves
  for (int row = 0; row < ROWS; ++row) implicit[row] = sum[row] = 0.0f;
#ifdef SHAPE
  for (int row = 0; row < ROWS; ++row) {
    const int row_y = (lane * ROWS + row) & 7, row_z = (lane * ROWS + row) >> 3;
    const float place_y = ((float)(brick_y * 8 + row_y) + 0.5f - shape_corner_y) / shape_cell;
    const float place_z = ((float)(brick_z * 8 + row_z) + 0.5f - shape_corner_z) / shape_cell;
    float of_shape[8];
    for (int i = 0; i < 8; ++i) {
      const float place_x = ((float)(brick_x * 8 + i) + 0.5f - shape_corner_x) / shape_cell;
      of_shape[i] = volume_sample(shape_bricks, shape_density, shape_bricks_x, shape_bricks_y, shape_bricks_z,
                                  place_x, place_y, place_z);
    }
    implicit[row] = vload8(0, of_shape);
  }
#else
  // Relative to the brick's corner, so that its cells' places lose no digits.
  const float corner_x = (float)(brick_x * 8) * params.cell_m, corner_y = (float)(brick_y * 8) * params.cell_m;
  const float corner_z = (float)(brick_z * 8) * params.cell_m;
  const float8 x = (steps + 0.5f) * params.cell_m;
  for (uint entry = begin[brick]; entry < begin[brick + 1]; ++entry) {
    const CloudBall ball = balls[entries[entry]];
    const float per_square = 1.0f / (ball.radius * ball.radius);
    const float8 dx = x - (ball.x - corner_x);
    const float8 along = dx * dx * per_square;
    for (int row = 0; row < ROWS; ++row) {
      const int row_y = (lane * ROWS + row) & 7, row_z = (lane * ROWS + row) >> 3;
      const float dy = ((float)row_y + 0.5f) * params.cell_m - (ball.y - corner_y);
      const float dz = ((float)row_z + 0.5f) * params.cell_m - (ball.z - corner_z);
      const float across = (dy * dy + dz * dz) * per_square;
      if (across < 1.0f) implicit[row] += ball.weight * ball_profile8(along + across);
    }
  }
#endif

  __local float8 lattice_x[CLOUD_LATTICE_POINTS * CLOUD_LATTICE_POINTS];
  __local float8 lattice_y[CLOUD_LATTICE_POINTS * CLOUD_LATTICE_POINTS];
  __local float8 lattice_z[CLOUD_LATTICE_POINTS * CLOUD_LATTICE_POINTS];
  __local float8 lattice_value[CLOUD_LATTICE_POINTS * CLOUD_LATTICE_POINTS];
  // What a lattice column's value and its slope count in the eight cells of a row: the same in all rows.
  __local float8 value_weight[CLOUD_LATTICE_POINTS], slope_weight[CLOUD_LATTICE_POINTS];
  for (int number = 0; number < params.octaves; ++number) {
    const CloudOctave octave = octaves[number];
    const ulong from_x = brick_place(octave.origin_x, octave.fraction_x, octave.step, brick_x);
    const ulong from_y = brick_place(octave.origin_y, octave.fraction_y, octave.step, brick_y);
    const ulong from_z = brick_place(octave.origin_z, octave.fraction_z, octave.step, brick_z);
    const int points_x = points_from(from_x, octave.step), points_y = points_from(from_y, octave.step);
    const int points_z = points_from(from_z, octave.step);
    const float step = (float)octave.step * 0x1p-32f;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int point = lane; point < points_y * points_z; point += LANES) {
      const NoiseLattice8 made = noise_lattice8(
          params.seed_low, params.seed_high, (uint)number, octave.layer, octave.layer_fraction,
          (int)(from_x >> 32), (int)(from_y >> 32) + point % points_y, (int)(from_z >> 32) + point / points_y);
      lattice_x[point] = made.x;
      lattice_y[point] = made.y;
      lattice_z[point] = made.z;
      lattice_value[point] = made.value;
    }
    for (int column = lane; column < points_x; column += LANES) {
      const float8 dx = fraction_of(from_x) + steps * step - (float)column;
      value_weight[column] = noise_fade8(fmax(1.0f - fabs(dx), 0.0f));
      slope_weight[column] = value_weight[column] * dx;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    // What lattice columns give at the z of a row, at each y of the lattice.
    float8 slope_x[CLOUD_LATTICE_POINTS], slope_y[CLOUD_LATTICE_POINTS], level[CLOUD_LATTICE_POINTS];
    for (int row = 0; row < ROWS; ++row) {
      const int row_y = (lane * ROWS + row) & 7, row_z = (lane * ROWS + row) >> 3;
      const float at_y = fraction_of(from_y) + (float)row_y * step;
      // Rounding may put a place on the last lattice point, where the cell before it gives the same.
      const int low_y = min((int)at_y, points_y - 2);
      if (ROWS == 1 || row_y == 0) {
        const float at_z = fraction_of(from_z) + (float)row_z * step;
        const int low_z = min((int)at_z, points_z - 2);
        const float z_fraction = at_z - (float)low_z, z_fade = noise_fade(z_fraction);
        const int first = ROWS == 1 ? low_y : 0, end = ROWS == 1 ? low_y + 2 : points_y;
        for (int y = first; y < end; ++y) {
          const int near = y + low_z * points_y, far = near + points_y;
          const float near_weight = 1.0f - z_fade;
          slope_x[y] = near_weight * lattice_x[near] + z_fade * lattice_x[far];
          slope_y[y] = near_weight * lattice_y[near] + z_fade * lattice_y[far];
          level[y] = near_weight * (lattice_z[near] * z_fraction + lattice_value[near]) +
                     z_fade * (lattice_z[far] * (z_fraction - 1.0f) + lattice_value[far]);
        }
      }
      const float y_fraction = at_y - (float)low_y, y_fade = noise_fade(y_fraction), y_weight = 1.0f - y_fade;
      // Along the row, each lattice column gives slope * dx + value.
      const float8 slope = y_weight * slope_x[low_y] + y_fade * slope_x[low_y + 1];
      const float8 value = y_weight * (slope_y[low_y] * y_fraction + level[low_y]) +
                           y_fade * (slope_y[low_y + 1] * (y_fraction - 1.0f) + level[low_y + 1]);
      float slopes[8], values[8];
      vstore8(slope, 0, slopes);
      vstore8(value, 0, values);
      float8 noise = 0.0f;
      for (int column = 0; column < points_x; ++column) {
        noise += slopes[column] * slope_weight[column] + values[column] * value_weight[column];
      }
      sum[row] += octave.amplitude * noise;
    }
  }

  for (int row = 0; row < ROWS; ++row) {
    // 1.702: the logistic function nearest to that of the normal distribution (Camilli 1994).
    const float8 turbulence = 1.0f / (1.0f + exp(-1.702f * sum[row]));
    const float8 share = params.blend * fmin(implicit[row] / params.edge, 1.0f);
    const float8 base = fmax((1.0f - share) * implicit[row] + share * params.strength * turbulence, 0.0f);
    const float8 result = params.wisp == 1.0f ? base : pow(base, params.wisp);
    vstore8(select((float8)(0.0f), result, implicit[row] > 0.0f), (size_t)brick * 64 + lane * ROWS + row, density);
  }
}
