// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/peers/queries_peer_kernels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offing::bench::peer {
namespace {

constexpr int count = query_tile, most_waves = 32, most_steps = 24;
using Values = float[count];

struct Tile {
  // Of the points: their phases of each wave within half a turn of 0, and their places in the patches.
  alignas(64) float phase[most_waves][count];
  alignas(64) float patch_x[4][count], patch_z[4][count];
  // Labels from the points.
  alignas(64) Values from_x, from_z;
};

void set_tile(const QuerySea& sea, const double* points, Tile& tile) {
  for (int w = 0; w < sea.wave_count; ++w) {
    const QueryWave& wave = sea.waves[w];
    for (int i = 0; i < count; ++i) {
      const double turns =
          (wave.kx_radpm * points[2 * i] + wave.kz_radpm * points[2 * i + 1] + wave.phase_rad) *
          (0.5 / std::numbers::pi);
      tile.phase[w][i] = static_cast<float>((turns - std::nearbyint(turns)) * (2.0 * std::numbers::pi));
    }
  }
  for (int c = 0; c < sea.cascade_count; ++c) {
    const double per_m = 1.0 / sea.cascades[c].patch_length_m;
    for (int i = 0; i < count; ++i) {
      const double x = points[2 * i] * per_m, z = points[2 * i + 1] * per_m;
      tile.patch_x[c][i] = static_cast<float>(x - std::floor(x));
      tile.patch_z[c][i] = static_cast<float>(z - std::floor(z));
    }
  }
  std::fill_n(tile.from_x, count, 0.0f);
  std::fill_n(tile.from_z, count, 0.0f);
}

/// Cosine and sine of a wave at the labels.
void wave_at(const QuerySea& sea, const Tile& tile, int w, Values& cosine, Values& sine) {
  const auto kx = static_cast<float>(sea.waves[w].kx_radpm), kz = static_cast<float>(sea.waves[w].kz_radpm);
  alignas(64) Values phase;
#pragma omp simd
  for (int i = 0; i < count; ++i) phase[i] = tile.phase[w][i] + kx * tile.from_x[i] + kz * tile.from_z[i];
    // In loops of their own: together the compiler would call sincosf, which has no vector form.
#pragma omp simd
  for (int i = 0; i < count; ++i) cosine[i] = std::cos(phase[i]);
#pragma omp simd
  for (int i = 0; i < count; ++i) sine[i] = std::sin(phase[i]);
}

struct Cells {
  int corner[4][count];
  float u[count], v[count];
};

void set_cells(const QuerySea& sea, const Tile& tile, int c, Cells& cells) {
  const auto per_m = static_cast<float>(1.0 / sea.cascades[c].patch_length_m);
  const int n = sea.size, mask = n - 1;
#pragma omp simd
  for (int i = 0; i < count; ++i) {
    const float x = (tile.patch_x[c][i] + tile.from_x[i] * per_m) * static_cast<float>(n);
    const float z = (tile.patch_z[c][i] + tile.from_z[i] * per_m) * static_cast<float>(n);
    const float left = std::floor(x), near = std::floor(z);
    const int column = static_cast<int>(left) & mask, row = static_cast<int>(near) & mask;
    cells.corner[0][i] = row * n + column;
    cells.corner[1][i] = row * n + ((column + 1) & mask);
    cells.corner[2][i] = ((row + 1) & mask) * n + column;
    cells.corner[3][i] = ((row + 1) & mask) * n + ((column + 1) & mask);
    cells.u[i] = x - left;
    cells.v[i] = z - near;
  }
}

void add_map(const float* map, const Cells& cells, Values* sums) {
  for (int i = 0; i < count; ++i) {
    const float *a = map + 4 * cells.corner[0][i], *b = map + 4 * cells.corner[1][i];
    const float *c = map + 4 * cells.corner[2][i], *d = map + 4 * cells.corner[3][i];
    const float u = cells.u[i], v = cells.v[i];
    for (int f = 0; f < 4; ++f) {
      const float near = a[f] + u * (b[f] - a[f]), far = c[f] + u * (d[f] - c[f]);
      sums[f][i] += near + v * (far - near);
    }
  }
}

/// Sums of the displacement (x, z) and its derivative (x by x, z by x, x by z, z by z).
void add_displacement(const float* map, const Cells& cells, float texels_per_m, Values* sums) {
  for (int i = 0; i < count; ++i) {
    const float *a = map + 4 * cells.corner[0][i], *b = map + 4 * cells.corner[1][i];
    const float *c = map + 4 * cells.corner[2][i], *d = map + 4 * cells.corner[3][i];
    const float u = cells.u[i], v = cells.v[i];
    for (int f = 0; f < 2; ++f) {
      const int field = 2 * f;
      const float along_near = b[field] - a[field], along_far = d[field] - c[field];
      const float near = a[field] + u * along_near, across = c[field] + u * along_far - near;
      sums[f][i] += near + v * across;
      sums[2 + f][i] += texels_per_m * (along_near + v * (along_far - along_near));
      sums[4 + f][i] += texels_per_m * across;
    }
  }
}

void find_labels(const QuerySea& sea, Tile& tile) {
  alignas(64) Values sums[6], cosine, sine;
  Cells cells;
  for (int step = 0; step < most_steps; ++step) {
    const bool takes_all = step > 0 || sea.wave_count == 0;
    std::fill_n(sums[0], 6 * count, 0.0f);
    for (int w = 0; w < sea.wave_count; ++w) {
      wave_at(sea, tile, w, cosine, sine);
      const QueryWave& wave = sea.waves[w];
#pragma omp simd
      for (int i = 0; i < count; ++i) {
        sums[0][i] += wave.sine[0] * sine[i];
        sums[1][i] += wave.sine[1] * sine[i];
        sums[2][i] += wave.cosine[1] * cosine[i];
        sums[3][i] += wave.cosine[2] * cosine[i];
        sums[4][i] += wave.cosine[2] * cosine[i];
        sums[5][i] += wave.cosine[3] * cosine[i];
      }
    }
    for (int c = 0; takes_all && c < sea.cascade_count; ++c) {
      set_cells(sea, tile, c, cells);
      add_displacement(sea.cascades[c].displacement, cells,
                       static_cast<float>(sea.size / sea.cascades[c].patch_length_m), sums);
    }
    float farthest = 0.0f;
#pragma omp simd reduction(max : farthest)
    for (int i = 0; i < count; ++i) {
      const float off_x = tile.from_x[i] + sums[0][i], off_z = tile.from_z[i] + sums[1][i];
      const float square = off_x * off_x + off_z * off_z;
      farthest = std::max(farthest, square);
      const float xx = 1.0f + sums[2][i], zz = 1.0f + sums[5][i];
      const float scale = 1.0f / std::max(xx * zz - sums[3][i] * sums[4][i], 0.05f);
      const float step_x = step == 0 ? off_x : scale * (zz * off_x - sums[4][i] * off_z);
      const float step_z = step == 0 ? off_z : scale * (xx * off_z - sums[3][i] * off_x);
      const bool is_far = square > sea.tolerance_m * sea.tolerance_m;
      tile.from_x[i] -= is_far ? step_x : 0.0f;
      tile.from_z[i] -= is_far ? step_z : 0.0f;
    }
    if (takes_all && farthest <= sea.tolerance_m * sea.tolerance_m) return;
  }
}

}  // namespace

