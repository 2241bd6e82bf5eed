#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/spectrum_parameters.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

/// A record as rough as a buoy's: uneven frequencies, scattered energies with holes, one or two directions
/// each.
WaveSpectrum scattered_record(int seed, int direction_count, double first_direction_rad) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  WaveSpectrum record;
  double frequency_hz = 0.03;
  while (frequency_hz < 0.5) {
    record.frequencies_hz.push_back(frequency_hz);
    record.energy.push_back(unit(random) < 0.3 ? 0.0 : std::pow(unit(random), 4.0) * 10.0);
    frequency_hz += 0.003 + 0.02 * unit(random);
  }
  for (int i = 0; i < direction_count; ++i) {
    record.directions_rad.push_back(first_direction_rad + 2.0 * pi * i / direction_count);
  }
  for (std::size_t i = 0; i < record.energy.size() && direction_count > 0; ++i) {
    std::vector<double> row(direction_count);
    double sum = 0.0;
    for (double& value : row) {
      value = std::pow(unit(random), 6.0);
      sum += value;
    }
    for (const double value : row) {
      // A reader may leave rows without energy at zero.
      record.spreading.push_back(record.energy[i] > 0.0 ? value / sum * direction_count / (2.0 * pi) : 0.0);
    }
  }
  return record;
}

// m0 and the mean direction are trapezoidal sums over the file's grid, as whoever wrote the file computes
// them. Fails if D were interpolated apart from E (percents of a radian), or a zero row diluted its
// neighbours. Bounds: Gauss nodes between kinks are exact for m0 (measured 2e-15); one-degree steps leave
// 2e-8 of the direction's first moment where they miss the kinks of ten-degree ones. Gates 1e-9 and 1e-6.
TEST(MeasuredSpectrum, KeepsTheFilesEnergyAndDirection) {
  for (int seed = 0; seed < 10; ++seed) {
    const WaveSpectrum record = scattered_record(seed, 36, 0.0873 * seed);
    const SeaState state = integrate_sea_state(from_measured(record, {}, {}));
    EXPECT_NEAR(state.m0_m2 / variance_m2(record), 1.0, 1e-9);

    double cosine = 0.0, sine = 0.0;
    for (std::size_t i = 0; i < record.energy.size(); ++i) {
      const double below_hz = i == 0 ? 0.0 : record.frequencies_hz[i] - record.frequencies_hz[i - 1];
      const double above_hz =
          i + 1 == record.energy.size() ? 0.0 : record.frequencies_hz[i + 1] - record.frequencies_hz[i];
      for (std::size_t j = 0; j < 36; ++j) {
        const double energy = record.energy[i] * 0.5 * (below_hz + above_hz) * record.spreading[i * 36 + j];
        cosine += energy * std::cos(record.directions_rad[j]);
        sine += energy * std::sin(record.directions_rad[j]);
      }
    }
    EXPECT_NEAR(std::remainder(state.mean_direction_rad - std::atan2(sine, cosine), 2.0 * pi), 0.0, 1e-6);
  }
}

// Between listed frequencies E is linear, so f^n E is a polynomial: Simpson's rule is exact for n <= 2.
TEST(MeasuredSpectrum, PeriodsMatchExactIntegrals) {
  const WaveSpectrum record = scattered_record(11, 0, 0.0);
  double m1 = 0.0, m2 = 0.0;
  for (std::size_t i = 1; i < record.energy.size(); ++i) {
    const double f0 = record.frequencies_hz[i - 1], f1 = record.frequencies_hz[i], middle = 0.5 * (f0 + f1);
    const double e0 = record.energy[i - 1], e1 = record.energy[i], e = 0.5 * (e0 + e1);
    m1 += (f1 - f0) / 6.0 * (f0 * e0 + 4.0 * middle * e + f1 * e1);
    m2 += (f1 - f0) / 6.0 * (f0 * f0 * e0 + 4.0 * middle * middle * e + f1 * f1 * e1);
  }
  const double m0 = variance_m2(record);
  for (const double depth_m : {8.0, std::numeric_limits<double>::infinity()}) {
    const SeaState state = integrate_sea_state(from_measured(record, {}, Dispersion{.depth_m = depth_m}));
    EXPECT_NEAR(state.hs_m / (4.0 * std::sqrt(m0)), 1.0, 1e-6);
    EXPECT_NEAR(state.tm01_s / (m0 / m1), 1.0, 1e-6);
    EXPECT_NEAR(state.tm02_s / std::sqrt(m0 / m2), 1.0, 1e-6);
  }
}

TEST(MeasuredSpectrum, IsLinearBetweenAndZeroBeyond) {
  WaveSpectrum record;
  record.frequencies_hz = {0.1, 0.2, 0.4};
  record.energy = {1.0, 3.0, 2.0};
  const SeaSpectrum spectrum = from_measured(record, {}, {});
  const auto energy_at = [&](double frequency_hz) {
    return 2.0 * pi * spectrum.energy(2.0 * pi * frequency_hz);
  };
  EXPECT_NEAR(energy_at(0.15), 2.0, 1e-12);
  EXPECT_NEAR(energy_at(0.3), 2.5, 1e-12);
  EXPECT_EQ(energy_at(0.0999), 0.0);
  EXPECT_EQ(energy_at(0.4001), 0.0);
  EXPECT_NEAR(spectrum.omega_peak_radps, 2.0 * pi * 0.2, 1e-12);
}

