#include "host/ocean/surface/gerstner_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "host/ocean/ocean_limits.h"
#include "host/ocean/spectrum/dispersion.h"
#include "host/ocean/spectrum/quadrature.h"
#include "kernels/shared/random.h"

namespace offing::ocean {
namespace {

constexpr int slice_count = 256;
constexpr int direction_count = 720;  // half degrees: a fifth of the narrowest spreading's deviation

/// A distribution over a full turn of directions: its cumulative function at the ends of equal steps, from 0
/// to 1. Places on it are in steps from the cut.
using DirectionShares = std::array<double, direction_count + 1>;

double share_below(const DirectionShares& shares, double place) {
  const int step = std::clamp(static_cast<int>(place), 0, direction_count - 1);
  return std::lerp(shares[step], shares[step + 1], place - step);
}

double place_of(const DirectionShares& shares, double share) {
  const auto above = std::upper_bound(shares.begin() + 1, shares.end() - 1, share);
  const auto step = above - shares.begin() - 1;
  const double width = shares[step + 1] - shares[step];
  const double part = width > 0.0 ? (share - shares[step]) / width : 0.0;
  return static_cast<double>(step) + std::clamp(part, 0.0, 1.0);
}

/// Waves of so little a range of k that they share one distribution over directions.
struct Slice {
  double log_k_low = 0.0, log_k_high = 0.0;
  double below_m2 = 0.0;   // variance of all slices before
  double within_m2 = 0.0;  // and of this one
  DirectionShares shares;

  /// The variance of this slice that lies between two cumulative variances.
  double part_m2(double from_m2, double to_m2) const {
    return std::max(0.0, std::min(to_m2, below_m2 + within_m2) - std::max(from_m2, below_m2));
  }
};

DirectionShares direction_shares(const DirectionalDensity& density, double cut_rad) {
  DirectionShares shares{};
  for (int i = 0; i < direction_count; ++i) {
    shares[i + 1] = shares[i] + density(cut_rad + two_pi * (i + 0.5) / direction_count);
  }
  const double total = shares.back();
  for (int i = 0; i <= direction_count; ++i) {
    shares[i] = total > 0.0 ? shares[i] / total : static_cast<double>(i) / direction_count;
  }
  return shares;
}

/// The waves below k_split, from long to short, without the slices that hold none.
std::vector<Slice> slices_below(const SeaSpectrum& spectrum, double split_radpm, double cut_rad) {
  const Dispersion& dispersion = spectrum.dispersion;
  const double low_radpm = dispersion.wavenumber_radpm(spectrum.omega_min_radps);
  const double high_radpm = std::min(split_radpm, dispersion.wavenumber_radpm(spectrum.omega_max_radps));
  std::vector<Slice> slices;
  if (low_radpm >= high_radpm) return slices;
  const std::vector<double> edges =
      log_wavenumber_panels(spectrum, std::log(low_radpm), std::log(high_radpm), slice_count);
  double below_m2 = 0.0;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    double within_m2 = 0.0;
    for_each_gauss_node(edges[i], edges[i + 1], [&](double log_k, double weight) {
      const double k_radpm = std::exp(log_k);
      within_m2 += weight * energy_per_log_k(spectrum, k_radpm, dispersion.omega_radps(k_radpm));
    });
    if (within_m2 <= 0.0) continue;
    const double middle_radps = dispersion.omega_radps(std::exp(0.5 * (edges[i] + edges[i + 1])));
    slices.push_back({edges[i], edges[i + 1], below_m2, within_m2,
                      direction_shares(spectrum.spreading_at(middle_radps), cut_rad)});
    below_m2 += within_m2;
  }
  return slices;
}

/// A band of frequencies: what lies between two cumulative variances.
struct Band {
  double from_m2 = 0.0, to_m2 = 0.0;
};

/// Distribution over directions of a band.
DirectionShares band_shares(const std::vector<Slice>& slices, const Band& band) {
  DirectionShares shares{};
  for (const Slice& slice : slices) {
    const double weight = slice.part_m2(band.from_m2, band.to_m2) / (band.to_m2 - band.from_m2);
    if (weight <= 0.0) continue;
    for (std::size_t i = 0; i < shares.size(); ++i) shares[i] += weight * slice.shares[i];
  }
  return shares;
}

/// A wave's place in the spectrum.
struct Place {
  double log_k = 0.0;
  double direction_steps = 0.0;  // from the cut
};

/// Draws from the waves of a band between two places on its directions, each as likely as its energy asks.
Place draw_place(const std::vector<Slice>& slices, const Band& band, double from_place, double to_place,
                 const std::array<double, 2>& uniform) {
  const auto weight_of = [&](const Slice& slice) {
    return slice.part_m2(band.from_m2, band.to_m2) *
           (share_below(slice.shares, to_place) - share_below(slice.shares, from_place));
  };
  double total = 0.0;
  const Slice* chosen = nullptr;
  for (const Slice& slice : slices) {
    const double weight = weight_of(slice);
    total += weight;
    if (weight > 0.0) chosen = &slice;  // the last one, should rounding leave the sum below what is wanted
  }
  double remaining = uniform[0] * total;
  double part = 1.0;  // of the chosen slice's part in the band
  for (const Slice& slice : slices) {
    const double weight = weight_of(slice);
    if (weight > 0.0 && remaining < weight) {
      chosen = &slice;
      part = remaining / weight;
      break;
    }
    remaining -= weight;
  }
  const double start_m2 = std::max(band.from_m2, chosen->below_m2) - chosen->below_m2;
  const double in_slice = (start_m2 + part * chosen->part_m2(band.from_m2, band.to_m2)) / chosen->within_m2;
  const double share =
      std::lerp(share_below(chosen->shares, from_place), share_below(chosen->shares, to_place), uniform[1]);
  return {std::lerp(chosen->log_k_low, chosen->log_k_high, in_slice), place_of(chosen->shares, share)};
}

}  // namespace

