#pragma once

#include <vector>

#include "host/ocean/spectrum/sea_spectrum.h"

namespace offing::ocean {

/// The spectrum as the device reads it: T(ln k, theta) = S(omega, theta) d omega / d ln k, the variance of
/// waves per unit ln k and rad, m^2. The density over the wavenumber plane is P(K) = T / k^2 (O5).
struct SpectrumTable {
  int wavenumber_count = 0;   ///< nk
  int direction_count = 0;    ///< nd, spaced 2 pi / nd from theta = 0, periodic
  double log_k_first = 0.0;   ///< ln of the first wavenumber in rad/m
  double log_k_step = 0.0;    ///< spacing in ln k
  std::vector<float> values;  ///< [nk][nd] row-major, m^2
};

/// Tabulates the spectrum finely enough that linear interpolation in (ln k, theta) integrates to m0 within
/// 1e-4. Throws Error(bad_input) unless the spectrum has a range of positive, finite frequencies.
SpectrumTable tabulate(const SeaSpectrum& spectrum);

}  // namespace offing::ocean