void query_points(const QuerySea& sea, const double* points_xz, float* samples) {
  Tile tile;
  set_tile(sea, points_xz, tile);
  find_labels(sea, tile);
  // dx, h, dz, d dx/dz; dh/dx, dh/dz, d dx/dx, d dz/dz; vx, vy, vz, head: the fields of the three maps.
  alignas(64) Values sums[12] = {}, cosine, sine;
  for (int w = 0; w < sea.wave_count; ++w) {
    wave_at(sea, tile, w, cosine, sine);
    const QueryWave& wave = sea.waves[w];
#pragma omp simd
    for (int i = 0; i < count; ++i) {
      sums[0][i] += wave.sine[0] * sine[i];
      sums[1][i] += wave.cosine[0] * cosine[i];
      sums[2][i] += wave.sine[1] * sine[i];
      sums[3][i] += wave.cosine[2] * cosine[i];
      sums[4][i] += wave.sine[2] * sine[i];
      sums[5][i] += wave.sine[3] * sine[i];
      sums[6][i] += wave.cosine[1] * cosine[i];
      sums[7][i] += wave.cosine[3] * cosine[i];
      sums[8][i] += wave.cosine[4] * cosine[i];
      sums[9][i] += wave.sine[4] * sine[i];
      sums[10][i] += wave.cosine[5] * cosine[i];
      sums[11][i] += wave.cosine[6] * cosine[i];
    }
  }
  Cells cells;
  for (int c = 0; c < sea.cascade_count; ++c) {
    set_cells(sea, tile, c, cells);
    add_map(sea.cascades[c].displacement, cells, sums);
    add_map(sea.cascades[c].gradient, cells, sums + 4);
    if (sea.cascades[c].flow) add_map(sea.cascades[c].flow, cells, sums + 8);
  }
  const bool has_flow = sea.cascades[0].flow != nullptr;
  for (int i = 0; i < count; ++i) {
    const float xx = 1.0f + sums[6][i], xz = sums[3][i], zz = 1.0f + sums[7][i];
    const float jacobian = xx * zz - xz * xz;
    const float per_determinant = 1.0f / std::copysign(std::max(std::abs(jacobian), 0.05f), jacobian);
    float* sample = samples + 8 * i;
    sample[0] = sums[1][i];
    sample[1] = (zz * sums[4][i] - xz * sums[5][i]) * per_determinant;
    sample[2] = (xx * sums[5][i] - xz * sums[4][i]) * per_determinant;
    sample[3] = std::hypot(tile.from_x[i] + sums[0][i], tile.from_z[i] + sums[2][i]);
    sample[4] = sums[8][i];
    sample[5] = sums[9][i];
    sample[6] = sums[10][i];
    sample[7] = has_flow ? sea.weight_papm * (sums[11][i] - sums[1][i]) : 0.0f;
  }
}

}  // namespace offing::bench::peer
