#include "host/ocean/spectrum/fetch_laws.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offing::ocean {
namespace {

double variance_of_height_m2(double hs_m) {
  return hs_m * hs_m / 16.0;
}

}  // namespace

double wind_of_height_and_period_mps(double hs_m, double peak_period_s, double gravity_mps2) {
  const double omega_peak_radps = 2.0 * std::numbers::pi / peak_period_s;
  const double wind_mps = variance_of_height_m2(hs_m) * std::pow(omega_peak_radps, 3.0) /
                          (1.6e-7 * 22.0 * 22.0 * 22.0 * gravity_mps2);
  return std::clamp(wind_mps, 0.1, 100.0);
}

double wind_of_spectrum_mps(const SeaSpectrum& spectrum) {
  constexpr int steps = 2000;
  const double ratio = std::pow(spectrum.omega_min_radps / spectrum.omega_max_radps, 1.0 / steps);
  double wind_mps = 0.0, m0_m2 = 0.0, peak = 0.0, omega_peak_radps = spectrum.omega_max_radps;
  double above_radps = spectrum.omega_max_radps, energy_above = spectrum.energy(above_radps);
  for (int i = 1; i <= steps; ++i) {
    const double omega_radps = spectrum.omega_max_radps * std::pow(ratio, i);
    const double energy = spectrum.energy(omega_radps);
    m0_m2 += 0.5 * (energy + energy_above) * (above_radps - omega_radps);
    if (energy > peak) {
      peak = energy;
      omega_peak_radps = omega_radps;
    }
    above_radps = omega_radps;
    energy_above = energy;
    wind_mps = std::max(wind_mps, wind_of_height_and_period_mps(4.0 * std::sqrt(m0_m2),
                                                                2.0 * std::numbers::pi / omega_peak_radps,
                                                                spectrum.dispersion.gravity_mps2));
  }
  return wind_mps;
}

double developed_peak_period_s(double hs_m, double gravity_mps2) {
  constexpr double alpha = 0.0081;
  return 2.0 * std::numbers::pi *
         std::pow(5.0 * variance_of_height_m2(hs_m) / (alpha * gravity_mps2 * gravity_mps2), 0.25);
}

}  // namespace offing::ocean
