#include "host/ocean/surface/cascades.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocean/ocean_limits.h"
#include "host/ocean/spectrum/quadrature.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

constexpr double resolved_share = 0.999;  // of m0, by all cascades together
constexpr double peak_lengths = 20.0;     // the longest patch in wavelengths of the peak
// Long waves below a shorter peak, as swell under a wind sea: those with 1 % of the energy must fit as often
// as a Pierson-Moskowitz sea fits them in 16 wavelengths of its peak; the last 0.1 %, often noise of a buoy,
// only at all.
constexpr double long_wave_share = 0.01;
constexpr double long_wave_lengths = 8.0;
constexpr double last_share = 0.001;
constexpr double last_lengths = 2.0;
// Independent waves in the longest patch: Hs of one realisation then scatters by 2.2 %, the mean of 20 by 0.5
// %.
constexpr double effective_modes = 500.0;
constexpr double most_peak_lengths = 64.0;
constexpr double first_cascade_share =
    0.25;  // of m0: a longest patch of few samples must not hold only the tail

/// How m0 lies over the wavenumbers from `k_split` on.
class EnergyDistribution {
 public:
  EnergyDistribution(const SeaSpectrum& spectrum, double split_radpm) {
    const Dispersion& dispersion = spectrum.dispersion;
    const double low_radpm = std::max(split_radpm, dispersion.wavenumber_radpm(spectrum.omega_min_radps));
    edges_ = log_wavenumber_panels(spectrum, std::log(low_radpm),
                                   std::log(dispersion.wavenumber_radpm(spectrum.omega_max_radps)), 256);
    cumulative_.push_back(0.0);
    for (std::size_t i = 0; i + 1 < edges_.size(); ++i) {
      double variance_m2 = 0.0;
      double crowding = 0.0;
      double middle_omega_radps = dispersion.omega_radps(std::exp(0.5 * (edges_[i] + edges_[i + 1])));
      for_each_gauss_node(edges_[i], edges_[i + 1], [&](double log_k, double weight) {
        const double k_radpm = std::exp(log_k);
        const double density_m2 = energy_per_log_k(spectrum, k_radpm, dispersion.omega_radps(k_radpm));
        variance_m2 += weight * density_m2;
        crowding += weight * density_m2 * density_m2 / (k_radpm * k_radpm);
      });
      cumulative_.push_back(cumulative_.back() + variance_m2);
      if (crowding > 0.0) {
        squared_density_ += crowding * square_integral(spectrum.spreading_at(middle_omega_radps));
      }
    }
  }

  /// Wavenumber below which this share of m0 lies.
  double quantile_radpm(double share) const {
    const double wanted = share * cumulative_.back();
    const auto above = std::lower_bound(cumulative_.begin() + 1, cumulative_.end() - 1, wanted);
    const std::size_t i = above - cumulative_.begin();
    const double width = cumulative_[i] - cumulative_[i - 1];
    return std::exp(
        std::lerp(edges_[i - 1], edges_[i], width > 0.0 ? (wanted - cumulative_[i - 1]) / width : 1.0));
  }

  /// Share of m0 below this wavenumber.
  double share_below(double k_radpm) const {
    const double log_k = std::log(k_radpm);
    if (log_k <= edges_.front()) {
      return 0.0;
    }
    if (log_k >= edges_.back()) {
      return 1.0;
    }
    const std::size_t i = std::upper_bound(edges_.begin(), edges_.end(), log_k) - edges_.begin();
    const double upper = (log_k - edges_[i - 1]) / (edges_[i] - edges_[i - 1]);
    return std::lerp(cumulative_[i - 1], cumulative_[i], upper) / cumulative_.back();
  }

  /// Patch length in which the modes' energies V scatter like `count` equal ones: count = m0^2 / sum of V^2,
  /// with V = P(K) (2 pi / L)^2 and P = T / k^2, T the variance per unit ln k and direction.
  double length_with_modes_m(double count) const {
    return 2.0 * pi * std::sqrt(count * squared_density_) / cumulative_.back();
  }

 private:
  static double square_integral(const DirectionalDensity& density) {
    constexpr int count = 180;
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
      const double value = density(2.0 * pi * i / count);
      sum += value * value;
    }
    return sum * 2.0 * pi / count;
  }

  std::vector<double> edges_;       // ln k
  std::vector<double> cumulative_;  // m0 below each edge, m^2
  double squared_density_ = 0.0;    // integral of P^2 over the wavenumber plane, m^6
};

