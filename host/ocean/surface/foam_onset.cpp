#include "host/ocean/surface/foam_onset.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/ocean/spectrum/quadrature.h"
#include "host/ocean/surface/foam.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

constexpr double full_wind_mps = 8.0, first_wind_mps = 3.7;

/// Levels of foam at which areas are worked out.
constexpr int levels = 16;

/// Statistics of T = d dx/dx + d dz/dz at a label, of the waves of one cascade that can foam.
struct Compression {
  double variance = 0.0;
  double spread = 0.0;       ///< (1 - R^2) / 4
  double correlation = 0.0;  ///< from one past instant to the next

  /// How far below 0 T falls, in standard deviations, where J falls to this.
  double threshold(double jacobian) const {
    // 1 + T + spread (T^2 - variance) = J; the root that is continuous in spread = 0.
    const double c = 1.0 - spread * variance - jacobian;
    return 2.0 * c / (1.0 + std::sqrt(std::max(1.0 - 4.0 * spread * c, 0.0))) / std::sqrt(variance);
  }
};

double normal_density(double x) {
  return std::exp(-0.5 * x * x) / std::sqrt(2.0 * pi);
}

double normal_share_below(double x) {
  return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

Compression compression_of(const SeaSpectrum& spectrum, const Cascade& cascade, double choppiness,
                           double k_most_radpm, double step_s) {
  const Dispersion& dispersion = spectrum.dispersion;
  const double low_radpm =
      std::max(cascade.k_min_radpm, dispersion.wavenumber_radpm(spectrum.omega_min_radps));
  const double high_radpm =
      std::min({cascade.k_max_radpm, k_most_radpm, dispersion.wavenumber_radpm(spectrum.omega_max_radps)});
  if (!(low_radpm < high_radpm)) return {};
  constexpr int panels = 24, directions = 180;
  double square = 0.0, cosine = 0.0, sine = 0.0, later = 0.0;
  const std::vector<double> edges =
      log_wavenumber_panels(spectrum, std::log(low_radpm), std::log(high_radpm), panels);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    for_each_gauss_node(edges[i], edges[i + 1], [&](double log_k, double weight) {
      const double k_radpm = std::exp(log_k), omega_radps = dispersion.omega_radps(k_radpm);
      // d dx/dx = -choppiness kx^2 / k h, and so on: T = -choppiness k h.
      const double strain = choppiness * k_radpm;
      const double part = weight * strain * strain * energy_per_log_k(spectrum, k_radpm, omega_radps);
      if (part <= 0.0) return;
      const DirectionalDensity density = spectrum.spreading_at(omega_radps);
      for (int j = 0; j < directions; ++j) {
        const double theta = 2.0 * pi * (j + 0.5) / directions;
        const double here = part * density(theta) * 2.0 * pi / directions;
        cosine += here * std::cos(2.0 * theta);
        sine += here * std::sin(2.0 * theta);
      }
      square += part;
      later += part * std::cos(omega_radps * step_s);
    });
  }
  if (square <= 0.0) return {};
  const double r2 = std::min((cosine * cosine + sine * sine) / (square * square), 1.0);
  return {.variance = square, .spread = 0.25 * (1.0 - r2), .correlation = later / square};
}

/// Share of the area where a standard Gaussian of this correlation is below `before` at one instant and above
/// `after` >= `before` at the next.
double share_that_crosses(double before, double after, double correlation) {
  const double rest = std::sqrt(std::max(1.0 - correlation * correlation, 1e-12));
  constexpr double tail = 6.0;
  double end = std::max(after, 0.0) + tail;
  if (correlation > 0.0) end = std::min(end, (before + tail * rest) / correlation);
  if (end <= after) return 0.0;
  double sum = 0.0;
  const double middle = 0.5 * (after + end);
  for (const auto& [low, high] : {std::pair{after, middle}, {middle, end}}) {
    for_each_gauss_node(low, high, [&](double z, double weight) {
      sum += weight * normal_density(z) * normal_share_below((before - correlation * z) / rest);
    });
  }
  return sum;
}

/// Share of the area whose foam is above this level, 0 ... 1.
double share_above(double level, const Compression& compression, const FoamOnset& onset,
                   const FoamInstants& instants) {
  double before = compression.threshold(onset.jacobian - onset.width * level);
  double bare = normal_share_below(before);
  for (std::int64_t j = 1; j <= instants.past_count() && bare > 0.0; ++j) {
    const double coverage = level / instants.weight(static_cast<double>(j));
    if (coverage > 1.0) break;
    const double threshold = compression.threshold(onset.jacobian - onset.width * coverage);
    const double below = normal_share_below(before);
    if (below <= 0.0) return 1.0;
    bare *= std::max(1.0 - share_that_crosses(before, threshold, compression.correlation) / below, 0.0);
    before = threshold;
  }
  return 1.0 - bare;
}

void expect_foam(const std::vector<Compression>& compressions, const FoamInstants& instants,
                 FoamOnset& onset) {
  double bare = 1.0;
  onset.cascades.clear();
  for (const Compression& compression : compressions) {
    FoamOnset::CascadeFoam& cascade = onset.cascades.emplace_back();
    cascade.survival.assign(levels, 0.0);
    cascade.deviation = std::sqrt(compression.variance);
    if (compression.variance <= 0.0) continue;
    for (int i = 0; i < levels; ++i) {
      cascade.survival[i] = share_above((i + 0.5) / levels, compression, onset, instants);
      cascade.mean += cascade.survival[i] / levels;
    }
    bare *= 1.0 - cascade.mean;
  }
  onset.fraction = 1.0 - bare;
}

