// The measured spectra of OFFING_TEST_DATA against figures that others integrated from them, and against the
// summaries that their makers wrote.

#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/io/spectra/read_spectra.h"
#include "tests/io/spectra/spectrum_checks.h"

namespace offing {
namespace {

class MeasuredFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!test::measured_spectra())
      GTEST_SKIP() << "OFFING_TEST_DATA is not set: measured spectra are not at hand";
  }

  static std::vector<WaveSpectrum> read(const std::string& name) {
    auto spectra = read_spectra(*test::measured_spectra() / name);
    for (const WaveSpectrum& spectrum : spectra) test::expect_contract(spectrum);
    return spectra;
  }
};

// Rows of an NDBC realtime file by their date and hour, "2020 06 08 03": all numbers after the minute.
std::map<std::string, std::vector<double>> ndbc_rows(const std::string& name, bool has_separation) {
  std::map<std::string, std::vector<double>> rows;
  std::istringstream file(test::read_text(*test::measured_spectra() / name));
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    for (char& c : line) {
      if (c == '(' || c == ')') c = ' ';
    }
    std::istringstream words(line.substr(16));
    std::vector<double>& values = rows[line.substr(0, 13)];
    for (double value = 0.0; words >> value;) values.push_back(value);
    if (has_separation) values.erase(values.begin());
  }
  return rows;
}

TEST_F(MeasuredFiles, NdbcRecordHasItsHeightAndPeak) {
  const auto spectra = read("41010.data_spec");
  ASSERT_EQ(spectra.size(), 149U);
  EXPECT_EQ(spectra[0].frequencies_hz.size(), 46U);
  EXPECT_EQ(spectra[0].time_utc, "2020-06-08T03:50Z");
  EXPECT_NEAR(test::hs_m(spectra[0]), 1.1188, 5e-5);
  EXPECT_EQ(test::peak_frequency_hz(spectra[0]), 0.180);
  for (const WaveSpectrum& spectrum : spectra) EXPECT_TRUE(spectrum.is_directional());
}

// The buoy's own WVHT, rounded to 0.1 m, against 4 sqrt(m0) of all records: bias -0.020, rms 0.037, largest
// 0.11 m. Fails on a wrong bandwidth rule (1 % of Hs is 0.01 m) or records paired wrongly.
TEST_F(MeasuredFiles, NdbcHeightsFollowTheSummary) {
  std::map<std::string, double> wvht_m;
  std::istringstream file(test::read_text(*test::measured_spectra() / "41010.spec"));
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with('#')) wvht_m[line.substr(0, 13)] = std::stod(line.substr(16));
  }
  double sum = 0.0;
  double squares = 0.0;
  double largest = 0.0;
  const auto spectra = read("41010.data_spec");
  for (const WaveSpectrum& spectrum : spectra) {
    std::string hour = spectrum.time_utc.substr(0, 13);
    hour[4] = hour[7] = hour[10] = ' ';
    ASSERT_TRUE(wvht_m.contains(hour)) << hour;
    const double difference = test::hs_m(spectrum) - wvht_m[hour];
    sum += difference;
    squares += difference * difference;
    largest = std::max(largest, std::abs(difference));
  }
  const auto count = static_cast<double>(spectra.size());
  EXPECT_NEAR(sum / count, -0.020, 0.001);
  EXPECT_NEAR(std::sqrt(squares / count), 0.037, 0.001);
  EXPECT_NEAR(largest, 0.11, 0.006);
}

