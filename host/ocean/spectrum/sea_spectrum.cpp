#include "host/ocean/spectrum/sea_spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "host/base/error.h"
#include "host/ocean/spectrum/quadrature.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

// Eight-point panels of 1/64 of the range resolve JONSWAP's peak to 1e-8; measured spectra are split at their
// frequencies besides.
constexpr int panel_count = 64;
// A sum over equal steps converges exponentially for smooth periodic functions; one degree resolves cos^2s
// with s up to 1000 (standard deviation 2.6 degrees).
constexpr int direction_count = 360;

struct Direction {
  double radians, cosine, sine;
};

std::vector<Direction> equal_directions() {
  std::vector<Direction> directions;
  for (int i = 0; i < direction_count; ++i) {
    const double radians = 2.0 * pi * i / direction_count;
    directions.push_back({radians, std::cos(radians), std::sin(radians)});
  }
  return directions;
}

/// First circular moment of D, as a vector.
Direction first_moment(const DirectionalDensity& density, const std::vector<Direction>& directions) {
  double total = 0.0, cosine = 0.0, sine = 0.0;
  for (const Direction& direction : directions) {
    const double value = density(direction.radians);
    total += value;
    cosine += value * direction.cosine;
    sine += value * direction.sine;
  }
  return total > 0.0 ? Direction{0.0, cosine / total, sine / total} : Direction{};
}

Direction first_moment(const SeaSpectrum& spectrum, double omega_radps,
                       const std::vector<Direction>& directions) {
  if (!spectrum.first_moment_at) return first_moment(spectrum.spreading_at(omega_radps), directions);
  const std::complex<double> moment = spectrum.first_moment_at(omega_radps);
  return {0.0, moment.real(), moment.imag()};
}

struct Moments {
  double m0 = 0.0, m1 = 0.0, m2 = 0.0;  // over frequency in Hz
  double energy4 = 0.0, frequency_energy4 = 0.0;
  double cosine = 0.0, sine = 0.0, slope = 0.0;
  double peak_radps = 0.0, peak_energy = 0.0;  // the node where E is largest
};

SeaState state_of(const Moments& moments) {
  SeaState state;
  state.m0_m2 = moments.m0;
  if (moments.m0 <= 0.0) {
    return state;
  }
  state.hs_m = 4.0 * std::sqrt(moments.m0);
  state.tp_s = moments.energy4 / moments.frequency_energy4;
  state.tm01_s = moments.m0 / moments.m1;
  state.tm02_s = std::sqrt(moments.m0 / moments.m2);
  state.mean_direction_rad = direction_of_moment(moments.cosine, moments.sine, moments.m0);
  state.spread_rad = spread_of_moment(moments.cosine, moments.sine, moments.m0);
  state.mss = moments.slope;
  return state;
}

}  // namespace

double direction_of_moment(double cosine_m2, double sine_m2, double m0_m2) {
  if (std::hypot(cosine_m2, sine_m2) <= 1e-9 * m0_m2) {
    return 0.0;
  }
  const double direction_rad = std::atan2(sine_m2, cosine_m2);
  // Rounding around 0 must not come out as a full turn.
  return direction_rad < -1e-9 ? direction_rad + 2.0 * pi : std::max(direction_rad, 0.0);
}

double spread_of_moment(double cosine_m2, double sine_m2, double m0_m2) {
  return std::sqrt(std::max(2.0 * (1.0 - std::hypot(cosine_m2, sine_m2) / m0_m2), 0.0));
}

