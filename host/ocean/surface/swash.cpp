#include "host/ocean/surface/swash.h"

#include <algorithm>
#include <cmath>

#include "kernels/shared/random.h"

namespace offing::ocean {
namespace {

constexpr std::size_t incoming = 6;
// Peak period over the mean period of energy, T(-1,0), of common spectra (EurOtop 2018).
constexpr double peak_of_mean = 1.1;
// Mean square of cos(u + s cos u): (1 - J2(2 s)) / 2 with s = SWASH_SKEW.
constexpr double mean_square = 0.4426;
// Refraction turns waves toward the shore: less of their wavenumber is left along it.
constexpr double along_shore = 0.5;
// Slopes that Stockdon et al. measured.
constexpr double flattest = 0.01, steepest = 0.16;

}  // namespace

Swash::Swash(const Dispersion& sea, const SeaBands& bands, double beach_slope, double direction_rad,
             std::uint64_t seed) {
  double variance_m2 = 0.0, moment = 0.0;
  for (const ShoalingBand& band : bands.bands) {
    if (band.variance_m2 <= 0.0) continue;
    variance_m2 += band.variance_m2;
    moment += band.variance_m2 * two_pi / sea.omega_radps(band.wavenumber_radpm);
  }
  if (variance_m2 <= 0.0) return;
  const double height_m = 4.0 * std::sqrt(variance_m2);
  period_s_ = peak_of_mean * moment / variance_m2;
  const double length_m = sea.gravity_mps2 * period_s_ * period_s_ / two_pi;
  const double slope = std::clamp(beach_slope, flattest, steepest), root_m = std::sqrt(height_m * length_m);
  const double of_waves_m = 0.75 * slope * root_m, of_beat_m = 0.06 * root_m;
  sea_ = {.height_m = height_m, .wavenumber_radpm = two_pi / length_m, .direction_rad = direction_rad};
  setup_m_ = 0.35 * slope * root_m;
  reach_m_ = 1.1 * (setup_m_ + 0.5 * std::hypot(of_waves_m, of_beat_m));

  std::array<double, SWASH_WAVES> shares{};
  double sums[2] = {};
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const PhiloxBlock random =
        philox_block(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                     OFFING_STREAM_OCEAN_SWASH, static_cast<std::uint32_t>(i), 0, 0);
    const double of_frequency = uniform_open01(random.v[0]), aside = uniform_open01(random.v[1]) - 0.5;
    const bool is_incoming = i < incoming;
    // Frequencies 0.75 ... 1.25 of the peak's, most in the middle; beats some five times slower.
    const double place = (static_cast<double>(i) + of_frequency) / incoming;
    const double omega_radps =
        two_pi / period_s_ * (is_incoming ? 0.75 + 0.5 * place : (i == incoming ? 0.22 : 0.13));
    const double deep_radpm = omega_radps * omega_radps / sea.gravity_mps2;
    // Beats are edge waves (Eckart 1951), which run along the shore.
    const double k_radpm = is_incoming ? along_shore * deep_radpm : deep_radpm / slope;
    const double angle_rad = direction_rad + (is_incoming ? 1.0 : 3.0) * aside;
    shares[i] = is_incoming ? 1.0 - std::abs(place - 0.5) : 1.0;
    sums[is_incoming ? 0 : 1] += shares[i] * shares[i];
    waves_[i] = {.amplitude_m = 0.0,
                 .kx_radpm = k_radpm * std::cos(angle_rad),
                 .kz_radpm = k_radpm * std::sin(angle_rad),
                 .omega_radps = omega_radps,
                 .phase_rad = two_pi * uniform_open01(random.v[2])};
  }
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const bool is_incoming = i < incoming;
    // A quarter of the significant height is the deviation.
    const double deviation_m = 0.25 * (is_incoming ? of_waves_m : of_beat_m);
    waves_[i].amplitude_m = deviation_m * shares[i] / std::sqrt(mean_square * sums[is_incoming ? 0 : 1]);
  }
}

double Swash::farthest_m() const {
  double sum_m = setup_m_;
  for (const Wave& wave : waves_) sum_m += wave.amplitude_m;
  return sum_m;
}

double Swash::level_m(double x_m, double z_m, double time_s) const {
  double level_m = setup_m_;
  for (const Wave& wave : waves_) {
    const double u = turn(wave, x_m, z_m, time_s);
    level_m += wave.amplitude_m * std::cos(u + static_cast<double>(SWASH_SKEW) * std::cos(u));
  }
  return level_m;
}

SwashParams Swash::at(double x_m, double z_m, double time_s) const {
  SwashParams params{};
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const Wave& wave = waves_[i];
    params.kx_radpm[i] = static_cast<float>(wave.kx_radpm);
    params.kz_radpm[i] = static_cast<float>(wave.kz_radpm);
    params.amplitude_m[i] = static_cast<float>(wave.amplitude_m);
    params.omega_radps[i] = static_cast<float>(wave.omega_radps);
    params.phase_rad[i] = static_cast<float>(std::remainder(turn(wave, x_m, z_m, time_s), two_pi));
  }
  params.setup_m = static_cast<float>(setup_m_);
  params.reach_m = static_cast<float>(reach_m_);
  params.period_s = static_cast<float>(period_s_);
  return params;
}

}  // namespace offing::ocean
