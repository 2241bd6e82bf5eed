#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "host/ocean/ocean_limits.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/spectrum/spreading.h"

// The modelled frequency spectra. Below their peak all wind seas fall as exp(-1.25 (omega_peak / omega)^4),
// above it as omega^-5 or slower by TMA's depth factor; the bounds here leave about 1e-9 of m0 outside.

namespace offing::ocean {
namespace {

using std::numbers::pi;

constexpr double lowest_share_of_peak =
    0.45;  // exp(-1.25 / 0.45^4) = 6e-14, 3.3 times that with JONSWAP's gamma
constexpr double highest_share_of_peak = 180.0;  // 1.25 / 180^4 = 1.2e-9

constexpr double phillips_alpha = 0.0081;      // Pierson and Moskowitz 1964, Phillips's equilibrium constant
constexpr double profile_195_over_10 = 1.026;  // U at 19.5 m over U10 in a neutral profile, drag 1.5e-3

/// alpha g^2 / omega^5 exp(-1.25 (omega_peak / omega)^4) gamma^r with JONSWAP's r (Hasselmann et al. 1973);
/// gamma = 1 is Pierson-Moskowitz.
struct WindSea {
  double alpha;
  double omega_peak_radps;
  double gamma;
  double gravity_mps2;

  double operator()(double omega_radps) const {
    if (omega_radps <= 0.0) {
      return 0.0;
    }
    const double ratio = omega_radps / omega_peak_radps;
    const double inverse_square = 1.0 / (ratio * ratio);
    const double base = alpha * gravity_mps2 * gravity_mps2 / std::pow(omega_radps, 5.0) *
                        std::exp(-1.25 * inverse_square * inverse_square);
    if (gamma == 1.0) {
      return base;
    }
    const double width = ratio <= 1.0 ? 0.07 : 0.09;
    const double offset = (ratio - 1.0) / width;
    return base * std::pow(gamma, std::exp(-0.5 * offset * offset));
  }
};

/// Pierson and Moskowitz 1964: exp(-beta (g / (U omega))^4) with beta = 0.74 and U at 19.5 m.
WindSea pierson_moskowitz(const SpectrumParameters& parameters) {
  const double gravity_mps2 = parameters.dispersion.gravity_mps2;
  const double omega_peak_radps = std::pow(0.8 * 0.74, 0.25) * gravity_mps2 / parameters.wind_speed_mps;
  return {phillips_alpha, omega_peak_radps, 1.0, gravity_mps2};
}

/// Hasselmann et al. 1973, with alpha and omega_peak from wind and fetch. Taken as printed beyond the fetch
/// of full development too.
WindSea jonswap(const SpectrumParameters& parameters) {
  const double gravity_mps2 = parameters.dispersion.gravity_mps2;
  const double wind_mps = parameters.wind_speed_mps;
  const double alpha = 0.076 * std::pow(wind_mps * wind_mps / (parameters.fetch_m * gravity_mps2), 0.22);
  const double omega_peak_radps =
      22.0 * std::cbrt(gravity_mps2 * gravity_mps2 / (wind_mps * parameters.fetch_m));
  return {alpha, omega_peak_radps, parameters.gamma, gravity_mps2};
}

/// Thompson and Vincent 1983, on omega_h = omega sqrt(D / g).
double thompson_vincent_factor(double omega_h) {
  if (omega_h <= 1.0) {
    return 0.5 * omega_h * omega_h;
  }
  return omega_h < 2.0 ? 1.0 - 0.5 * (2.0 - omega_h) * (2.0 - omega_h) : 1.0;
}

/// Kitaigorodskii, Krasitskii, Zaslavskii 1975: k^-3 dk/domega at this depth over the same in deep water,
/// gravity waves: tanh^2(kD) / (1 + 2kD / sinh 2kD).
double kitaigorodskii_factor(const Dispersion& gravity_waves, double omega_radps) {
  const double k_radpm = gravity_waves.wavenumber_radpm(omega_radps);
  const double deep_k_radpm = omega_radps * omega_radps / gravity_waves.gravity_mps2;
  const double deep_group_speed_mps = 0.5 * gravity_waves.gravity_mps2 / omega_radps;
  return std::pow(deep_k_radpm / k_radpm, 3.0) * deep_group_speed_mps /
         gravity_waves.group_speed_mps(k_radpm);
}

void use_wind_sea(SeaSpectrum& spectrum, const WindSea& sea) {
  spectrum.energy = sea;
  spectrum.omega_min_radps = lowest_share_of_peak * sea.omega_peak_radps;
  spectrum.omega_max_radps = highest_share_of_peak * sea.omega_peak_radps;
  spectrum.kinks_radps = {sea.omega_peak_radps};
}

/// JONSWAP times a depth factor: Bouws et al. 1985.
void use_tma(SeaSpectrum& spectrum, const SpectrumParameters& parameters) {
  const WindSea sea = jonswap(parameters);
  use_wind_sea(spectrum, sea);
  if (std::isinf(spectrum.dispersion.depth_m)) {
    return;
  }
  Dispersion gravity_waves = spectrum.dispersion;
  gravity_waves.capillary_length_m = 0.0;
  if (parameters.depth_factor == DepthFactor::kitaigorodskii) {
    spectrum.energy = [=](double omega_radps) {
      return omega_radps > 0.0 ? sea(omega_radps) * kitaigorodskii_factor(gravity_waves, omega_radps) : 0.0;
    };
    return;
  }
  const double scale_s = std::sqrt(gravity_waves.depth_m / gravity_waves.gravity_mps2);
  spectrum.energy = [=](double omega_radps) {
    return sea(omega_radps) * thompson_vincent_factor(omega_radps * scale_s);
  };
  spectrum.kinks_radps.insert(spectrum.kinks_radps.end(), {1.0 / scale_s, 2.0 / scale_s});
  std::sort(spectrum.kinks_radps.begin(), spectrum.kinks_radps.end());
}

/// Lee & Lee 2007, eq. 5 (O5): P(K) = A exp(-1 / (kL)^2) / k^4 |cos|^2, times exp(-k^2 l^2) and the factor
/// for waves against the wind. The direction integrates to pi / 2 for either half of the circle; E takes
/// that, D is normalised.
void use_phillips(SeaSpectrum& spectrum, const SpectrumParameters& parameters) {
  const Dispersion dispersion = spectrum.dispersion;
  const double length_m = parameters.wind_speed_mps * parameters.wind_speed_mps / dispersion.gravity_mps2;
  const double cutoff_m = parameters.phillips_cutoff_m;
  const double upwind = parameters.phillips_upwind;
  require_within("phillips_cutoff_m", cutoff_m, 0.0, 0.1 * length_m);
  require_within("phillips_upwind", upwind, 0.0, 1.0);
  const double constant = parameters.phillips_constant.value_or(phillips_alpha / (2.0 * pi));
  require_within("phillips_constant", constant, 1e-12, 1e3);

  const double direction_integral = 0.5 * pi * (1.0 + upwind);
  spectrum.energy = [=](double omega_radps) {
    const double k_radpm = dispersion.wavenumber_radpm(omega_radps);
    if (k_radpm <= 0.0) {
      return 0.0;
    }
    const double inverse_kl = 1.0 / (k_radpm * length_m);
    const double kl_small = k_radpm * cutoff_m;
    return constant * direction_integral * std::exp(-inverse_kl * inverse_kl - kl_small * kl_small) /
           (k_radpm * k_radpm * k_radpm * dispersion.group_speed_mps(k_radpm));
  };
  const double direction_rad = parameters.spreading.direction_rad;
  spectrum.spreading_at = [=](double) -> DirectionalDensity {
    return [=](double theta_rad) {
      const double cosine = std::cos(theta_rad - direction_rad);
      return (cosine < 0.0 ? upwind : 1.0) * cosine * cosine / direction_integral;
    };
  };
  // Of m0 = A (pi L)^2 / 2, exp(-1 / (kL)^2) lies below k and 1 / (kL)^2 above.
  const double k_max_radpm = std::min(3.2e4 / length_m, cutoff_m > 0.0 ? 4.6 / cutoff_m : 3.2e4 / length_m);
  spectrum.omega_min_radps = dispersion.omega_radps(0.2 / length_m);
  spectrum.omega_max_radps = dispersion.omega_radps(k_max_radpm);
}

/// A Gaussian in frequency, cut 6.2 standard deviations from its centre (6e-10 of m0) and above 5 % of the
/// centre, and scaled so that what is left has the asked height.
void use_swell(SeaSpectrum& spectrum, const SpectrumParameters& parameters) {
  require_within("swell_hs_m", parameters.swell_hs_m, 1e-3, 40.0);
  require_within("swell_period_s", parameters.swell_period_s, 1.0, 60.0);
  const double centre_hz = 1.0 / parameters.swell_period_s;
  const double width_hz = parameters.swell_bandwidth_hz;
  require_within("swell_bandwidth_hz", width_hz, 1e-3 * centre_hz, 0.5 * centre_hz);

  const double low_hz = std::max(centre_hz - 6.2 * width_hz, 0.05 * centre_hz);
  const double high_hz = centre_hz + 6.2 * width_hz;
  const auto cumulative = [=](double frequency_hz) {
    return 0.5 * std::erfc((centre_hz - frequency_hz) / (std::numbers::sqrt2 * width_hz));
  };
  const double m0_m2 = parameters.swell_hs_m * parameters.swell_hs_m / 16.0;
  const double peak_m2_per_hz =
      m0_m2 / ((cumulative(high_hz) - cumulative(low_hz)) * width_hz * std::sqrt(2.0 * pi));
  spectrum.energy = [=](double omega_radps) {
    const double frequency_hz = omega_radps / (2.0 * pi);
    if (frequency_hz < low_hz || frequency_hz > high_hz) {
      return 0.0;
    }
    const double offset = (frequency_hz - centre_hz) / width_hz;
    return peak_m2_per_hz / (2.0 * pi) * std::exp(-0.5 * offset * offset);
  };
  spectrum.omega_min_radps = 2.0 * pi * low_hz;
  spectrum.omega_max_radps = 2.0 * pi * high_hz;

  SpreadingParameters narrow;
  narrow.model = SpreadingModel::cosine_2s;
  narrow.direction_rad = parameters.spreading.direction_rad;
  narrow.exponent_s = parameters.swell_exponent_s;
  require_within("swell_exponent_s", narrow.exponent_s, 0.0, 1000.0);
  spectrum.spreading_at = make_spreading(narrow, 2.0 * pi * centre_hz, parameters.wind_speed_mps,
                                         spectrum.dispersion.gravity_mps2);
}

/// Where E is largest: a scan in ln omega, refined by golden section around the best sample.
double find_peak_radps(const SeaSpectrum& spectrum) {
  const double low = std::log(spectrum.omega_min_radps);
  const double step = (std::log(spectrum.omega_max_radps) - low) / 1000.0;
  double best_energy = 0.0;
  double best = low;
  for (int i = 0; i <= 1000; ++i) {
    const double energy = spectrum.energy(std::exp(low + step * i));
    if (energy > best_energy) {
      best_energy = energy;
      best = low + step * i;
    }
  }
  double left = best - step;
  double right = best + step;
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

}  // namespace

SeaSpectrum make_sea_spectrum(const SpectrumParameters& parameters) {
  require_within("wind_speed_mps", parameters.wind_speed_mps, 0.1, 100.0);
  require_within("fetch_m", parameters.fetch_m, 100.0, 1e8);
  require_within("gamma", parameters.gamma, 1.0, 20.0);
  require_within("spreading.direction_rad", parameters.spreading.direction_rad, -1e6, 1e6);
  require_valid_dispersion(parameters.dispersion);

  SeaSpectrum spectrum;
  spectrum.dispersion = parameters.dispersion;
  double wind_at_10m_mps = parameters.wind_speed_mps;
  switch (parameters.model) {
    case SpectrumModel::phillips:
      use_phillips(spectrum, parameters);
      break;
    case SpectrumModel::pierson_moskowitz:
      use_wind_sea(spectrum, pierson_moskowitz(parameters));
      wind_at_10m_mps /= profile_195_over_10;
      break;
    case SpectrumModel::jonswap:
      use_wind_sea(spectrum, jonswap(parameters));
      break;
    case SpectrumModel::tma:
      use_tma(spectrum, parameters);
      break;
    case SpectrumModel::swell:
      use_swell(spectrum, parameters);
      break;
  }
  spectrum.omega_peak_radps = find_peak_radps(spectrum);
  if (!spectrum.spreading_at) {
    spectrum.spreading_at = make_spreading(parameters.spreading, spectrum.omega_peak_radps, wind_at_10m_mps,
                                           parameters.dispersion.gravity_mps2);
  }
  return spectrum;
}

}  // namespace offing::ocean
