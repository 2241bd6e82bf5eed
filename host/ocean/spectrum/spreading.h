#pragma once

#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/spectrum/spectrum_parameters.h"

namespace offing::ocean {

/// Normaliser of cos^2s: Q(s) = Gamma(s + 1) / (2 sqrt(pi) Gamma(s + 1/2)), so that Q |cos(theta / 2)|^2s
/// integrates to 1 over a turn. s >= 0.
double cosine_2s_normaliser(double exponent_s);

/// s of cos^2s with this spread (SeaState): its first circular moment is s / (s + 1), so that the spread is
/// sqrt(2 / (s + 1)).
double exponent_of_spread(double spread_rad);

/// D(omega, .) of a spreading model around its mean direction. `omega_peak_radps` and `wind_speed_mps` (U10)
/// give the wave age where the model asks for it; parameters.wind_speed_mps, if set, takes precedence.
///
/// cosine_2s: s as given. mitsuyasu: Mitsuyasu et al. 1975. hasselmann: Hasselmann, Dunckel, Ewing 1980.
/// donelan_banner: sech^2(beta theta), Donelan, Hamilton, Hui 1985 with Banner's 1990 tail. phillips_cosine:
/// cos^2 over the full turn, the same for waves along and against the wind. Each is multiplied by
/// cos^2s(theta / 2) with s = 16 tanh(omega_peak / omega) swell^2 (Horvath 2015) and normalised anew.
///
/// Throws Error(bad_input) when a parameter is out of range.
std::function<DirectionalDensity(double)> make_spreading(const SpreadingParameters& parameters,
                                                         double omega_peak_radps, double wind_speed_mps,
                                                         double gravity_mps2);

}  // namespace offing::ocean
