#include "host/ocean/spectrum/sea_statistics.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/spectrum_parameters.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

constexpr int size = 128;

/// A JONSWAP sea and the energies that its modes should have on a patch of 20 wavelengths of the peak.
struct Sea {
  SeaSpectrum spectrum;
  double patch_length_m = 0.0;
  std::vector<float> expected = std::vector<float>(size * size, 0.0f);

  explicit Sea(double direction_rad) {
    SpectrumParameters parameters;
    parameters.spreading.direction_rad = direction_rad;
    spectrum = make_sea_spectrum(parameters);
    patch_length_m = 20.0 * 2.0 * pi / spectrum.dispersion.wavenumber_radpm(spectrum.omega_peak_radps);
    const double step_radpm = 2.0 * pi / patch_length_m;
    for (int m = 1 - size / 2; m < size / 2; ++m) {
      for (int n = 1 - size / 2; n < size / 2; ++n) {
        const double k_radpm = step_radpm * std::hypot(n, m);
        if (k_radpm > 0.0 && k_radpm < band_end_radpm()) {
          const double omega_radps = spectrum.dispersion.omega_radps(k_radpm);
          const double plane_density = spectrum.density(omega_radps, std::atan2(m, n)) *
                                       spectrum.dispersion.group_speed_mps(k_radpm) / k_radpm;
          expected[((m + size) % size) * size + (n + size) % size] =
              static_cast<float>(plane_density * step_radpm * step_radpm);
        }
      }
    }
  }

  double band_end_radpm() const { return (size / 2 - 1) * 2.0 * pi / patch_length_m; }
  ModeEnergies modes(std::span<const float> energy) const { return {patch_length_m, size, energy}; }
};

// The sums over expected energies are the spectrum's integrals over the band, up to the lattice: midpoints of
// cells 1/20 of the peak's wavenumber wide, and a ragged rim of the band. Measured: heights and periods 1e-4,
// direction 3e-5 rad, slopes (which the rim carries) 8e-4; Tp 1e-3, gathered in bins of 4 % that flatten the
// peak. A transposed axis turns the direction, a wrong index sign mirrors it.
TEST(SeaStatistics, ExpectedEnergiesGiveTheSpectrum) {
  for (const double direction_rad : {0.4, 2.0, 3.9, 5.5}) {
    const Sea sea(direction_rad);
    const ModeEnergies modes = sea.modes(sea.expected);
    const SeaState found = sea_state_of(std::span(&modes, 1), sea.spectrum);
    const SeaState asked = integrate_sea_state(sea.spectrum, 0.0, sea.band_end_radpm());
    EXPECT_NEAR(found.hs_m / asked.hs_m, 1.0, 5e-4);
    EXPECT_NEAR(found.tm01_s / asked.tm01_s, 1.0, 5e-4);
    EXPECT_NEAR(found.tm02_s / asked.tm02_s, 1.0, 5e-4);
    EXPECT_NEAR(found.tp_s / asked.tp_s, 1.0, 4e-3);
    EXPECT_NEAR(found.mean_direction_rad, direction_rad, 2e-4);
    EXPECT_NEAR(found.peak_direction_rad, direction_rad, 6e-3);
    EXPECT_NEAR(found.spread_rad / asked.spread_rad, 1.0, 1e-3);
    EXPECT_NEAR(found.peak_period_s / asked.peak_period_s, 1.0, 5e-3);
    EXPECT_NEAR(found.mss / asked.mss, 1.0, 3e-3);
  }
}

