#include "host/ocean/query/shoaling.h"

#include <algorithm>
#include <cmath>

#include "host/base/parameter_check.h"
#include "host/ocean/ocean_limits.h"

namespace offing::ocean {
namespace {

constexpr std::size_t gerstner_bands = SHOAL_BANDS - SHOAL_FIRST_GERSTNER;
// How sharply the height turns from shoaling to breaking: the larger, the nearer to the lesser of both.
constexpr double sharpness = 4.0;
// Where the depth is a wavelength, heights are those of deep water to 4 pi e^(-4 pi), 4e-5; where it is 10
// significant heights, breaking takes (0.1 / 0.59)^4 / 4, 2e-4.
constexpr double deep_wavelengths = 1.0, deep_heights = 10.0;

double significant_height_m(std::span<const ShoalingBand> bands) {
  double variance_m2 = 0.0;
  for (const ShoalingBand& band : bands) variance_m2 += band.variance_m2;
  return 4.0 * std::sqrt(variance_m2);
}

double deepest_of(const Dispersion& sea, std::span<const ShoalingBand> bands) {
  double depth_m = deep_heights * significant_height_m(bands);
  for (const ShoalingBand& band : bands) {
    if (band.variance_m2 > 0.0) {
      depth_m = std::max(depth_m, deep_wavelengths * two_pi / band.wavenumber_radpm);
    }
  }
  return std::clamp(depth_m, 1e-3, std::min(sea.depth_m, offing::deepest_m));
}

/// Heights over those of the open sea, without the part of breaking that is in these.
std::array<double, SHOAL_BANDS> shares_at(const Dispersion& sea, std::span<const ShoalingBand> bands,
                                          double depth_m) {
  std::array<double, SHOAL_BANDS> shares{};
  if (depth_m <= 0.0) return shares;
  double variance_m2 = 0.0;
  for (std::size_t i = 0; i < SHOAL_BANDS; ++i) {
    shares[i] =
        bands[i].variance_m2 > 0.0 ? shoaling_coefficient(sea, bands[i].wavenumber_radpm, depth_m) : 1.0;
    variance_m2 += bands[i].variance_m2 * shares[i] * shares[i];
  }
  const double excess = 4.0 * std::sqrt(variance_m2) / (breaking_share * depth_m);
  // Of large ratios the 1 does not count: their powers would not be finite.
  const double left =
      excess > 1e6 ? 1.0 / excess : std::pow(1.0 + std::pow(excess, sharpness), -1.0 / sharpness);
  for (double& share : shares) share *= left;
  return shares;
}

}  // namespace

int SeaBands::gerstner_band(double wavenumber_radpm) const {
  int band = 0;
  for (const double edge_radpm : edges_radpm) band += wavenumber_radpm >= edge_radpm ? 1 : 0;
  return band;
}

ShoalingBand band_of_modes(std::span<const float> variance_m2, int size, double patch_length_m) {
  require_valid_size(size);
  require_within("patch_length_m", patch_length_m, 0.01, 1e6);
  const auto n = static_cast<std::size_t>(size);
  require_within("mode variance count", static_cast<double>(variance_m2.size()), static_cast<double>(n * n),
                 static_cast<double>(n * n));
  ShoalingBand band;
  double moment = 0.0;
  for (std::size_t i = 0; i < n * n; ++i) {
    const auto signed_index = [&](std::size_t k) {
      return k < n / 2 ? static_cast<double>(k) : static_cast<double>(k) - size;
    };
    band.variance_m2 += variance_m2[i];
    moment += variance_m2[i] * std::hypot(signed_index(i / n), signed_index(i % n));
  }
  if (band.variance_m2 > 0.0) band.wavenumber_radpm = two_pi / patch_length_m * moment / band.variance_m2;
  return band;
}

SeaBands shoaling_bands(std::span<const ShoalingBand> cascades,
                        std::span<const GerstnerWave> gerstner_waves) {
  require_within("cascade count", static_cast<double>(cascades.size()), 0.0, SHOAL_FIRST_GERSTNER);
  SeaBands result;
  std::copy(cascades.begin(), cascades.end(), result.bands.begin());
  if (gerstner_waves.empty()) return result;
  std::vector<double> wavenumbers_radpm;
  for (const GerstnerWave& wave : gerstner_waves) wavenumbers_radpm.push_back(wave.wavenumber_radpm);
  std::sort(wavenumbers_radpm.begin(), wavenumbers_radpm.end());
  const double first = wavenumbers_radpm.front(), last = wavenumbers_radpm.back();
  for (std::size_t i = 0; i < result.edges_radpm.size(); ++i) {
    const double even = first * std::pow(last / first, static_cast<double>(i + 1) / gerstner_bands);
    // Between two waves, so that rounding of one does not move it to another band.
    const auto above = std::lower_bound(wavenumbers_radpm.begin(), wavenumbers_radpm.end(), even);
    const bool is_between = above != wavenumbers_radpm.begin() && above != wavenumbers_radpm.end();
    result.edges_radpm[i] = is_between ? std::sqrt(*above * *(above - 1)) : 2.0 * last;
  }
  std::array<double, gerstner_bands> moments{};
  for (const GerstnerWave& wave : gerstner_waves) {
    const auto index = static_cast<std::size_t>(result.gerstner_band(wave.wavenumber_radpm));
    const double variance_m2 = 0.5 * wave.amplitude_m * wave.amplitude_m;
    result.bands[SHOAL_FIRST_GERSTNER + index].variance_m2 += variance_m2;
    moments[index] += variance_m2 * wave.wavenumber_radpm;
  }
  for (std::size_t i = 0; i < gerstner_bands; ++i) {
    ShoalingBand& band = result.bands[SHOAL_FIRST_GERSTNER + i];
    if (band.variance_m2 > 0.0) band.wavenumber_radpm = moments[i] / band.variance_m2;
  }
  return result;
}

double shoaling_coefficient(const Dispersion& sea, double wavenumber_radpm, double depth_m) {
  Dispersion there = sea;
  there.depth_m = depth_m;
  const double k_radpm = there.wavenumber_radpm(sea.omega_radps(wavenumber_radpm));
  return std::sqrt(sea.group_speed_mps(wavenumber_radpm) / there.group_speed_mps(k_radpm));
}

ShoalTable::ShoalTable(const Dispersion& sea, const SeaBands& bands) : bands_(bands) {
  for (const ShoalingBand& band : bands.bands) {
    require_within("band variance_m2", band.variance_m2, 0.0, 1e6);
    if (band.variance_m2 > 0.0) require_within("band wavenumber_radpm", band.wavenumber_radpm, 1e-6, 1e6);
  }
  deepest_m_ = deepest_of(sea, bands.bands);
  // A sea that breaks at its own depth is given as it is there.
  const std::array<double, SHOAL_BANDS> open = shares_at(sea, bands.bands, deepest_m_);
  for (int step = 0; step < SHOAL_STEPS; ++step) {
    const double root = static_cast<double>(step) / (SHOAL_STEPS - 1);
    const std::array<double, SHOAL_BANDS> there = shares_at(sea, bands.bands, deepest_m_ * root * root);
    for (std::size_t i = 0; i < SHOAL_BANDS; ++i) shares_.push_back(static_cast<float>(there[i] / open[i]));
  }
  largest_share_ = *std::max_element(shares_.begin(), shares_.end());
}

std::array<double, SHOAL_BANDS> ShoalTable::at(double depth_m) const {
  const double root = std::sqrt(std::clamp(depth_m / deepest_m_, 0.0, 1.0));
  const double place = root * (SHOAL_STEPS - 1);
  const int below = std::min(static_cast<int>(place), SHOAL_STEPS - 2);
  const double u = place - below;
  std::array<double, SHOAL_BANDS> shares{};
  for (std::size_t i = 0; i < SHOAL_BANDS; ++i) {
    const std::size_t row = static_cast<std::size_t>(below) * SHOAL_BANDS + i;
    shares[i] = (1.0 - u) * shares_[row] + u * shares_[row + SHOAL_BANDS];
  }
  return shares;
}

}  // namespace offing::ocean
