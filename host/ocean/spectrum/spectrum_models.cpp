#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "host/ocean/ocean_limits.h"
#include "host/ocean/spectrum/fetch_laws.h"
#include "host/ocean/spectrum/quadrature.h"
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

/// What water of a depth leaves of a wind sea at each frequency (Bouws et al. 1985); all of it in deep water.
class ShallowWater {
 public:
  ShallowWater() = default;
  ShallowWater(const Dispersion& dispersion, DepthFactor model) : gravity_waves_(dispersion), model_(model) {
    gravity_waves_.capillary_length_m = 0.0;
  }

  double operator()(double omega_radps) const {
    if (is_deep()) return 1.0;
    return model_ == DepthFactor::kitaigorodskii ? kitaigorodskii_factor(gravity_waves_, omega_radps)
                                                 : thompson_vincent_factor(omega_radps * scale_s());
  }

  /// d ln factor / d ln omega.
  double slope(double omega_radps) const {
    constexpr double step = 1e-5;
    return std::log((*this)(omega_radps * (1.0 + step)) / (*this)(omega_radps * (1.0 - step))) / (2.0 * step);
  }

  std::vector<double> kinks_radps() const {
    if (is_deep() || model_ == DepthFactor::kitaigorodskii) return {};
    return {1.0 / scale_s(), 2.0 / scale_s()};
  }

 private:
  bool is_deep() const { return std::isinf(gravity_waves_.depth_m); }
  double scale_s() const { return std::sqrt(gravity_waves_.depth_m / gravity_waves_.gravity_mps2); }

  Dispersion gravity_waves_;
  DepthFactor model_ = DepthFactor::thompson_vincent;
};

/// A wind sea in water of a depth.
struct WindWaves {
  WindSea sea;
  ShallowWater water;

  double operator()(double omega_radps) const {
    return omega_radps > 0.0 ? sea(omega_radps) * water(omega_radps) : 0.0;
  }
  double omega_min_radps() const { return lowest_share_of_peak * sea.omega_peak_radps; }
  double omega_max_radps() const { return highest_share_of_peak * sea.omega_peak_radps; }
  std::vector<double> kinks_radps() const {
    std::vector<double> kinks = water.kinks_radps();
    kinks.push_back(sea.omega_peak_radps);
    std::sort(kinks.begin(), kinks.end());
    return kinks;
  }
};

/// Integrals of E and omega^2 E over omega.
struct WindWaveMoments {
  double m0 = 0.0, m2 = 0.0;

  explicit WindWaveMoments(const WindWaves& waves) {
    constexpr int panel_count = 64;  // of 0.09 in ln omega: the narrowest peak is 0.07 wide
    const double low = std::log(waves.omega_min_radps()), high = std::log(waves.omega_max_radps());
    std::vector<double> edges;
    for (int i = 0; i <= panel_count; ++i) edges.push_back(std::lerp(low, high, 1.0 * i / panel_count));
    for (const double kink_radps : waves.kinks_radps()) {
      if (std::log(kink_radps) > low && std::log(kink_radps) < high) edges.push_back(std::log(kink_radps));
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      for_each_gauss_node(edges[i], edges[i + 1], [&](double log_omega, double weight) {
        const double omega_radps = std::exp(log_omega);
        const double variance_m2 = weight * omega_radps * waves(omega_radps);
        m0 += variance_m2;
        m2 += omega_radps * omega_radps * variance_m2;
      });
    }
  }
};

/// omega_peak of JONSWAP's formula for a density that peaks at this frequency in this water, whose factor
/// grows with frequency and moves the peak up. With r = omega / omega_peak, d ln E / d ln omega = 5 r^-4 - 5
/// + slope of the factor - (r - 1) r ln gamma / width^2 exp(-(r - 1)^2 / 2 width^2) is 0 at the peak; at r =
/// 1 it is the factor's slope, 0 to 2, and without the last term 0 at r = (5 / (5 - slope))^(1/4).
double omega_peak_of_formula(double peak_radps, double gamma, const ShallowWater& water) {
  constexpr double width = 0.09;  // above the peak
  const double slope = std::max(water.slope(peak_radps), 0.0);
  const auto rise = [&](double r) {
    const double offset = (r - 1.0) / width;
    return 5.0 * std::pow(r, -4.0) - 5.0 + slope -
           offset / width * r * std::log(gamma) * std::exp(-0.5 * offset * offset);
  };
  double low = 1.0, high = std::pow(5.0 / (5.0 - slope), 0.25);
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    (rise(middle) > 0.0 ? low : high) = middle;
  }
  return peak_radps / low;
}

/// Waves of this height whose density peaks at this period.
WindWaves waves_of_height(double hs_m, double peak_period_s, double gamma, double gravity_mps2,
                          const ShallowWater& water) {
  WindWaves waves{{1.0, omega_peak_of_formula(2.0 * pi / peak_period_s, gamma, water), gamma, gravity_mps2},
                  water};
  waves.sea.alpha = hs_m * hs_m / 16.0 / WindWaveMoments(waves).m0;
  return waves;
}

/// The peak period of waves whose sqrt(m0 / m2) is tz_s. Each turn corrects the period by the ratio that is
/// left, which depends on it only through the depth.
double peak_period_of_mean_period(double tz_s, double gamma, double gravity_mps2, const ShallowWater& water) {
  double peak_period_s = 1.3 * tz_s;
  constexpr int most_turns = 200;
  for (int turn = 0; turn < most_turns; ++turn) {
    const WindWaveMoments moments(waves_of_height(1.0, peak_period_s, gamma, gravity_mps2, water));
    const double correction = tz_s / (2.0 * pi * std::sqrt(moments.m0 / moments.m2));
    peak_period_s *= correction;
    if (std::abs(correction - 1.0) < 1e-10) break;
  }
  return peak_period_s;
}

