// The sea that ships with Offing: a wind sea of 3.5 m with its peak at 0.11 Hz from the south-west (225
// degrees) and a swell of 1.2 m at 0.07 Hz from the north-west (315 degrees).

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/io/spectra/read_spectra.h"
#include "tests/io/spectra/spectrum_checks.h"

namespace offing {
namespace {

double row_from_deg(const WaveSpectrum& spectrum, double frequency_hz) {
  for (std::size_t i = 0; i < spectrum.frequencies_hz.size(); ++i) {
    if (std::abs(spectrum.frequencies_hz[i] - frequency_hz) > 1e-9) continue;
    return 270.0 + std::arg(test::row_moment(spectrum, i, 1)) * 180.0 / std::numbers::pi;
  }
  ADD_FAILURE() << "no frequency " << frequency_hz;
  return 0.0;
}

// Fails if the files of the demo and what is said of them drift apart.
TEST(ExampleSea, IsAsDescribed) {
  const auto spectra = read_spectra(OFFING_SCENES "/example_sea.data_spec");
  ASSERT_EQ(spectra.size(), 3U);
  for (const WaveSpectrum& spectrum : spectra) {
    test::expect_contract(spectrum);
    EXPECT_TRUE(spectrum.is_directional());
  }
  EXPECT_NEAR(test::hs_m(spectra[0]), std::hypot(3.5, 1.2), 0.005);
  EXPECT_EQ(test::peak_frequency_hz(spectra[0]), 0.11);
  // The second, lower peak: more energy at 0.068 than on either side.
  EXPECT_GT(spectra[0].energy[7], spectra[0].energy[5]);
  EXPECT_GT(spectra[0].energy[7], spectra[0].energy[10]);
  EXPECT_LT(test::angle_between_deg(row_from_deg(spectra[0], 0.11), 225.0), 1.0);
  EXPECT_LT(test::angle_between_deg(row_from_deg(spectra[0], 0.068), 315.0), 1.0);
}

}  // namespace
}  // namespace offing