/// Rounded down to three significant digits; `steps_down` further steps of the last digit below.
double three_digits(double length_m, int steps_down = 0) {
  const double unit = std::pow(10.0, std::floor(std::log10(length_m)) - 2.0);
  const double rounded = (std::floor(length_m / unit + 1e-9) - steps_down) * unit;
  return std::round(rounded * 1e6) * 1e-6;
}

/// How far the ratio of two lengths stays from fractions with a denominator up to 8: 0 is a common multiple.
double incommensurability(double longer_m, double shorter_m) {
  double distance = 1.0;
  for (int multiple = 1; multiple <= 8; ++multiple) {
    const double ratio = multiple * longer_m / shorter_m;
    distance = std::min(distance, std::abs(ratio - std::round(ratio)));
  }
  return distance;
}

/// Three digits at most a tenth below `length_m`, whose tiles line up least with those of the longer patches.
double next_length(double length_m, const std::vector<double>& longer_m) {
  double best_m = three_digits(length_m);
  double best_distance = -1.0;
  for (int step = 0;; ++step) {
    const double candidate_m = three_digits(length_m, step);
    if (candidate_m < 0.9 * length_m) {
      return best_m;
    }
    double distance = 1.0;
    for (const double longer : longer_m) {
      distance = std::min(distance, incommensurability(longer, candidate_m));
    }
    if (distance > best_distance) {
      best_distance = distance;
      best_m = candidate_m;
    }
  }
}

/// The longest patch and shorter ones until `k_needed` is resolved, each by the same factor.
std::vector<double> patches_from(double longest_m, double k_needed_radpm, int size, int max_count) {
  // A band that begins at a low index has few waves in its first rings; small patches cannot afford eight.
  const double half = size / 2 - 1;
  const double lowest_index = std::clamp(half / 8.0, 3.0, 8.0);
  const double largest_factor = half / lowest_index;
  const double missing_factor = k_needed_radpm / resolved_wavenumber_radpm(longest_m, size);
  // A patch a fifth shorter is a small price for a cascade less.
  if (missing_factor <= 1.25) {
    return {three_digits(longest_m / std::max(missing_factor, 1.0))};
  }
  std::vector<double> lengths_m = {three_digits(longest_m)};
  if (max_count == 1) {
    return lengths_m;
  }
  const double steps =
      std::clamp(std::ceil(std::log(missing_factor) / std::log(largest_factor)), 1.0, max_count - 1.0);
  const double factor =
      std::clamp(std::pow(missing_factor, 1.0 / steps), std::min(6.0, largest_factor), largest_factor);
  for (int i = 0; i < static_cast<int>(steps); ++i) {
    lengths_m.push_back(next_length(lengths_m.back() / factor, lengths_m));
  }
  return lengths_m;
}

}  // namespace

double resolved_wavenumber_radpm(double patch_length_m, int size) {
  return (size / 2 - 1) * 2.0 * pi / patch_length_m;
}

double still_cell_variance_m2(const SeaSpectrum& spectrum, double patch_length_m, double split_radpm) {
  const double half_step_radpm = pi / patch_length_m;
  const double corner_radpm = half_step_radpm * std::numbers::sqrt2;
  // The disc inside the cell, then what its corners add, by the midpoint rule.
  double sum_m2 =
      integrate_sea_state(spectrum, std::min(split_radpm, half_step_radpm), half_step_radpm).m0_m2;
  constexpr int wavenumbers = 64, directions = 720;
  const double width_radpm = (corner_radpm - half_step_radpm) / wavenumbers;
  for (int i = 0; i < wavenumbers; ++i) {
    const double k = half_step_radpm + (i + 0.5) * width_radpm;
    if (k < split_radpm) continue;
    const double omega = spectrum.dispersion.omega_radps(k);
    const double energy = spectrum.energy(omega) * spectrum.dispersion.group_speed_mps(k) * width_radpm;
    if (energy <= 0.0) continue;
    const DirectionalDensity density = spectrum.spreading_at(omega);
    for (int j = 0; j < directions; ++j) {
      const double theta = 2.0 * pi * (j + 0.5) / directions;
      const double reach = k * std::max(std::abs(std::cos(theta)), std::abs(std::sin(theta)));
      if (reach < half_step_radpm) sum_m2 += energy * density(theta) * 2.0 * pi / directions;
    }
  }
  return sum_m2;
}

