// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <cstddef>
#include <cstdint>

/// The peer's own loops, a row each. They alone are compiled for this very processor; n is a multiple of 16.
namespace offing::bench::peer {

/// One row of modes, kz >= 0: h = P cos(w t) + Q sin(w t), the phase in turns of 2^-32 being
/// rate * (ticks + tick_fraction).
struct ModeRow {
  const float *p_re, *p_im, *q_re, *q_im;  ///< [n] m
  const std::uint32_t* rate;               ///< [n]
  float kz_radpm;
};

struct Frame {
  int size;  ///< n
  float wavenumber_step_radpm;
  float choppiness;
  std::uint32_t ticks;
  float tick_fraction;
};

/// Spectra of dx + i h, dz + i d dx/dz, dh/dx + i dh/dz and d dx/dx + i d dz/dz: rows of n complex numbers,
/// `field_floats` apart. `row` takes kz, `mirrored` takes -kz, by symmetry; for kz = 0 it is null.
void evolve(const Frame& frame, const ModeRow& modes, float* row, float* mirrored, std::size_t field_floats);

/// How the maps are stored.
enum class Stores { cached, streaming };

/// Two rows of n complex numbers -> n pairs of them.
void pack(const float* first, const float* second, float* map, int size, Stores stores);
/// Streaming stores of this thread become visible to the others.
void finish_stores();

}  // namespace offing::bench::peer
