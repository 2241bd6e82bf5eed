#pragma once

#include <array>
#include <vector>

#include "host/ocean/spectrum/sea_spectrum.h"

namespace offing::ocean {

/// Calls visit(x, weight) at the eight Gauss-Legendre nodes of [low, high]: exact for polynomials of degree
/// 15 (Abramowitz and Stegun 1964, table 25.4).
template <typename Visit>
void for_each_gauss_node(double low, double high, Visit&& visit) {
  constexpr std::array<double, 4> offsets = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                             0.9602898564975363};
  constexpr std::array<double, 4> weights = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                             0.1012285362903763};
  const double centre = 0.5 * (low + high);
  const double half = 0.5 * (high - low);
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    visit(centre - half * offsets[i], half * weights[i]);
    visit(centre + half * offsets[i], half * weights[i]);
  }
}

/// Edges in ln k that cut [log_k_low, log_k_high] into `count` equal panels, and once more at each kink of
/// the spectrum, so that E is smooth inside every panel. Increasing.
std::vector<double> log_wavenumber_panels(const SeaSpectrum& spectrum, double log_k_low, double log_k_high,
                                          int count);

/// Variance of waves per unit ln k at this wavenumber, m^2: E(omega) d omega / d ln k.
double energy_per_log_k(const SeaSpectrum& spectrum, double k_radpm, double omega_radps);

}  // namespace offing::ocean
