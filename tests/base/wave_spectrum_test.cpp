#include "host/base/wave_spectrum.h"

#include <gtest/gtest.h>

namespace offing {
namespace {

// Fails if uneven bands, as of buoys, are weighed alike: E = 3 f + 1 is linear, so that the trapezoidal rule
// is exact, and its integral from 0.03 to 0.58 Hz is 1.5 (0.58^2 - 0.03^2) + 0.55 = 1.05325. Gate: rounding.
TEST(WaveSpectrumTest, VarianceOfUnevenBands) {
  WaveSpectrum spectrum;
  spectrum.frequencies_hz = {0.03, 0.035, 0.1, 0.11, 0.5, 0.58};
  for (const double f : spectrum.frequencies_hz) spectrum.energy.push_back(3.0 * f + 1.0);
  EXPECT_NEAR(variance_m2(spectrum), 1.05325, 1e-14);
}

// Fails if energy is counted outside the listed frequencies: a peak at the first one is half a band wide.
TEST(WaveSpectrumTest, NoEnergyOutsideTheListedFrequencies) {
  WaveSpectrum spectrum;
  spectrum.frequencies_hz = {0.1, 0.2, 0.4};
  spectrum.energy = {8.0, 0.0, 0.0};
  EXPECT_NEAR(variance_m2(spectrum), 0.4, 1e-15);
  EXPECT_EQ(variance_m2({}), 0.0);
}

}  // namespace
}  // namespace offing