double split_at_wavelength_radpm(double wavelength_m) {
  require_within("split wavelength_m", wavelength_m, 0.1, 1e6);
  return two_pi / wavelength_m;
}

std::vector<GerstnerWave> choose_gerstner_waves(const SeaSpectrum& spectrum, const GerstnerChoice& choice) {
  require_within("gerstner.count", choice.count, 1, 64);
  require_within("gerstner.split_radpm", choice.split_radpm, 0.0, 1e3);
  const SeaState long_waves = integrate_sea_state(spectrum, 0.0, choice.split_radpm);
  // Directions are cut opposite to the mean, so that bins rarely lie across the cut.
  const double cut_rad = long_waves.mean_direction_rad - std::numbers::pi;
  const std::vector<Slice> slices = slices_below(spectrum, choice.split_radpm, cut_rad);
  if (slices.empty()) return {};
  const double total_m2 = slices.back().below_m2 + slices.back().within_m2;
  const double amplitude_m = std::sqrt(2.0 * long_waves.m0_m2 / choice.count);
  const int band_count = static_cast<int>(std::ceil(std::sqrt(choice.count)));
  std::vector<GerstnerWave> waves;
  for (int b = 0; b < band_count; ++b) {
    // Bands of as many bins as others or one more, and of energy to match: every bin holds the same.
    const int first = b * choice.count / band_count, last = (b + 1) * choice.count / band_count;
    const Band band{total_m2 * first / choice.count, total_m2 * last / choice.count};
    const DirectionShares shares = band_shares(slices, band);
    for (int bin = first; bin < last; ++bin) {
      const double bins = last - first;
      const double from_place = place_of(shares, (bin - first) / bins);
      const double to_place = place_of(shares, (bin + 1 - first) / bins);
      const PhiloxBlock random =
          philox_block(static_cast<std::uint32_t>(choice.seed), static_cast<std::uint32_t>(choice.seed >> 32),
                       OFFING_STREAM_OCEAN_GERSTNER, bin, 0, 0);
      const Place place = draw_place(slices, band, from_place, to_place,
                                     {uniform_open01(random.v[0]), uniform_open01(random.v[1])});
      const double wavenumber_radpm = std::exp(place.log_k);
      waves.push_back({.amplitude_m = amplitude_m,
                       .wavenumber_radpm = wavenumber_radpm,
                       .direction_rad = cut_rad + two_pi * place.direction_steps / direction_count,
                       .omega_radps = spectrum.dispersion.omega_radps(wavenumber_radpm),
                       .phase_rad = two_pi * uniform_open01(random.v[2])});
    }
  }
  return waves;
}

}  // namespace offing::ocean