// Four directions that start anywhere; across the seam of the turn the density is linear like elsewhere, and
// halfway between two frequencies S (not D) is the mean.
TEST(MeasuredSpectrum, SpreadingIsBilinearAndPeriodic) {
  WaveSpectrum record;
  record.frequencies_hz = {0.1, 0.2};
  record.energy = {1.0, 3.0};
  for (int i = 0; i < 4; ++i) {
    record.directions_rad.push_back(-2.0 + 0.5 * pi * i);
  }
  const double full = 2.0 / pi;
  record.spreading = {full, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, full};
  const SeaSpectrum spectrum = from_measured(record, {}, {});
  const double low_radps = 2.0 * pi * 0.1;
  EXPECT_NEAR(spectrum.spreading(low_radps, -2.0), full, 1e-12);
  EXPECT_NEAR(spectrum.spreading(low_radps, -2.0 - 0.25 * pi), 0.5 * full, 1e-12);
  EXPECT_NEAR(spectrum.spreading(low_radps, -2.0 + 1.75 * pi), 0.5 * full, 1e-12);
  EXPECT_NEAR(spectrum.spreading(low_radps, -2.0 + 0.25 * pi + 20.0 * pi), 0.5 * full, 1e-12);
  EXPECT_NEAR(spectrum.spreading(1.5 * low_radps, -2.0), 0.25 * full, 1e-12);
  EXPECT_NEAR(spectrum.spreading(1.5 * low_radps, -2.0 - 0.5 * pi), 0.75 * full, 1e-12);
}

TEST(MeasuredSpectrum, DirectionsComeFromTheSpreadingWhenTheRecordHasNone) {
  const WaveSpectrum record = scattered_record(12, 0, 0.0);
  SpreadingParameters spreading;
  spreading.direction_rad = 3.5;
  const SeaSpectrum spectrum = from_measured(record, spreading, {});
  EXPECT_NEAR(integrate_sea_state(spectrum).mean_direction_rad, 3.5, 1e-6);
  // Hasselmann's s falls from 6.97 at the peak; a frequency two peaks up must be wider.
  EXPECT_GT(spectrum.spreading(spectrum.omega_peak_radps, 3.5),
            1.2 * spectrum.spreading(2.0 * spectrum.omega_peak_radps, 3.5));
}

// The callables share the record: they must outlive both it and the spectrum they came from.
TEST(MeasuredSpectrum, DensityOutlivesItsSpectrum) {
  DirectionalDensity density;
  {
    const SeaSpectrum spectrum = from_measured(scattered_record(13, 24, 0.0), {}, {});
    density = spectrum.spreading_at(spectrum.omega_peak_radps);
  }
  double integral = 0.0;
  for (int i = 0; i < 240; ++i) {
    integral += density(2.0 * pi * i / 240) * 2.0 * pi / 240;
  }
  EXPECT_NEAR(integral, 1.0, 1e-9);
}

TEST(MeasuredSpectrum, RejectsBrokenRecords) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Case {
    const char* what;
    std::function<void(WaveSpectrum&)> spoil;
  };
  const Case cases[] = {
      {"at least 2 frequencies", [](WaveSpectrum& r) { r.frequencies_hz.resize(1), r.energy.resize(1); }},
      {"at least 2 frequencies", [](WaveSpectrum& r) { r.energy.pop_back(); }},
      {"increase", [](WaveSpectrum& r) { std::swap(r.frequencies_hz[3], r.frequencies_hz[4]); }},
      {"increase", [](WaveSpectrum& r) { r.frequencies_hz[0] = 0.0; }},
      {"increase", [=](WaveSpectrum& r) { r.frequencies_hz[5] = nan; }},
      // Neighbours and first frequencies that leave no range, or whose square underflows.
      {"increase", [](WaveSpectrum& r) { r.frequencies_hz[1] = std::nextafter(r.frequencies_hz[0], 1.0); }},
      {"found 1e-200 Hz first", [](WaveSpectrum& r) { r.frequencies_hz[0] = 1e-200; }},
      {"found 101 Hz after", [](WaveSpectrum& r) { r.frequencies_hz.back() = 101.0; }},
      {"energies", [](WaveSpectrum& r) { r.energy[2] = -1.0; }},
      {"energies", [=](WaveSpectrum& r) { r.energy[2] = nan; }},
      {"energies", [](WaveSpectrum& r) { r.energy[2] = std::numeric_limits<double>::infinity(); }},
      {"no energy", [](WaveSpectrum& r) { r.energy.assign(r.energy.size(), 0.0); }},
      {"density for each", [](WaveSpectrum& r) { r.spreading.pop_back(); }},
      {"evenly spaced", [](WaveSpectrum& r) { r.directions_rad[7] += 0.1; }},
      {"evenly spaced", [=](WaveSpectrum& r) { r.directions_rad[7] = nan; }},
      {"spreading >= 0", [](WaveSpectrum& r) { r.spreading[40] = -0.1; }},
      {"integrates to 1", [](WaveSpectrum& r) { r.energy[1] = 1.0, r.spreading[36] += 2.0; }},
  };
  for (const Case& spoilt : cases) {
    WaveSpectrum record = scattered_record(14, 36, 0.0);
    spoilt.spoil(record);
    try {
      from_measured(record, {}, {});
      ADD_FAILURE() << "accepted a record that should fail on: " << spoilt.what;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(std::string(error.what()).find(spoilt.what), std::string::npos) << error.what();
      EXPECT_FALSE(error.hint().empty());
    }
  }
}

}  // namespace
}  // namespace offing::ocean
