// Gerstner waves drawn from a spectrum: their energy, directions and frequencies against the spectrum's own
// integrals.
#include "host/ocean/surface/gerstner_choice.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "tests/ocean/example_seas.h"
#include "tests/ocl/expect_error.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

double peak_radpm(const SeaSpectrum& spectrum) {
  return spectrum.dispersion.wavenumber_radpm(spectrum.omega_peak_radps);
}

double variance_m2(const std::vector<GerstnerWave>& waves) {
  double sum = 0.0;
  for (const GerstnerWave& wave : waves) sum += 0.5 * wave.amplitude_m * wave.amplitude_m;
  return sum;
}

// Fails if energy is lost or made, whatever the spectrum's width, kinks and directions, and however few waves
// carry it. All waves are alike, so that rounding alone remains: 64 u. Gate 1e-12.
TEST(GerstnerChoice, WavesAddUpToTheLongWaves) {
  for (const ExampleSea& sea : example_seas()) {
    for (const double split : {0.8, 1.5, 1e3}) {
      const double split_radpm = std::min(split * peak_radpm(sea.spectrum), 1e3);
      const double asked_m2 = integrate_sea_state(sea.spectrum, 0.0, split_radpm).m0_m2;
      for (const int count : {1, 7, 16, 64}) {
        const auto waves =
            choose_gerstner_waves(sea.spectrum, {.split_radpm = split_radpm, .count = count, .seed = 5});
        if (asked_m2 == 0.0) {
          EXPECT_TRUE(waves.empty()) << sea.name;
          continue;
        }
        EXPECT_EQ(waves.size(), static_cast<std::size_t>(count)) << sea.name;
        EXPECT_NEAR(variance_m2(waves) / asked_m2, 1.0, 1e-12) << sea.name << ", split " << split;
      }
    }
  }
}

// Fails if a wave is taken from beyond the split, where the cascades have it already, or moves unlike water.
TEST(GerstnerChoice, EveryWaveIsOneOfTheLongWaves) {
  for (const ExampleSea& sea : example_seas()) {
    const Dispersion& dispersion = sea.spectrum.dispersion;
    const double split_radpm = 1.7 * peak_radpm(sea.spectrum);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      for (const GerstnerWave& wave :
           choose_gerstner_waves(sea.spectrum, {.split_radpm = split_radpm, .count = 32, .seed = seed})) {
        EXPECT_LT(wave.wavenumber_radpm, split_radpm) << sea.name;
        EXPECT_GE(wave.wavenumber_radpm,
                  dispersion.wavenumber_radpm(sea.spectrum.omega_min_radps) * (1.0 - 1e-9));
        EXPECT_EQ(wave.omega_radps, dispersion.omega_radps(wave.wavenumber_radpm)) << sea.name;
        EXPECT_GE(wave.phase_rad, 0.0);
        EXPECT_LT(wave.phase_rad, 2.0 * pi);
        EXPECT_GT(sea.spectrum.density(wave.omega_radps, wave.direction_rad), 0.0) << sea.name;
      }
    }
  }
}

// What the waves of a spectrum below the split share out, by the midpoint rule on the plane of frequencies
// and directions: nothing of the choice's own code.
struct Shares {
  double below_mean_frequency = 0.0;  // of the energy: frequency below the mean
  std::complex<double> direction;     // mean of e^{i theta}
  std::complex<double> twice;         // mean of e^{2 i theta}
  double slope = 0.0;                 // mean of k^2 over the split's
};

Shares asked_shares(const SeaSpectrum& spectrum, double split_radpm, double middle_radps) {
  constexpr int frequencies = 3000, directions = 180;
  const double low = spectrum.omega_min_radps, high = spectrum.dispersion.omega_radps(split_radpm);
  Shares shares;
  double total = 0.0;
  for (int i = 0; i < frequencies; ++i) {
    const double omega = low + (high - low) * (i + 0.5) / frequencies;
    const double energy = spectrum.energy(omega);
    if (energy <= 0.0) continue;
    const DirectionalDensity density = spectrum.spreading_at(omega);
    const double k = spectrum.dispersion.wavenumber_radpm(omega) / split_radpm;
    total += energy;
    shares.slope += energy * k * k;
    if (omega < middle_radps) shares.below_mean_frequency += energy;
    for (int j = 0; j < directions; ++j) {
      const double theta = 2.0 * pi * (j + 0.5) / directions;
      const double part = energy * density(theta) * 2.0 * pi / directions;
      shares.direction += std::polar(part, theta);
      shares.twice += std::polar(part, 2.0 * theta);
    }
  }
  shares.below_mean_frequency /= total;
  shares.direction /= total;
  shares.twice /= total;
  shares.slope /= total;
  return shares;
}

