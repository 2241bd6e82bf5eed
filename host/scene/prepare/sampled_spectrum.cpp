#include "host/scene/prepare/sampled_spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace offing::scene {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// E(f) at as many frequencies as other readers take.
WaveSpectrum sampled_energy(const ocean::SeaSpectrum& spectrum) {
  constexpr int frequency_count = 99;
  // A swell's peak may be the highest: ten times the mean zero-crossing frequency reaches as far.
  const double highest_radps =
      std::min(spectrum.omega_max_radps,
               std::max(10.0 * spectrum.omega_peak_radps, 7.0 * turn / integrate_sea_state(spectrum).tm02_s));
  const double step = std::log(highest_radps / spectrum.omega_min_radps) / (frequency_count - 1);
  WaveSpectrum sampled;
  if (std::isfinite(spectrum.dispersion.depth_m)) {
    sampled.depth_m = spectrum.dispersion.depth_m;
  }
  for (int i = 0; i < frequency_count; ++i) {
    const double omega_radps = spectrum.omega_min_radps * std::exp(step * i);
    sampled.frequencies_hz.push_back(omega_radps / turn);
    sampled.energy.push_back(turn * spectrum.energy(omega_radps));  // E(f) df = E(omega) d omega
  }
  return sampled;
}

/// D(f, theta) at the frequencies that are there, each row scaled so that its sum integrates to 1.
void add_directions(const ocean::SeaSpectrum& spectrum, WaveSpectrum& sampled) {
  constexpr int direction_count = 72;
  for (int i = 0; i < direction_count; ++i) {
    sampled.directions_rad.push_back(turn * i / direction_count);
  }
  for (const double frequency_hz : sampled.frequencies_hz) {
    const ocean::DirectionalDensity density = spectrum.spreading_at(turn * frequency_hz);
    std::vector<double> row;
    for (const double direction_rad : sampled.directions_rad) {
      row.push_back(density(direction_rad));
    }
    const double integral = std::accumulate(row.begin(), row.end(), 0.0) * turn / direction_count;
    for (const double value : row) {
      sampled.spreading.push_back(value / integral);
    }
  }
}

}  // namespace

WaveSpectrum sampled_spectrum(const Sea& sea) {
  const bool is_record = sea.measured && sea.irregular_swells == 0;
  WaveSpectrum sampled = is_record ? *sea.measured : sampled_energy(sea.spectrum);
  if (!sampled.is_directional()) {
    add_directions(sea.spectrum, sampled);
  }
  return sampled;
}

}  // namespace offing::scene