// Exponential energies drawn 400 times: the scatter of Hs, Tm02, direction and peak is the predicted one. The
// standard deviation of 400 draws is known to 1 / sqrt(800) = 3.5 %, so 14 % is four sigma (false alarm 2e-4
// for the four); their mean lies within four predicted standard errors of 400 seeds, Hs after its bias of
// -Var / (8 m0^2).
TEST(SeaStatistics, ScatterIsAsPredicted) {
  const Sea sea(1.0);
  const ModeEnergies expected = sea.modes(sea.expected);
  const SeaSpectrum& spectrum = sea.spectrum;
  const SeaState asked = sea_state_of(std::span(&expected, 1), spectrum);
  const SeaStateError one = standard_error_of(std::span(&expected, 1), spectrum, 1);
  const SeaStateError many = standard_error_of(std::span(&expected, 1), spectrum, 400);
  EXPECT_NEAR(many.hs_m, one.hs_m / 20.0, 1e-12);

  std::mt19937_64 random(5);
  std::exponential_distribution<float> exponential(1.0f);
  std::vector<float> drawn(sea.expected.size());
  double sum[4] = {}, squares[4] = {};
  for (int seed = 0; seed < 400; ++seed) {
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      drawn[i] = sea.expected[i] > 0.0f ? sea.expected[i] * exponential(random) : 0.0f;
    }
    const ModeEnergies modes = sea.modes(drawn);
    const SeaState state = sea_state_of(std::span(&modes, 1), spectrum);
    const double off[4] = {state.hs_m - asked.hs_m, state.tm02_s - asked.tm02_s,
                           state.mean_direction_rad - asked.mean_direction_rad,
                           state.peak_period_s - asked.peak_period_s};
    for (int i = 0; i < 4; ++i) {
      sum[i] += off[i];
      squares[i] += off[i] * off[i];
    }
  }
  const double predicted[4] = {one.hs_m, one.tm02_s, one.mean_direction_rad, one.peak_period_s};
  for (int i = 0; i < 4; ++i) {
    const double mean = sum[i] / 400.0;
    EXPECT_NEAR(std::sqrt(squares[i] / 400.0 - mean * mean) / predicted[i], 1.0, 0.14) << i;
    const double bias = i == 0 ? -0.5 * one.hs_m * one.hs_m / asked.hs_m : 0.0;
    EXPECT_LT(std::abs(mean - bias), 4.0 * predicted[i] / 20.0) << i;
  }
}

// The header's word on snapshots: the variance of the surface at one instant scatters as the sum of
// (V(K) + V(-K))^2 / 2. Over 20000 draws of 8 pairs the variance is known to about 2 %; gate 8 %.
TEST(SeaStatistics, SnapshotsOfSymmetricSeasScatterTwiceAsMuch) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  for (const double backward : {0.0, 1.0}) {
    const double forward = 1.0;
    double sum = 0.0, squares = 0.0;
    constexpr int draws = 20000;
    for (int draw = 0; draw < draws; ++draw) {
      double variance = 0.0;
      for (int pair = 0; pair < 8; ++pair) {
        const auto amplitude = [&](double energy) {
          return 0.5 * std::sqrt(energy) * std::complex<double>(normal(random), normal(random));
        };
        variance += 2.0 * std::norm(amplitude(forward) + std::conj(amplitude(backward)));
      }
      sum += variance;
      squares += variance * variance;
    }
    const double mean = sum / draws;
    EXPECT_NEAR(mean, 8.0 * (forward + backward), 0.1);
    const double expected = 2.0 * 8.0 * 0.5 * (forward + backward) * (forward + backward);
    EXPECT_NEAR((squares / draws - mean * mean) / expected, 1.0, 0.08);
  }
}