struct AskedWaves {
  WindWaves waves;
  double wind_at_10m_mps = 0.0;
};

/// The wind waves that height and period, or wind and fetch, ask for.
AskedWaves wind_waves(const SpectrumParameters& parameters) {
  const bool is_pierson_moskowitz = parameters.model == SpectrumModel::pierson_moskowitz;
  const double gravity_mps2 = parameters.dispersion.gravity_mps2;
  const ShallowWater water = parameters.model == SpectrumModel::tma
                                 ? ShallowWater(parameters.dispersion, parameters.depth_factor)
                                 : ShallowWater();
  if (!parameters.hs_m) {
    return {{is_pierson_moskowitz ? pierson_moskowitz(parameters) : jonswap(parameters), water},
            wind_at_10_m_mps(parameters.model, parameters.wind_speed_mps)};
  }
  const double gamma = is_pierson_moskowitz ? 1.0 : parameters.gamma;
  const double peak_period_s =
      parameters.tz_s ? peak_period_of_mean_period(*parameters.tz_s, gamma, gravity_mps2, water)
                      : parameters.tp_s.value_or(developed_peak_period_s(*parameters.hs_m, gravity_mps2));
  return {waves_of_height(*parameters.hs_m, peak_period_s, gamma, gravity_mps2, water),
          wind_of_height_and_period_mps(*parameters.hs_m, peak_period_s, gravity_mps2)};
}

void use_wind_waves(SeaSpectrum& spectrum, const WindWaves& waves) {
  spectrum.energy = waves;
  spectrum.omega_min_radps = waves.omega_min_radps();
  spectrum.omega_max_radps = waves.omega_max_radps();
  spectrum.kinks_radps = waves.kinks_radps();
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
  const double hs_m = parameters.hs_m.value_or(parameters.swell_hs_m);
  const double centre_hz = 1.0 / parameters.tp_s.value_or(parameters.swell_period_s);
  const double width_hz = parameters.swell_bandwidth_hz;
  require_within("swell_bandwidth_hz", width_hz, 1e-3 * centre_hz, 0.5 * centre_hz);

  const double low_hz = std::max(centre_hz - 6.2 * width_hz, 0.05 * centre_hz);
  const double high_hz = centre_hz + 6.2 * width_hz;
  const auto cumulative = [=](double frequency_hz) {
    return 0.5 * std::erfc((centre_hz - frequency_hz) / (std::numbers::sqrt2 * width_hz));
  };
  const double m0_m2 = hs_m * hs_m / 16.0;
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
  // For whoever integrates it among other waves: pieces of at most 2.5 standard deviations.
  for (const double deviations : {-6.2, -4.0, -2.0, 0.0, 2.0, 4.0, 6.2}) {
    const double kink_hz = centre_hz + deviations * width_hz;
    if (kink_hz >= low_hz) spectrum.kinks_radps.push_back(2.0 * pi * kink_hz);
  }

  SpreadingParameters narrow;
  narrow.model = SpreadingModel::cosine_2s;
  narrow.direction_rad = parameters.spreading.direction_rad;
  narrow.exponent_s = parameters.swell_exponent_s;
  require_within("swell_exponent_s", narrow.exponent_s, 0.0, 1000.0);
  spectrum.spreading_at = make_spreading(narrow, 2.0 * pi * centre_hz, parameters.wind_speed_mps,
                                         spectrum.dispersion.gravity_mps2);
}

}  // namespace

bool is_by_height(const SpectrumParameters& parameters) {
  const bool is_wind_sea = parameters.model == SpectrumModel::pierson_moskowitz ||
                           parameters.model == SpectrumModel::jonswap ||
                           parameters.model == SpectrumModel::tma;
  return parameters.hs_m && is_wind_sea;
}

double wind_at_10_m_mps(SpectrumModel model, double wind_speed_mps) {
  return model == SpectrumModel::pierson_moskowitz ? wind_speed_mps / profile_195_over_10 : wind_speed_mps;
}

SeaSpectrum make_sea_spectrum(const SpectrumParameters& parameters) {
  require_within("wind_speed_mps", parameters.wind_speed_mps, 0.1, 100.0);
  require_within("fetch_m", parameters.fetch_m, 100.0, 1e8);
  require_within("gamma", parameters.gamma, 1.0, 20.0);
  if (parameters.hs_m) require_within("hs_m", *parameters.hs_m, 1e-3, 40.0);
  if (parameters.tp_s) require_within("tp_s", *parameters.tp_s, 0.1, 60.0);
  if (parameters.tz_s) require_within("tz_s", *parameters.tz_s, 0.1, 60.0);
  require_within("spreading.direction_rad", parameters.spreading.direction_rad, -1e6, 1e6);
  require_valid_dispersion(parameters.dispersion);

  SeaSpectrum spectrum;
  spectrum.dispersion = parameters.dispersion;
  double wind_at_10m_mps = wind_at_10_m_mps(parameters.model, parameters.wind_speed_mps);
  switch (parameters.model) {
    case SpectrumModel::phillips:
      use_phillips(spectrum, parameters);
      break;
    case SpectrumModel::pierson_moskowitz:
    case SpectrumModel::jonswap:
    case SpectrumModel::tma: {
      const AskedWaves asked = wind_waves(parameters);
      use_wind_waves(spectrum, asked.waves);
      wind_at_10m_mps = asked.wind_at_10m_mps;
      break;
    }
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
