// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

/// The peers' own loops, a row each. They alone are compiled for this very processor and with -ffast-math;
/// columns are a multiple of 64.
namespace offing::bench::peer {

struct GerstnerWave {
  float phase_rad;                      // in the middle of the row, within half a turn of 0
  float column_step_rad;                // from column to column
  float vector_cosine, vector_sine;     // of 16 steps
  alignas(64) float offset_cosine[32];  // of (i + 1/2) steps
  alignas(64) float offset_sine[32];
  // Factors of the cosine: h, d dx/dx, d dx/dz, d dz/dz; and of the sine: dx, dz, dh/dx, dh/dz.
  float amplitude[8];
};

struct GerstnerRow {
  const GerstnerWave* waves;
  int wave_count;  // 64 at most
  int columns;
  float* displacement;  // [columns] float4
  float* gradient;
};

/// Phases of row `row`: first + row * step, within half a turn of 0. [wave_count]
void gerstner_row_phases(const double* first_rad, const double* step_rad, int wave_count, int row,
                         GerstnerWave* waves);
/// With sinf and cosf of arrays, `tile` columns at a time (256 at most).
void gerstner_loop(const GerstnerRow& row, int tile);
/// In vectors, each wave turned from one to the next.
void gerstner_recurrence(const GerstnerRow& row);
/// In vectors that mirror about the middle of a block of 64 columns.
void gerstner_mirrored(const GerstnerRow& row);

}  // namespace offing::bench::peer
