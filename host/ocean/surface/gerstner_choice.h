#pragma once

#include <cstdint>
#include <vector>

#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/surface/gerstner_waves.h"

namespace offing::ocean {

/// Which part of a spectrum becomes Gerstner waves.
struct GerstnerChoice {
  double split_radpm = 0.0;  ///< k_split: waves with k < k_split; the cascades begin there (cascades.h)
  int count = 16;            ///< 1 ... 64
  std::uint64_t seed = 1;
};

/// k_split for Gerstner waves of wavelengths longer than this. Throws Error(bad_input) beyond 0.1 m ... 1000
/// km.
double split_at_wavelength_radpm(double wavelength_m);

/// Gerstner waves for the long-wave end of the spectrum, modelled or measured. The waves below k_split are
/// cut into `count` bins of equal energy, about as many bands of frequency as directions in each, and a wave
/// stands for each bin: A^2 / 2 is the bin's energy, so that all add up to the spectrum's integral below
/// k_split; frequency and direction are drawn by the seed with the spectrum's density within the bin, so
/// that the mean over seeds is the spectrum itself; phases are drawn evenly. Empty where the spectrum has no
/// energy below k_split. Throws Error(bad_input) for a count or k_split out of range.
std::vector<GerstnerWave> choose_gerstner_waves(const SeaSpectrum& spectrum, const GerstnerChoice& choice);

}  // namespace offing::ocean