// Every row of every record has the first moment that its companions print. Second moments can be more than a
// spreading function has; they are kept where |c2 - c1^2| <= 0.97 (1 - |c1|^2). Gate as MaximumEntropy
// states.
TEST_F(MeasuredFiles, NdbcRowsHaveTheirMoments) {
  const auto alpha1 = ndbc_rows("41010.swdir", false);
  const auto alpha2 = ndbc_rows("41010.swdir2", false);
  const auto r1 = ndbc_rows("41010.swr1", false);
  const auto r2 = ndbc_rows("41010.swr2", false);
  int first_count = 0;
  int second_count = 0;
  for (const WaveSpectrum& spectrum : read("41010.data_spec")) {
    std::string hour = spectrum.time_utc.substr(0, 13);
    hour[4] = hour[7] = hour[10] = ' ';
    for (std::size_t i = 0; i < spectrum.frequencies_hz.size(); ++i) {
      // Value and frequency alternate.
      const double a1 = alpha1.at(hour)[2 * i];
      const double a2 = alpha2.at(hour)[2 * i];
      if (a1 == 999.0 || a2 == 999.0) continue;
      const auto travel_rad = [](double from_deg) { return (from_deg - 270.0) * std::numbers::pi / 180.0; };
      const std::complex<double> c1 = std::polar(r1.at(hour)[2 * i], travel_rad(a1));
      const std::complex<double> c2 = std::polar(r2.at(hour)[2 * i], 2.0 * travel_rad(a2));
      EXPECT_LT(std::abs(test::row_moment(spectrum, i, 1) - c1), 1e-3) << spectrum.time_utc << " row " << i;
      ++first_count;
      if (std::abs(c2 - c1 * c1) > 0.97 * (1.0 - std::norm(c1))) continue;
      EXPECT_LT(std::abs(test::row_moment(spectrum, i, 2) - c2), 1e-3) << spectrum.time_utc << " row " << i;
      ++second_count;
    }
  }
  EXPECT_GT(first_count, 5000);
  EXPECT_GT(second_count, first_count * 9 / 10);
}

TEST_F(MeasuredFiles, Ww3StationHasItsHeights) {
  const auto spectra = read("ww3station.spec");
  ASSERT_EQ(spectra.size(), 4U);
  EXPECT_EQ(spectra[0].frequencies_hz.size(), 50U);
  EXPECT_EQ(spectra[0].directions_rad.size(), 36U);
  EXPECT_EQ(spectra[0].station, "44097");
  EXPECT_EQ(spectra[0].depth_m, 46.6);
  const double expected_m[] = {1.1573, 1.1264, 1.1016};
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(test::hs_m(spectra[i]), expected_m[i], 1e-4);
  EXPECT_EQ(test::peak_frequency_hz(spectra[0]), 0.0737);
}

// Against an independent reader (0.1 %: it integrates end bins otherwise) and SWAN's own figures (0.3 %: it
// adds a tail), and SWAN's mean directions (it says 250.226 ... 254.099).
TEST_F(MeasuredFiles, SwanHeightsAndDirectionsFollowSwan) {
  const auto spectra = read("swanfile.spec");
  ASSERT_EQ(spectra.size(), 5U);
  const double independent_m[] = {1.7164, 2.7624, 2.9257, 2.6736, 4.2596};
  const double swan_m[] = {1.719, 2.767, 2.930, 2.678, 4.264};
  const double swan_from_deg[] = {250.226, 264.233, 255.912, 266.949, 254.099};
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(test::hs_m(spectra[i]), independent_m[i], 1e-3 * independent_m[i]);
    EXPECT_NEAR(test::hs_m(spectra[i]), swan_m[i], 3e-3 * swan_m[i]);
    EXPECT_LT(test::angle_between_deg(test::mean_from_deg(spectra[i]), swan_from_deg[i]), 0.3);
  }
  EXPECT_NEAR(*spectra[0].latitude_deg, -38.173599, 1e-9);
  EXPECT_EQ(spectra[4].time_utc, "2016-10-15T00:00Z");
}

TEST_F(MeasuredFiles, DatawellHeightsFollowTheHeader) {
  const auto first = read("buoy}2024-09-09T01h15Z.spt");
  const auto second = read("buoy}2024-09-09T01h44Z.spt");
  ASSERT_EQ(first.size(), 1U);
  EXPECT_NEAR(test::hs_m(first[0]), 0.8490, 1e-3 * 0.8490);
  EXPECT_NEAR(test::hs_m(second[0]), 0.910, 0.005);
  EXPECT_EQ(first[0].time_utc, "2024-09-09T01:15Z");
  EXPECT_EQ(first[0].station, "buoy");
  // The header's direction at the peak and the row of the largest density, 0.16 Hz: 220.8 degrees,
  // spread 32.7.
  const std::complex<double> c1 = test::row_moment(first[0], 21, 1);
  EXPECT_EQ(first[0].frequencies_hz[21], 0.16);
  const double from_deg = 270.0 + std::arg(c1) * 180.0 / std::numbers::pi;
  EXPECT_LT(test::angle_between_deg(from_deg, 220.8), 0.05);
  EXPECT_NEAR(std::sqrt(2.0 * (1.0 - std::abs(c1))) * 180.0 / std::numbers::pi, 32.7, 0.1);
}

}  // namespace
}  // namespace offing
