#include "tests/io/spectra/spectrum_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numbers>

#include <gtest/gtest.h>

namespace offing::test {
namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi;

double spacing_rad(const WaveSpectrum& spectrum) {
  return turn_rad / static_cast<double>(spectrum.directions_rad.size());
}

}  // namespace

void expect_contract(const WaveSpectrum& spectrum) {
  const std::size_t nf = spectrum.frequencies_hz.size();
  const std::size_t nd = spectrum.directions_rad.size();
  ASSERT_GE(nf, 2U);
  ASSERT_EQ(spectrum.energy.size(), nf);
  ASSERT_EQ(spectrum.spreading.size(), nf * nd);
  double last_hz = 0.0;
  for (std::size_t i = 0; i < nf; ++i) {
    ASSERT_GT(spectrum.frequencies_hz[i], last_hz);
    last_hz = spectrum.frequencies_hz[i];
    ASSERT_TRUE(std::isfinite(last_hz));
    ASSERT_TRUE(std::isfinite(spectrum.energy[i]) && spectrum.energy[i] >= 0.0) << spectrum.energy[i];
  }
  for (std::size_t j = 1; j < nd; ++j) {
    ASSERT_NEAR(spectrum.directions_rad[j] - spectrum.directions_rad[j - 1], spacing_rad(spectrum), 1e-9);
  }
  for (std::size_t i = 0; i < nf && nd > 0; ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < nd; ++j) {
      const double density = spectrum.spreading[i * nd + j];
      ASSERT_TRUE(density >= 0.0 && std::isfinite(density)) << density;
      sum += density;
    }
    // Rounding of nd <= 360 terms: below nd * 2^-53 = 4e-14.
    ASSERT_NEAR(sum * spacing_rad(spectrum), 1.0, 1e-12) << "row " << i;
  }
}

std::complex<double> row_moment(const WaveSpectrum& spectrum, std::size_t i, int n) {
  const std::size_t nd = spectrum.directions_rad.size();
  std::complex<double> moment;
  for (std::size_t j = 0; j < nd; ++j) {
    moment +=
        spectrum.spreading[i * nd + j] * std::polar(spacing_rad(spectrum), n * spectrum.directions_rad[j]);
  }
  return moment;
}

double hs_m(const WaveSpectrum& spectrum) {
  return 4.0 * std::sqrt(variance_m2(spectrum));
}

double peak_frequency_hz(const WaveSpectrum& spectrum) {
  const auto peak = std::max_element(spectrum.energy.begin(), spectrum.energy.end());
  return spectrum.frequencies_hz[static_cast<std::size_t>(peak - spectrum.energy.begin())];
}

double mean_from_deg(const WaveSpectrum& spectrum) {
  std::complex<double> sum;
  for (std::size_t i = 1; i < spectrum.frequencies_hz.size(); ++i) {
    const double half_width_hz = 0.5 * (spectrum.frequencies_hz[i] - spectrum.frequencies_hz[i - 1]);
    sum += half_width_hz * spectrum.energy[i] * row_moment(spectrum, i, 1);
    sum += half_width_hz * spectrum.energy[i - 1] * row_moment(spectrum, i - 1, 1);
  }
  const double from_deg = 270.0 + std::arg(sum) * 180.0 / std::numbers::pi;
  return std::fmod(from_deg + 360.0, 360.0);
}

double angle_between_deg(double a_deg, double b_deg) {
  return std::abs(std::remainder(a_deg - b_deg, 360.0));
}

std::optional<std::filesystem::path> measured_spectra() {
  const char* folder = std::getenv("OFFING_TEST_DATA");
  if (folder == nullptr) return std::nullopt;
  return std::filesystem::path(folder) / "spectra";
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  EXPECT_TRUE(file.flush()) << path;
}

}  // namespace offing::test
