#pragma once

#include "host/ocean/surface/ocean.h"

namespace offing::ocean {

/// One travelling wave of a patch: K = (column, row) 2 pi / L.
struct SingleWave {
  double patch_length_m = 0.0;
  int column = 1, row = 0;
  double amplitude_m = 1.0;
  Dispersion dispersion = {};

  double wavenumber_radpm() const;
  double direction_rad() const;
  double omega_radps() const { return dispersion.omega_radps(wavenumber_radpm()); }
};

/// A sea whose energy lies wholly in that wave's cell of the wavenumber plane: bumps in k and theta within
/// 0.3 steps of K. Its amplitude is drawn like any other; here the expected variance is chosen such that
/// `parameters` (seed, size and all) draw the wave's amplitude in their first cascade, within 1 %. The
/// patch length of that cascade must be the wave's.
SeaSpectrum single_wave_spectrum(const SingleWave& wave, const OceanParameters& parameters);

/// Both seas at once; dispersion of the first.
SeaSpectrum together(const SeaSpectrum& first, const SeaSpectrum& second);

}  // namespace offing::ocean
