// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/peers/gerstner_peer_kernels.h"

#include <cmath>
#include <cstring>
#include <numbers>

namespace offing::bench::peer {
namespace {

constexpr int lanes = 16, most_waves = 64, most_tile = 256;
using Vector = float __attribute__((vector_size(4 * lanes)));

/// a0 b0 a1 b1 ... of the lower halves, and of the upper ones.
Vector low_halves(const Vector& a, const Vector& b) {
  return __builtin_shufflevector(a, b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
}

Vector high_halves(const Vector& a, const Vector& b) {
  return __builtin_shufflevector(a, b, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);
}

Vector backward(const Vector& a) {
  return __builtin_shufflevector(a, a, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
}

void store(const Vector& value, float* target) {
  std::memcpy(target, &value, sizeof value);
}

/// Sixteen columns of four fields -> float4 each.
void store_interleaved(const Vector& a, const Vector& b, const Vector& c, const Vector& d, float* target) {
  const Vector low_ac = low_halves(a, c), high_ac = high_halves(a, c);
  const Vector low_bd = low_halves(b, d), high_bd = high_halves(b, d);
  store(low_halves(low_ac, low_bd), target);
  store(high_halves(low_ac, low_bd), target + lanes);
  store(low_halves(high_ac, high_bd), target + 2 * lanes);
  store(high_halves(high_ac, high_bd), target + 3 * lanes);
}

/// Fields in the order of GerstnerWave::amplitude.
void store_fields(const Vector* field, const GerstnerRow& row, int column) {
  store_interleaved(field[4], field[0], field[5], field[2], row.displacement + 4 * column);
  store_interleaved(field[6], field[7], field[1], field[3], row.gradient + 4 * column);
}

Vector load(const float* source) {
  Vector value;
  std::memcpy(&value, source, sizeof value);
  return value;
}

/// Cosine and sine of each wave's phase so many columns from the middle of a row.
void waves_at(const GerstnerRow& row, float column, float* cosine, float* sine) {
  alignas(64) float phase[most_waves];
  for (int w = 0; w < row.wave_count; ++w)
    phase[w] = row.waves[w].phase_rad + column * row.waves[w].column_step_rad;
  // In loops of their own: together the compiler would call sincosf, which has no vector form.
  for (int w = 0; w < row.wave_count; ++w) cosine[w] = std::cos(phase[w]);
  for (int w = 0; w < row.wave_count; ++w) sine[w] = std::sin(phase[w]);
}

}  // namespace

void gerstner_row_phases(const double* first_rad, const double* step_rad, int wave_count, int row,
                         GerstnerWave* waves) {
  constexpr double two_pi = 2.0 * std::numbers::pi;
  double phase[most_waves];
  for (int w = 0; w < wave_count; ++w) {
    const double unreduced = first_rad[w] + row * step_rad[w];
    phase[w] = unreduced - two_pi * std::nearbyint(unreduced / two_pi);
  }
  for (int w = 0; w < wave_count; ++w) waves[w].phase_rad = static_cast<float>(phase[w]);
}

void gerstner_loop(const GerstnerRow& row, int tile) {
  alignas(64) float phase[most_tile], cosine[most_tile], sine[most_tile], field[8][most_tile];
  const float middle = 0.5f * static_cast<float>(row.columns);
  for (int first = 0; first < row.columns; first += tile) {
    std::memset(field, 0, sizeof field);
    for (int w = 0; w < row.wave_count; ++w) {
      const GerstnerWave& wave = row.waves[w];
#pragma omp simd
      for (int i = 0; i < tile; ++i)
        phase[i] = wave.phase_rad + (static_cast<float>(first + i) - middle) * wave.column_step_rad;
        // See waves_at().
#pragma omp simd
      for (int i = 0; i < tile; ++i) cosine[i] = std::cos(phase[i]);
#pragma omp simd
      for (int i = 0; i < tile; ++i) sine[i] = std::sin(phase[i]);
#pragma omp simd
      for (int i = 0; i < tile; ++i) {
        for (int f = 0; f < 4; ++f) field[f][i] += wave.amplitude[f] * cosine[i];
        for (int f = 4; f < 8; ++f) field[f][i] += wave.amplitude[f] * sine[i];
      }
    }
    for (int i = 0; i < tile; i += lanes) {
      Vector fields[8];
      for (int f = 0; f < 8; ++f) std::memcpy(&fields[f], &field[f][i], sizeof fields[f]);
      store_fields(fields, row, first + i);
    }
  }
}

void gerstner_recurrence(const GerstnerRow& row) {
  Vector cosine[most_waves], sine[most_waves];
  alignas(64) float first_cosine[most_waves], first_sine[most_waves];
  waves_at(row, -0.5f * static_cast<float>(row.columns + 1), first_cosine, first_sine);
  for (int w = 0; w < row.wave_count; ++w) {
    const Vector c = load(row.waves[w].offset_cosine), s = load(row.waves[w].offset_sine);
    cosine[w] = c * first_cosine[w] - s * first_sine[w];
    sine[w] = s * first_cosine[w] + c * first_sine[w];
  }
  for (int column = 0; column < row.columns; column += lanes) {
    Vector field[8] = {};
    for (int w = 0; w < row.wave_count; ++w) {
      const GerstnerWave& wave = row.waves[w];
      const Vector c = cosine[w], s = sine[w];
      for (int f = 0; f < 4; ++f) field[f] += wave.amplitude[f] * c;
      for (int f = 4; f < 8; ++f) field[f] += wave.amplitude[f] * s;
      cosine[w] = c * wave.vector_cosine - s * wave.vector_sine;
      sine[w] = s * wave.vector_cosine + c * wave.vector_sine;
    }
    store_fields(field, row, column);
  }
}

void gerstner_mirrored(const GerstnerRow& row) {
  constexpr int block = 64, sides = block / 2 / lanes;
  for (int first = 0; first < row.columns; first += block) {
    alignas(64) float c[most_waves], s[most_waves], even[8][most_waves], odd[8][most_waves];
    waves_at(row, static_cast<float>(first) + 0.5f * static_cast<float>(block - 1 - row.columns), c, s);
    for (int w = 0; w < row.wave_count; ++w) {
      for (int f = 0; f < 8; ++f) {
        const float amplitude = row.waves[w].amplitude[f];
        even[f][w] = amplitude * (f < 4 ? c[w] : s[w]);
        odd[f][w] = amplitude * (f < 4 ? -s[w] : c[w]);
      }
    }
    for (int v = 0; v < sides; ++v) {
      Vector even_sum[8] = {}, odd_sum[8] = {};
      for (int w = 0; w < row.wave_count; ++w) {
        const Vector cosine = load(row.waves[w].offset_cosine + v * lanes);
        const Vector sine = load(row.waves[w].offset_sine + v * lanes);
        for (int f = 0; f < 8; ++f) {
          even_sum[f] += even[f][w] * cosine;
          odd_sum[f] += odd[f][w] * sine;
        }
      }
      Vector right[8], left[8];
      for (int f = 0; f < 8; ++f) {
        right[f] = even_sum[f] + odd_sum[f];
        left[f] = backward(even_sum[f] - odd_sum[f]);
      }
      store_fields(right, row, first + block / 2 + v * lanes);
      store_fields(left, row, first + block / 2 - (v + 1) * lanes);
    }
  }
}

}  // namespace offing::bench::peer
