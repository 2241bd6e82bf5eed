// Spectra of the C interface: files, arrays, models, and seas that are made of them.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/c/offing.h"

namespace offing {
namespace {

using testing::HasSubstr;

class SpectrumCallsTest : public testing::Test {
 protected:
  void TearDown() override {
    offing_free_spectra(spectra_);
    offing_free_scene(scene_);
  }

  void parse(const char* text) {
    ASSERT_EQ(offing_parse_scene(text, nullptr, &scene_), OFFING_OK) << offing_last_error();
  }
  OffingSpectrum spectrum(std::size_t index = 0) {
    OffingSpectrum found{};
    found.size = sizeof found;
    EXPECT_EQ(offing_get_spectrum(spectra_, index, &found), OFFING_OK) << offing_last_error();
    return found;
  }
  OffingSeaState state() {
    OffingSeaState found{};
    found.size = sizeof found;
    EXPECT_EQ(offing_get_sea_state(scene_, &found), OFFING_OK) << offing_last_error();
    return found;
  }

  OffingSpectra* spectra_ = nullptr;
  OffingScene* scene_ = nullptr;
};

// A bump of energy around 0.1 Hz in 24 directions about south-east.
struct Bump {
  std::vector<double> frequencies_hz, energy, directions_rad, density;

  Bump() {
    for (int i = 0; i < 40; ++i) frequencies_hz.push_back(0.04 + 0.005 * i);
    for (int i = 0; i < 24; ++i) directions_rad.push_back(2.0 * std::numbers::pi * i / 24.0);
    for (const double f : frequencies_hz) {
      energy.push_back(10.0 * std::exp(-0.5 * std::pow((f - 0.1) / 0.015, 2.0)));
      // cos^2 about 45 degrees: integrates to 1 over the circle by the rectangle rule.
      for (const double direction : directions_rad)
        density.push_back(energy.back() * (1.0 + std::cos(direction - 0.25 * std::numbers::pi)) /
                          (2.0 * std::numbers::pi));
    }
  }
  OffingSpectrum values() const {
    OffingSpectrum given{};
    given.size = sizeof given;
    given.frequency_count = frequencies_hz.size();
    given.frequencies_hz = frequencies_hz.data();
    given.energy_m2phz = energy.data();
    given.latitude_deg = 54.5;
    given.longitude_deg = std::nan("");
    given.depth_m = std::nan("");
    return given;
  }
  double m0_m2() const {
    double sum = 0.0;
    for (std::size_t i = 1; i < energy.size(); ++i) sum += 0.5 * (energy[i] + energy[i - 1]) * 0.005;
    return sum;
  }
};

// Fails if arrays come back changed, or a sea of them has another height or direction.
TEST_F(SpectrumCallsTest, SeasComeFromArrays) {
  const Bump bump;
  OffingSpectrum given = bump.values();
  given.direction_count = bump.directions_rad.size();
  given.directions_rad = bump.directions_rad.data();
  given.density = bump.density.data();
  ASSERT_EQ(offing_make_spectrum(&given, &spectra_), OFFING_OK) << offing_last_error();
  ASSERT_EQ(offing_spectrum_count(spectra_), 1u);
  const OffingSpectrum found = spectrum();
  ASSERT_EQ(found.frequency_count, 40u);
  ASSERT_EQ(found.direction_count, 24u);
  for (std::size_t i = 0; i < bump.density.size(); ++i) EXPECT_NEAR(found.density[i], bump.density[i], 1e-12);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_NEAR(found.energy_m2phz[i], bump.energy[i], 1e-9);
  EXPECT_EQ(found.latitude_deg, 54.5);
  EXPECT_TRUE(std::isnan(found.depth_m));
  EXPECT_STREQ(found.station, "");

  parse("version = 1\n[ocean]\nsize = 16\n");
  ASSERT_EQ(offing_set_spectrum(scene_, spectra_, 0), OFFING_OK) << offing_last_error();
  EXPECT_NEAR(state().hs_m, 4.0 * std::sqrt(bump.m0_m2()), 1e-4);
  EXPECT_NEAR(state().mean_direction_rad, 0.25 * std::numbers::pi, 1e-4);
  EXPECT_EQ(offing_set_spectrum(scene_, spectra_, 1), OFFING_BAD_INPUT);
}

// Fails if the negative densities of a truncated Fourier series are refused, or change energy or mean
// direction: the table of maximum entropy keeps moments to 1e-3.
TEST_F(SpectrumCallsTest, FourierSeriesKeepTheirMoments) {
  Bump bump;
  for (std::size_t i = 0; i < bump.density.size(); ++i) {
    const double angle = bump.directions_rad[i % 24] - 0.25 * std::numbers::pi;
    bump.density[i] = bump.energy[i / 24] *
                      (1.0 + 2.0 * 0.9 * std::cos(angle) + 2.0 * 0.7 * std::cos(2.0 * angle)) /
                      (2.0 * std::numbers::pi);
  }
  ASSERT_LT(*std::min_element(bump.density.begin(), bump.density.end()), 0.0);
  OffingSpectrum given = bump.values();
  given.direction_count = bump.directions_rad.size();
  given.directions_rad = bump.directions_rad.data();
  given.density = bump.density.data();
  ASSERT_EQ(offing_make_spectrum(&given, &spectra_), OFFING_OK) << offing_last_error();
  const OffingSpectrum found = spectrum();
  for (std::size_t row = 0; row < found.frequency_count; ++row) {
    EXPECT_NEAR(found.energy_m2phz[row], bump.energy[row], 1e-9 * (1.0 + bump.energy[row]));
    std::complex<double> first = 0.0;
    for (std::size_t i = 0; i < found.direction_count; ++i) {
      EXPECT_GE(found.density[row * found.direction_count + i], 0.0);
      first += found.density[row * found.direction_count + i] * std::polar(1.0, found.directions_rad[i]);
    }
    EXPECT_NEAR(std::arg(first), 0.25 * std::numbers::pi, 1e-3);
  }
}

// Fails if a spectrum without directions does not take the wind's.
TEST_F(SpectrumCallsTest, EnergyAloneTakesTheScenesDirection) {
  const Bump bump;
  const OffingSpectrum given = bump.values();
  ASSERT_EQ(offing_make_spectrum(&given, &spectra_), OFFING_OK) << offing_last_error();
  parse("version = 1\n[wind]\ndirection_deg = 120\n[ocean]\nsize = 16\n");
  ASSERT_EQ(offing_set_spectrum(scene_, spectra_, 0), OFFING_OK);
  EXPECT_NEAR(state().mean_direction_rad, 120.0 / 180.0 * std::numbers::pi, 1e-3);
}

// Fails if the table of a model has another energy than the model: m0 by the trapezoidal rule over fine
// frequencies, 0.1 % for the tail above 2 Hz and the rule.
TEST_F(SpectrumCallsTest, TablesHoldTheEnergyOfModels) {
  parse(
      "version = 1\n[wind]\nspeed_mps = 12\ndirection_deg = 30\n[ocean]\nsize = 16\nspectrum = "
      "\"jonswap\"\n");
  std::vector<double> frequencies;
  for (int i = 0; i < 1000; ++i) frequencies.push_back(0.02 + 0.002 * i);
  ASSERT_EQ(offing_tabulate_spectrum(scene_, frequencies.data(), frequencies.size(), 36, &spectra_),
            OFFING_OK)
      << offing_last_error();
  const OffingSpectrum found = spectrum();
  ASSERT_EQ(found.direction_count, 36u);
  double m0 = 0.0;
  for (std::size_t i = 1; i < found.frequency_count; ++i)
    m0 += 0.5 * (found.energy_m2phz[i] + found.energy_m2phz[i - 1]) * 0.002;
  EXPECT_NEAR(4.0 * std::sqrt(m0) / state().hs_m, 1.0, 1e-3);
}

// Fails if height, period and swells of a scene do not reach a program in C, or the new figures are of
// another quantity. Peak and height are exact to the quadrature's 1e-5; cos^2s of 12 degrees has that spread.
TEST_F(SpectrumCallsTest, SeasComeByHeightAndPeriod) {
  parse("version = 1\n[ocean]\nspectrum = \"tma\"\ndepth_m = 8\nhs_m = 1.5\ntp_s = 8\n");
  EXPECT_NEAR(state().hs_m, 1.5, 1e-4);
  EXPECT_NEAR(state().peak_period_s, 8.0, 1e-4);
  EXPECT_NEAR(state().peak_direction_rad, 0.0, 1e-6);
  offing_free_scene(scene_);
  parse(
      "version = 1\n[ocean]\nhs_m = 0.001\ntp_s = 1\n"
      "[[ocean.swell]]\nhs_m = 2\ntp_s = 13\ndirection_deg = 90\nspread_deg = 12\n");
  EXPECT_NEAR(state().hs_m, 2.0, 1e-4);
  EXPECT_NEAR(state().peak_period_s, 13.0, 1e-3);
  EXPECT_NEAR(state().peak_direction_rad, 0.5 * std::numbers::pi, 1e-3);
  EXPECT_NEAR(state().spread_rad, 12.0 * std::numbers::pi / 180.0, 2e-3);
}

// Fails if arrays that are none make a sea.
TEST_F(SpectrumCallsTest, RefusesBadArrays) {
  Bump bump;
  OffingSpectrum given = bump.values();
  given.size = 0;
  EXPECT_EQ(offing_make_spectrum(&given, &spectra_), OFFING_BAD_INPUT);
  given = bump.values();
  given.frequencies_hz = nullptr;
  EXPECT_EQ(offing_make_spectrum(&given, &spectra_), OFFING_BAD_INPUT);
  bump.frequencies_hz[3] = bump.frequencies_hz[2];
  given = bump.values();
  EXPECT_EQ(offing_make_spectrum(&given, &spectra_), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_hint(), HasSubstr("Hz"));
  bump = Bump();
  bump.energy[5] = -1.0;
  given = bump.values();
  EXPECT_EQ(offing_make_spectrum(&given, &spectra_), OFFING_BAD_INPUT);
  EXPECT_EQ(offing_read_spectra("no/such.spec", &spectra_), OFFING_BAD_INPUT);
  EXPECT_EQ(spectra_, nullptr);
  EXPECT_EQ(offing_spectrum_count(nullptr), 0u);
}

}  // namespace
}  // namespace offing
