#include "tests/ocean/surface/tile_correlation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace offing::ocean {
namespace {

using std::numbers::pi;

/// Sums of energy and squared slope, each also weighted with the cosine of its phase over the lag.
struct Sums {
  double height = 0.0, height_at_lag = 0.0, slope = 0.0, slope_at_lag = 0.0;

  void add(double energy_m2, double k_radpm, double cosine) {
    const double squared_slope = k_radpm * k_radpm * energy_m2;
    height += energy_m2;
    height_at_lag += energy_m2 * cosine;
    slope += squared_slope;
    slope_at_lag += squared_slope * cosine;
  }

  Correlation correlation() const { return {height_at_lag / height, slope_at_lag / slope}; }
};

void add_modes(const Ocean& sea, int cascade, Lag lag, Sums& sums) {
  const int n = sea.parameters().size;
  const double step_radpm =
      2.0 * pi / sea.parameters().cascades[static_cast<std::size_t>(cascade)].patch_length_m;
  const std::vector<float> energies = sea.mode_variance(cascade);
  for (std::size_t i = 0; i < energies.size(); ++i) {
    if (energies[i] == 0.0f) continue;
    const int row = static_cast<int>(i) / n, column = static_cast<int>(i) % n;
    const double kx = step_radpm * (column < n / 2 ? column : column - n);
    const double kz = step_radpm * (row < n / 2 ? row : row - n);
    sums.add(energies[i], std::hypot(kx, kz), std::cos(kx * lag.x_m + kz * lag.z_m));
  }
}

/// Sums over pairs of samples.
struct Products {
  double product = 0.0, square_here = 0.0, square_there = 0.0;

  void add(const std::vector<float>& here, const std::vector<float>& there) {
    for (std::size_t i = 0; i < here.size(); ++i) {
      product += static_cast<double>(here[i]) * there[i];
      square_here += static_cast<double>(here[i]) * here[i];
      square_there += static_cast<double>(there[i]) * there[i];
    }
  }

  double coefficient() const { return product / std::sqrt(square_here * square_there); }
};

SampleGrid simd_grid(Lag origin, double spacing_m) {
  return {.origin_x_m = origin.x_m,
          .origin_z_m = origin.z_m,
          .spacing_x_m = spacing_m,
          .spacing_z_m = spacing_m,
          .columns = static_cast<int>(8000.0 / spacing_m),
          .rows = 64};
}

}  // namespace

std::vector<Lag> tile_lags(const std::vector<Cascade>& cascades) {
  std::vector<Lag> lags;
  for (const Cascade& cascade : cascades)
    for (int p = 1; p <= 4; ++p) {
      const double length_m = p * cascade.patch_length_m;
      lags.push_back({.x_m = length_m});
      lags.push_back({.z_m = length_m});
      lags.push_back({.x_m = length_m, .z_m = length_m});
    }
  return lags;
}

Correlation correlation_of_spectrum(const SeaSpectrum& spectrum, double k_max_radpm, Lag lag) {
  const SeaState whole = integrate_sea_state(spectrum, 0.0, k_max_radpm);
  const double distance_m = std::hypot(lag.x_m, lag.z_m);
  const double bearing_rad = std::atan2(lag.z_m, lag.x_m);
  // Waves of more than this phase cancel among themselves: a smooth spectrum's integral over directions is
  // below sqrt(2 / (pi 150)) = 0.07 of their share, and the one over wavenumbers turns 20 times an octave
  // besides.
  const double largest_phase_rad = 150.0;
  const double k_end = std::min(k_max_radpm, largest_phase_rad / distance_m);
  const int directions = 1024;  // three a turn of the largest phase
  Sums sums;
  double k = spectrum.dispersion.wavenumber_radpm(spectrum.omega_min_radps);
  while (k < k_end) {
    const double step = std::min({0.3 / distance_m, k / 100.0, k_end - k});
    const double middle = k + 0.5 * step;
    const double omega = spectrum.dispersion.omega_radps(middle);
    const double energy_m2 =
        spectrum.energy(omega) * spectrum.dispersion.group_speed_mps(middle) * step * 2.0 * pi / directions;
    const DirectionalDensity density = spectrum.spreading_at(omega);
    for (int i = 0; i < directions; ++i) {
      const double direction_rad = (i + 0.5) * 2.0 * pi / directions;
      sums.add(energy_m2 * density(direction_rad), middle,
               std::cos(middle * distance_m * std::cos(direction_rad - bearing_rad)));
    }
    k += step;
  }
  return {.height = sums.height_at_lag / whole.m0_m2, .slope = sums.slope_at_lag / whole.mss};
}

Correlation correlation_of_modes(const Ocean& sea, Lag lag) {
  Sums sums;
  for (std::size_t i = 0; i < sea.parameters().cascades.size(); ++i)
    add_modes(sea, static_cast<int>(i), lag, sums);
  for (const GerstnerWave& wave : sea.parameters().gerstner_waves.waves) {
    const double phase = wave.wavenumber_radpm *
                         (std::cos(wave.direction_rad) * lag.x_m + std::sin(wave.direction_rad) * lag.z_m);
    sums.add(0.5 * wave.amplitude_m * wave.amplitude_m, wave.wavenumber_radpm, std::cos(phase));
  }
  return sums.correlation();
}

Correlation correlation_of_strips(Ocean& sea, Lag lag, double spacing_m) {
  const ComposedFields here = sea.read_composed(simd_grid({}, spacing_m), SlopeRule::added);
  const ComposedFields there = sea.read_composed(simd_grid(lag, spacing_m), SlopeRule::added);
  Products height, slope;
  height.add(here.displacement_y, there.displacement_y);
  slope.add(here.slope_x, there.slope_x);
  slope.add(here.slope_z, there.slope_z);
  return {.height = height.coefficient(), .slope = slope.coefficient()};
}

}  // namespace offing::ocean