double find_peak_radps(const SeaSpectrum& spectrum) {
  constexpr int steps = 1000;
  const double low = std::log(spectrum.omega_min_radps), high = std::log(spectrum.omega_max_radps);
  std::vector<double> places;  // ln omega
  for (int i = 0; i <= steps; ++i) places.push_back(std::lerp(low, high, static_cast<double>(i) / steps));
  for (const double kink_radps : spectrum.kinks_radps) {
    places.push_back(std::clamp(std::log(kink_radps), low, high));
  }
  std::sort(places.begin(), places.end());
  std::size_t best = 0;
  double best_energy = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double energy = spectrum.energy(std::exp(places[i]));
    if (energy <= best_energy) continue;
    best_energy = energy;
    best = i;
  }
  double left = places[best == 0 ? 0 : best - 1], right = places[std::min(best + 1, places.size() - 1)];
  const double golden = 1.0 / std::numbers::phi;
  while (right - left > 1e-9) {
    const double inner_left = right - golden * (right - left);
    const double inner_right = left + golden * (right - left);
    if (spectrum.energy(std::exp(inner_left)) > spectrum.energy(std::exp(inner_right))) {
      right = inner_right;
    } else {
      left = inner_left;
    }
  }
  return std::exp(0.5 * (left + right));
}

SeaState integrate_sea_state(const SeaSpectrum& spectrum, double k_min_radpm, double k_max_radpm) {
  if (!(k_min_radpm >= 0.0 && k_max_radpm >= k_min_radpm)) {
    throw Error(ErrorKind::bad_input, "ocean: expected a band of wavenumbers with 0 <= k_min <= k_max",
                "give the lower end of the band first");
  }
  const Dispersion& dispersion = spectrum.dispersion;
  const double low = std::max(k_min_radpm, dispersion.wavenumber_radpm(spectrum.omega_min_radps));
  const double high = std::min(k_max_radpm, dispersion.wavenumber_radpm(spectrum.omega_max_radps));
  Moments moments;
  if (low >= high) {
    return state_of(moments);
  }
  const std::vector<Direction> directions = equal_directions();
  const std::vector<double> edges =
      log_wavenumber_panels(spectrum, std::log(low), std::log(high), panel_count);
  // E^4 is taken of energy relative to the peak, to stay clear of underflow.
  const double largest_energy = spectrum.energy(spectrum.omega_peak_radps);
  for (std::size_t panel = 0; panel + 1 < edges.size(); ++panel) {
    for_each_gauss_node(edges[panel], edges[panel + 1], [&](double log_k, double weight) {
      const double k_radpm = std::exp(log_k);
      const double omega_radps = dispersion.omega_radps(k_radpm);
      const double variance_m2 = weight * energy_per_log_k(spectrum, k_radpm, omega_radps);
      if (variance_m2 <= 0.0) {
        return;
      }
      const double frequency_hz = omega_radps / (2.0 * pi);
      const double energy = spectrum.energy(omega_radps);
      if (energy > moments.peak_energy) {
        moments.peak_energy = energy;
        moments.peak_radps = omega_radps;
      }
      moments.m0 += variance_m2;
      moments.m1 += frequency_hz * variance_m2;
      moments.m2 += frequency_hz * frequency_hz * variance_m2;
      moments.slope += k_radpm * k_radpm * variance_m2;
      const double weighted4 = variance_m2 * std::pow(energy / largest_energy, 3.0);
      moments.energy4 += weighted4;
      moments.frequency_energy4 += frequency_hz * weighted4;
      const Direction mean = first_moment(spectrum, omega_radps, directions);
      moments.cosine += variance_m2 * mean.cosine;
      moments.sine += variance_m2 * mean.sine;
    });
  }
  SeaState state = state_of(moments);
  if (moments.m0 <= 0.0) return state;
  const double peak_k_radpm = dispersion.wavenumber_radpm(spectrum.omega_peak_radps);
  const double peak_radps =
      peak_k_radpm >= low && peak_k_radpm <= high ? spectrum.omega_peak_radps : moments.peak_radps;
  const Direction at_peak = first_moment(spectrum, peak_radps, directions);
  state.peak_period_s = 2.0 * pi / peak_radps;
  state.peak_direction_rad = direction_of_moment(at_peak.cosine, at_peak.sine, 1.0);
  return state;
}

}  // namespace offing::ocean