std::vector<Cascade> cascades_from_patches(std::span<const double> patch_lengths_m, int size,
                                           double split_radpm) {
  require_valid_size(size);
  require_within("split_radpm", split_radpm, 0.0, 1e6);
  if (patch_lengths_m.empty() || patch_lengths_m.size() > most_cascades) {
    throw Error(ErrorKind::bad_input,
                fmt::format("ocean.cascade: expected 1 to 4 patches, found {}", patch_lengths_m.size()),
                "give one patch length for each cascade");
  }
  std::vector<double> lengths_m(patch_lengths_m.begin(), patch_lengths_m.end());
  std::sort(lengths_m.begin(), lengths_m.end(), std::greater<>());
  std::vector<Cascade> cascades;
  double k_min_radpm = split_radpm;
  for (const double length_m : lengths_m) {
    require_within("patch_length_m", length_m, 0.01, 1e6);
    const double k_max_radpm = resolved_wavenumber_radpm(length_m, size);
    if (k_max_radpm <= split_radpm) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("patch_m: expected a patch that resolves waves shorter than the "
                              "{:.4g} m of the split, found {:g} m with waves from {:.4g} m",
                              2.0 * pi / split_radpm, length_m, 2.0 * pi / k_max_radpm),
                  fmt::format("use a patch shorter than {:.4g} m, or split at longer waves",
                              length_m * k_max_radpm / split_radpm));
    }
    if (k_max_radpm <= k_min_radpm) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("patch_m: expected different lengths, found {:g} twice", length_m),
                  "give each cascade another length");
    }
    cascades.push_back({length_m, k_min_radpm, k_max_radpm});
    k_min_radpm = k_max_radpm;
  }
  return cascades;
}

double share_in_cascades(const SeaSpectrum& spectrum, std::span<const Cascade> cascades) {
  const EnergyDistribution distribution(spectrum, 0.0);
  const double split_radpm = cascades.front().k_min_radpm;
  const double longest_radpm = std::max(split_radpm, 2.0 * pi / cascades.front().patch_length_m);
  const double in_gerstner_waves = split_radpm > 0.0 ? distribution.share_below(split_radpm) : 0.0;
  return in_gerstner_waves + distribution.share_below(cascades.back().k_max_radpm) -
         distribution.share_below(longest_radpm);
}

std::vector<Cascade> choose_cascades(const SeaSpectrum& spectrum, int size, int max_count,
                                     double split_radpm) {
  require_valid_size(size);
  if (max_count < 1 || max_count > most_cascades) {
    throw Error(ErrorKind::bad_input,
                fmt::format("ocean: expected 1 to 4 cascades at most, found {}", max_count),
                "ask for 3 cascades, for example");
  }
  const double k_highest_radpm = spectrum.dispersion.wavenumber_radpm(spectrum.omega_max_radps);
  if (!(split_radpm >= 0.0 && split_radpm < k_highest_radpm)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("ocean.split_radpm: expected a number within [0, {:g}), the wavenumbers of the "
                            "spectrum, found {:g}",
                            k_highest_radpm, split_radpm),
                "split the sea at longer waves, so that some are left to the cascades");
  }
  const EnergyDistribution distribution(spectrum, split_radpm);
  const double k_peak_radpm = spectrum.dispersion.wavenumber_radpm(spectrum.omega_peak_radps);
  const double peak_m = 2.0 * pi / std::max(split_radpm, k_peak_radpm);
  const auto wavelength_m = [&](double share) { return 2.0 * pi / distribution.quantile_radpm(share); };
  const double ample_m =
      std::max({peak_lengths * peak_m, long_wave_lengths * wavelength_m(long_wave_share),
                last_lengths * wavelength_m(last_share),
                std::min(distribution.length_with_modes_m(effective_modes), most_peak_lengths * peak_m)});
  const double longest_useful_m = (size / 2 - 1) * wavelength_m(first_cascade_share);
  const double wanted_m = std::min(ample_m, longest_useful_m);
  const double k_needed_radpm = distribution.quantile_radpm(resolved_share);

  // Few samples cannot hold both ends: the longest patch then shrinks until the most energy is in band.
  std::vector<double> best_m;
  double best_share = -1.0;
  for (double longest_m = wanted_m; longest_m > 0.05 * wanted_m; longest_m *= 0.8) {
    const std::vector<double> lengths_m = patches_from(longest_m, k_needed_radpm, size, max_count);
    const double share = distribution.share_below(resolved_wavenumber_radpm(lengths_m.back(), size)) -
                         distribution.share_below(2.0 * pi / lengths_m.front());
    if (share > best_share) {
      best_share = share;
      best_m = lengths_m;
    }
    if (share >= 0.995) {
      break;
    }
  }
  return cascades_from_patches(best_m, size, split_radpm);
}

}  // namespace offing::ocean
