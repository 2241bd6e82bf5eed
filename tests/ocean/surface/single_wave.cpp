#include "tests/ocean/surface/single_wave.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/ocean/surface/ocean_reference.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

// Smooth, zero at and beyond |x| = 1, integral 1.
double bump(double x) {
  return std::abs(x) < 1.0 ? 15.0 / 16.0 * (1.0 - x * x) * (1.0 - x * x) : 0.0;
}

}  // namespace

double SingleWave::wavenumber_radpm() const {
  return 2.0 * pi / patch_length_m * std::hypot(column, row);
}

double SingleWave::direction_rad() const {
  return std::atan2(row, column);
}

SeaSpectrum single_wave_spectrum(const SingleWave& wave, const OceanParameters& parameters) {
  // |h0| of unit variance, from which the variance that gives A = 2 |h0|.
  const auto n = static_cast<std::size_t>(parameters.size);
  OceanParameters first = parameters;
  first.cascades.resize(1);
  const OceanReference unit(wave.dispersion, first, {std::vector<float>(n * n, 1.0f)});
  const std::size_t place =
      (static_cast<std::size_t>(wave.row) + n) % n * n + (static_cast<std::size_t>(wave.column) + n) % n;
  const double variance = std::pow(0.5 * wave.amplitude_m / std::abs(unit.initial(0)[place]), 2.0);

  const double half_width_radpm = 0.3 * 2.0 * pi / wave.patch_length_m;
  const double half_width_rad = 0.3 / std::hypot(wave.column, wave.row);
  const double k_radpm = wave.wavenumber_radpm(), direction_rad = wave.direction_rad();
  const Dispersion dispersion = wave.dispersion;
  SeaSpectrum spectrum;
  spectrum.energy = [=](double omega_radps) {
    const double k = dispersion.wavenumber_radpm(omega_radps);
    return variance * bump((k - k_radpm) / half_width_radpm) / half_width_radpm /
           dispersion.group_speed_mps(k);
  };
  spectrum.spreading_at = [=](double) {
    return [=](double theta_rad) {
      return bump(std::remainder(theta_rad - direction_rad, 2.0 * pi) / half_width_rad) / half_width_rad;
    };
  };
  spectrum.omega_min_radps = dispersion.omega_radps(k_radpm - half_width_radpm);
  spectrum.omega_max_radps = dispersion.omega_radps(k_radpm + half_width_radpm);
  spectrum.omega_peak_radps = dispersion.omega_radps(k_radpm);
  spectrum.dispersion = dispersion;
  return spectrum;
}

SeaSpectrum together(const SeaSpectrum& first, const SeaSpectrum& second) {
  SeaSpectrum both = first;
  both.energy = [=](double omega_radps) { return first.energy(omega_radps) + second.energy(omega_radps); };
  both.spreading_at = [=](double omega_radps) -> DirectionalDensity {
    const double a = first.energy(omega_radps), b = second.energy(omega_radps);
    const DirectionalDensity first_density = first.spreading_at(omega_radps);
    const DirectionalDensity second_density = second.spreading_at(omega_radps);
    if (a + b <= 0.0) return first_density;
    return [=](double theta_rad) {
      return (a * first_density(theta_rad) + b * second_density(theta_rad)) / (a + b);
    };
  };
  both.omega_min_radps = std::min(first.omega_min_radps, second.omega_min_radps);
  both.omega_max_radps = std::max(first.omega_max_radps, second.omega_max_radps);
  for (const double edge :
       {first.omega_min_radps, first.omega_max_radps, second.omega_min_radps, second.omega_max_radps}) {
    both.kinks_radps.push_back(edge);
  }
  both.kinks_radps.insert(both.kinks_radps.end(), second.kinks_radps.begin(), second.kinks_radps.end());
  std::sort(both.kinks_radps.begin(), both.kinks_radps.end());
  return both;
}

}  // namespace offing::ocean