// Fails if waves are drawn by another density than the spectrum's: shifted bins, directions of the wrong
// frequency, a bin's middle in place of a draw. Means over 20 seeds of 64 waves. Of independent draws of a
// value within [-1, 1] a mean scatters by 1/sqrt(1280) = 0.028 at most; these share 8 bands of 8 directions,
// so that each varies within its bin alone, and the mean by a quarter of that or less. Gate four of them,
// 0.03 (false alarm below 1e-3 for all figures of all seas, were seeds not fixed).
TEST(GerstnerChoice, MeanOverSeedsIsTheSpectrum) {
  double worst = 0.0;
  for (const ExampleSea& sea : example_seas()) {
    const double split_radpm = 2.0 * peak_radpm(sea.spectrum);
    const double middle_radps = 1.1 * sea.spectrum.omega_peak_radps;
    const Shares asked = asked_shares(sea.spectrum, split_radpm, middle_radps);
    Shares found;
    constexpr int seeds = 20, count = 64;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      for (const GerstnerWave& wave :
           choose_gerstner_waves(sea.spectrum, {.split_radpm = split_radpm, .count = count, .seed = seed})) {
        constexpr double part = 1.0 / (seeds * count);
        found.slope += part * std::pow(wave.wavenumber_radpm / split_radpm, 2.0);
        if (wave.omega_radps < middle_radps) found.below_mean_frequency += part;
        found.direction += std::polar(part, wave.direction_rad);
        found.twice += std::polar(part, 2.0 * wave.direction_rad);
      }
    }
    const auto expect = [&](const char* name, double difference) {
      EXPECT_LT(std::abs(difference), 0.03) << name << " of " << sea.name;
      worst = std::max(worst, std::abs(difference));
    };
    expect("frequency", found.below_mean_frequency - asked.below_mean_frequency);
    expect("direction", std::abs(found.direction - asked.direction));
    expect("spreading", std::abs(found.twice - asked.twice));
    expect("slope", found.slope - asked.slope);
  }
  RecordProperty("worst", std::to_string(worst));
}

// Fails if a seed's sea changes from run to run, or if seeds share waves.
TEST(GerstnerChoice, SeedsPickTheWaves) {
  const SeaSpectrum spectrum = example_seas().front().spectrum;
  const GerstnerChoice choice{.split_radpm = 2.0 * peak_radpm(spectrum), .count = 16, .seed = 7};
  const auto first = choose_gerstner_waves(spectrum, choice), again = choose_gerstner_waves(spectrum, choice);
  GerstnerChoice other_choice = choice;
  other_choice.seed += std::uint64_t{1} << 32;  // the key's upper word
  const auto other = choose_gerstner_waves(spectrum, other_choice);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].wavenumber_radpm, again[i].wavenumber_radpm);
    EXPECT_EQ(first[i].direction_rad, again[i].direction_rad);
    EXPECT_EQ(first[i].phase_rad, again[i].phase_rad);
    EXPECT_NE(first[i].wavenumber_radpm, other[i].wavenumber_radpm);
    EXPECT_NE(first[i].phase_rad, other[i].phase_rad);
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(first[i].phase_rad, first[j].phase_rad);
  }
}

TEST(GerstnerChoice, SplitIsAWavelength) {
  EXPECT_DOUBLE_EQ(split_at_wavelength_radpm(50.0), 2.0 * pi / 50.0);
  for (const double wavelength_m : {0.0, -1.0, 2e6, std::numeric_limits<double>::quiet_NaN()}) {
    test::expect_error(ErrorKind::bad_input, "split wavelength_m",
                       [&] { split_at_wavelength_radpm(wavelength_m); });
  }
}

TEST(GerstnerChoice, RejectsWhatCannotBeChosen) {
  const SeaSpectrum spectrum = example_seas().front().spectrum;
  const auto expect_rejected = [&](const GerstnerChoice& choice, const std::string& name) {
    test::expect_error(ErrorKind::bad_input, name, [&] { choose_gerstner_waves(spectrum, choice); });
  };
  expect_rejected({.split_radpm = 0.1, .count = 0}, "gerstner.count");
  expect_rejected({.split_radpm = 0.1, .count = 65}, "gerstner.count");
  expect_rejected({.split_radpm = -0.1}, "gerstner.split_radpm");
  expect_rejected({.split_radpm = std::numeric_limits<double>::quiet_NaN()}, "gerstner.split_radpm");
  EXPECT_TRUE(choose_gerstner_waves(spectrum, {.split_radpm = 0.0}).empty());
}

}  // namespace
}  // namespace offing::ocean