/// Share of the area with more foam than this level once there is `more` times as much.
double survival_with(double more, int level, const std::vector<double>& survival) {
  const double place = (level + 0.5) / more - 0.5;
  if (place > levels - 0.5) return 0.0;
  const double within = std::clamp(place, 0.0, levels - 1.0);
  const auto below = static_cast<std::size_t>(within);
  const std::size_t above = std::min<std::size_t>(below + 1, levels - 1);
  return std::lerp(survival[below], survival[above], within - static_cast<double>(below));
}

/// Fills in factor and steepness for waves of the variance that it has.
void gather(const FoamOnset::CascadeFoam& cascade, double onset_jacobian, FoamGathering& gathering) {
  // Foam of a cascade of deviation s lies where p is larger by u v / (s (1 + v / s^2)) on average, v the
  // variance of p and u = (1 - onset) / s the threshold: exp(steepness p) shifts it by steepness v.
  const double square = cascade.deviation * cascade.deviation;
  gathering.steepness = std::max(1.0 - onset_jacobian, 0.0) / (square + gathering.variance);
  const double steepness = gathering.steepness * std::sqrt(gathering.variance);  // in deviations of p
  const auto mean_with = [&](double factor) {
    double sum = 0.0, weights = 0.0;
    for (double z = -5.0; z <= 5.0; z += 0.25) {
      const double weight = normal_density(z), more = factor * std::exp(steepness * z);
      weights += weight;
      for (int level = 0; level < levels; ++level) {
        sum += weight / levels * survival_with(more, level, cascade.survival);
      }
    }
    return sum / weights;
  };
  double low = 0.0, high = 16.0;
  for (int step = 0; step < 24; ++step) {
    const double middle = 0.5 * (low + high);
    (mean_with(middle) < cascade.mean ? low : high) = middle;
  }
  gathering.factor = 0.5 * (low + high);
}

}  // namespace

double whitecap_fraction(double wind_mps) {
  if (!(wind_mps > first_wind_mps)) return 0.0;
  const double strong = 3.84e-6 * std::pow(wind_mps, 3.41);
  const double light = 3.18e-5 * std::pow(wind_mps - first_wind_mps, 3.0);
  const double x = std::clamp((wind_mps - first_wind_mps) / (full_wind_mps - first_wind_mps), 0.0, 1.0);
  return std::min(std::lerp(light, strong, x * x * (3.0 - 2.0 * x)), most_foam);
}

double foam_choppiness(double choppiness) {
  return choppiness > 0.0 ? choppiness : 1.0;
}

FoamOnset foam_onset(const SeaSpectrum& spectrum, std::span<const Cascade> cascades, double choppiness,
                     const FoamParameters& foam, std::optional<double> loop_period_s) {
  const FoamInstants instants(foam, loop_period_s);
  const double k_most_radpm = largest_wavenumber_radpm(foam.min_wavelength_m);
  std::vector<Compression> compressions;
  double most_variance = 0.0;
  for (const Cascade& cascade : cascades) {
    compressions.push_back(
        compression_of(spectrum, cascade, foam_choppiness(choppiness), k_most_radpm, instants.step_s()));
    most_variance = std::max(most_variance, compressions.back().variance);
  }
  FoamOnset onset{.cascades = std::vector<FoamOnset::CascadeFoam>(cascades.size())};
  const double wanted = foam.fraction.value_or(0.0);
  if (most_variance <= 0.0 || (!foam.onset_jacobian && wanted <= 0.0)) return onset;
  const double deviation = std::sqrt(most_variance);
  const auto try_jacobian = [&](double jacobian) {
    onset.jacobian = jacobian;
    // What lies beyond a threshold of u standard deviations exceeds it by 1 / u of them on average.
    onset.width = foam.width.value_or(most_variance / std::max(1.0 - jacobian, deviation));
    expect_foam(compressions, instants, onset);
  };
  if (foam.onset_jacobian) {
    try_jacobian(*foam.onset_jacobian);
    return onset;
  }
  // More foam the higher the onset; halving finds it to 1e-6 of the deviation. Still water never foams.
  double low = 1.0 - 8.0 * deviation, high = 1.0;
  for (int i = 0; i < 24; ++i) {
    const double middle = 0.5 * (low + high);
    try_jacobian(middle);
    (onset.fraction < wanted ? low : high) = middle;
  }
  return onset;
}

double compression_variance(const GerstnerSea& gerstner_waves) {
  const double scale = horizontal_scale(gerstner_waves).scale;
  double variance = 0.0;
  for (const GerstnerWave& wave : gerstner_waves.waves) {
    const double strain = scale * wave.wavenumber_radpm * wave.amplitude_m;
    variance += 0.5 * strain * strain;
  }
  return variance;
}

std::vector<FoamGathering> foam_gathering(const FoamOnset& onset, const GerstnerSea& gerstner_waves,
                                          double choppiness) {
  std::vector<FoamGathering> gathering(onset.cascades.size());
  if (choppiness <= 0.0) return gathering;
  double variance = compression_variance(gerstner_waves);
  for (std::size_t i = 0; i < gathering.size(); ++i) {
    const FoamOnset::CascadeFoam& cascade = onset.cascades[i];
    gathering[i].variance = variance;
    if (cascade.mean > 0.0 && variance > 0.0) gather(cascade, onset.jacobian, gathering[i]);
    variance += cascade.deviation * cascade.deviation;
  }
  return gathering;
}

}  // namespace offing::ocean
