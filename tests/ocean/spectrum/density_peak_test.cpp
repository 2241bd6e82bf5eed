#include "host/ocean/spectrum/density_peak.h"

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace offing::ocean {
namespace {

using Density = std::function<double(double hz)>;

/// JONSWAP's density with its peak at 0.1 Hz.
Density jonswap(double gamma) {
  return [=](double hz) {
    const double ratio = hz / 0.1, width = ratio <= 1.0 ? 0.07 : 0.09;
    return std::pow(ratio, -5.0) * std::exp(-1.25 * std::pow(ratio, -4.0)) *
           std::pow(gamma, std::exp(-0.5 * std::pow((ratio - 1.0) / width, 2.0)));
  };
}

/// Bins of 1 % and of 2000 f^3 df / 0.1^4 waves, as 20 wavelengths of the peak on a patch have.
std::vector<FrequencyBin> bins_of(const Density& density_m2phz) {
  std::vector<FrequencyBin> bins;
  for (double low_hz = 0.05; low_hz < 0.5; low_hz *= 1.01) {
    const double width_hz = 0.01 * low_hz;
    double energy_m2 = 0.0;
    for (int i = 0; i < 16; ++i) {
      energy_m2 += density_m2phz(low_hz + (i + 0.5) / 16.0 * width_hz) * width_hz / 16.0;
    }
    bins.push_back(
        {low_hz, low_hz + width_hz, energy_m2, 2000.0 * std::pow(low_hz / 0.1, 3.0) * width_hz / 0.1});
  }
  return bins;
}

// Fails if a peak that is where the shape has it, or to either side of it, is found elsewhere, or if the
// height of the energies matters. Bins are 1 % wide and their sums exact to 1e-5: gate 1e-4.
TEST(DensityPeak, IsFoundWhereverItIs) {
  for (const double gamma : {1.0, 1.3, 3.3, 7.0}) {
    const Density shape = jonswap(gamma);
    for (const double move : {0.85, 0.97, 1.0, 1.02, 1.2}) {
      const Density moved = [&](double hz) { return 7.0 * shape(hz / move); };
      EXPECT_NEAR(peak_of(bins_of(moved), shape, 0.1).frequency_hz / (0.1 * move), 1.0, 1e-4) << gamma;
    }
  }
}

// Fails if scattering energies move the peak on average, or by another amount than the error says, which is
// that of the peak's position in the stated number of exponential energies. 400 seas know a deviation to 3.5
// % and a mean to a twentieth of it: gates 4 of these, false alarm 1e-4 each, and 5 % for what is left out of
// the error to first order (measured 2 %).
TEST(DensityPeak, ScattersAsItSays) {
  std::mt19937_64 random(3);
  for (const double gamma : {1.0, 3.3, 7.0}) {
    const Density shape = jonswap(gamma);
    const std::vector<FrequencyBin> expected = bins_of(shape);
    const double error = peak_of(expected, shape, 0.1).error;
    double sum = 0.0, squares = 0.0;
    constexpr int seas = 400;
    for (int sea = 0; sea < seas; ++sea) {
      std::vector<FrequencyBin> drawn = expected;
      for (FrequencyBin& bin : drawn) {
        bin.energy_m2 *= std::gamma_distribution<double>(bin.waves, 1.0 / bin.waves)(random);
      }
      const double off = peak_of(drawn, shape, 0.1).frequency_hz / 0.1 - 1.0;
      sum += off;
      squares += off * off;
    }
    const double mean = sum / seas;
    EXPECT_NEAR(std::sqrt(squares / seas - mean * mean) / error, 1.0, 0.19) << gamma;
    EXPECT_LT(std::abs(mean), 4.0 * error / std::sqrt(seas) + 5e-4) << gamma;
  }
}

// Fails where bins are too few to move anything: the peak is then the shape's.
TEST(DensityPeak, TakesFewBins) {
  EXPECT_EQ(peak_of(std::vector<FrequencyBin>{{0.09, 0.11, 1.0}}, jonswap(3.3), 0.1).frequency_hz, 0.1);
  EXPECT_EQ(peak_of({}, jonswap(3.3), 0.1).frequency_hz, 0.1);
}

}  // namespace
}  // namespace offing::ocean