// Two cascades are one sea; a dead calm is all zeros.
TEST(SeaStatistics, CascadesAddAndCalmIsZero) {
  const Sea sea(1.0);
  std::vector<float> low = sea.expected, high = sea.expected;
  for (int i = 0; i < size * size; ++i) {
    (i % 3 == 0 ? low : high)[i] = 0.0f;
  }
  const ModeEnergies whole = sea.modes(sea.expected);
  const ModeEnergies parts[] = {sea.modes(low), sea.modes(high)};
  const SeaSpectrum& spectrum = sea.spectrum;
  EXPECT_NEAR(sea_state_of(parts, spectrum).hs_m, sea_state_of(std::span(&whole, 1), spectrum).hs_m, 1e-9);
  EXPECT_NEAR(sea_state_of(parts, spectrum).tp_s, sea_state_of(std::span(&whole, 1), spectrum).tp_s, 1e-9);
  EXPECT_NEAR(standard_error_of(parts, spectrum, 3).tm02_s,
              standard_error_of(std::span(&whole, 1), spectrum, 3).tm02_s, 1e-9);
  const std::vector<float> calm(size * size, 0.0f);
  const ModeEnergies nothing = sea.modes(calm);
  EXPECT_EQ(sea_state_of(std::span(&nothing, 1), spectrum).tp_s, 0.0);
  EXPECT_EQ(standard_error_of(std::span(&nothing, 1), spectrum, 1).hs_m, 0.0);
}

TEST(SeaStatistics, RejectsArraysOfTheWrongSize) {
  const std::vector<float> energy(15, 1.0f);
  const ModeEnergies wrong{100.0, 4, energy};
  EXPECT_THROW(sea_state_of(std::span(&wrong, 1), {}), Error);
  const std::vector<float> square(16, 1.0f);
  const ModeEnergies no_length{0.0, 4, square};
  EXPECT_THROW(sea_state_of(std::span(&no_length, 1), {}), Error);
  const ModeEnergies right{100.0, 4, square};
  EXPECT_THROW(standard_error_of(std::span(&right, 1), {}, 0), Error);
}

// Fails if Gerstner waves are left out of a sea's figures or weighed otherwise than modes: two of 0.1 Hz and
// 0.2 Hz, A = 1 m and 2 m, alone; and that their energy, the same for every seed, adds no scatter of Hs.
TEST(SeaStatistics, GerstnerWavesAreWavesLikeOthers) {
  const auto wave = [](double frequency_hz, double amplitude_m) {
    const double omega_radps = 2.0 * pi * frequency_hz;
    return GerstnerWave{.amplitude_m = amplitude_m,
                        .wavenumber_radpm = omega_radps * omega_radps / 9.81,
                        .direction_rad = 1.0,
                        .omega_radps = omega_radps};
  };
  const std::vector<GerstnerWave> waves = {wave(0.1, 1.0), wave(0.2, 2.0)};
  const std::vector<float> calm(16, 0.0f);
  const ModeEnergies modes{100.0, 4, calm};
  const SeaState state = sea_state_of({&modes, 1}, make_sea_spectrum({}), waves);
  EXPECT_NEAR(state.m0_m2, 2.5, 1e-12);
  EXPECT_NEAR(state.hs_m, 4.0 * std::sqrt(2.5), 1e-12);
  EXPECT_NEAR(state.tm01_s, 2.5 / (0.5 * 0.1 + 2.0 * 0.2), 1e-12);
  EXPECT_NEAR(state.mean_direction_rad, 1.0, 1e-12);
  EXPECT_NEAR(state.mss,
              0.5 * std::pow(waves[0].wavenumber_radpm, 2.0) + 2.0 * std::pow(waves[1].wavenumber_radpm, 2.0),
              1e-12);
  EXPECT_EQ(standard_error_of({&modes, 1}, make_sea_spectrum({}), 1, waves).hs_m, 0.0);

  const Sea sea(0.3);
  const ModeEnergies expected = sea.modes(sea.expected);
  const double alone_m = standard_error_of({&expected, 1}, sea.spectrum, 1).hs_m;
  const double hs_m = sea_state_of({&expected, 1}, sea.spectrum).hs_m;
  const double hs_of_both_m = sea_state_of({&expected, 1}, sea.spectrum, waves).hs_m;
  EXPECT_NEAR(standard_error_of({&expected, 1}, sea.spectrum, 1, waves).hs_m, alone_m * hs_m / hs_of_both_m,
              1e-9);
}

}  // namespace
}  // namespace offing::ocean
