#include "host/io/spectra/datawell_spectra.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/io/spectra/spectrum_checks.h"
#include "tests/ocl/expect_error.h"

namespace offing::spectra {
namespace {

using test::expect_contract;
using test::expect_error;

const std::string head =
    "10\r\n85.0\r\n4.5\r\n5.0E-1\r\n25\r\n19\r\n7\r\n-0.1\r\n0.3\r\n0.2\r\n213\r\n68\r\n";

TEST(Datawell, TakesPlaceAndTimeFromTheName) {
  const auto spectra = parse_datawell(head + "0.10,1.0,270,30,0,4\r\n0.11,0.5,270,30,0,4\r\n",
                                      "/x/some buoy}2024-09-09T01h15Z.spt");
  ASSERT_EQ(spectra.size(), 1U);
  expect_contract(spectra[0]);
  EXPECT_EQ(spectra[0].station, "some buoy");
  EXPECT_EQ(spectra[0].time_utc, "2024-09-09T01:15Z");
  EXPECT_EQ(spectra[0].energy, (std::vector<double>{0.5, 0.25}));
}

// Fails if spread, skewness or kurtosis are turned into moments wrongly. A sea whose moments are known,
// forward: m1 = 0.9, m2 = 0.68, n2 = 0.03 about 250 degrees gives the four figures by their definitions;
// reading must give them back. The figures are printed with enough digits, so that only the table's 1e-3 is
// left.
TEST(Datawell, InvertsSpreadSkewnessAndKurtosis) {
  const double m1 = 0.9;
  const double m2 = 0.68;
  const double n2 = 0.03;
  const double spread_rad = std::sqrt(2.0 * (1.0 - m1));
  const double skewness = -n2 / std::pow(0.5 * (1.0 - m2), 1.5);
  const double kurtosis = (6.0 - 8.0 * m1 + 2.0 * m2) / std::pow(spread_rad, 4);
  const std::string row = ",250.0," + std::to_string(spread_rad * 180.0 / std::numbers::pi) + "," +
                          std::to_string(skewness) + "," + std::to_string(kurtosis) + "\n";
  const WaveSpectrum spectrum = parse_datawell(head + "0.10,1.0" + row + "0.11,0.5" + row, "b.spt")[0];
  const double travel_rad = (250.0 - 270.0) * std::numbers::pi / 180.0;
  EXPECT_NEAR(std::abs(test::row_moment(spectrum, 0, 1) - std::polar(m1, travel_rad)), 0.0, 1e-3);
  const std::complex<double> second = std::complex<double>(m2, n2) * std::polar(1.0, 2.0 * travel_rad);
  EXPECT_NEAR(std::abs(test::row_moment(spectrum, 0, 2) - second), 0.0, 1e-3);
}

TEST(Datawell, ReadsBuoysWithoutDirections) {
  const WaveSpectrum spectrum = parse_datawell(head + "0.10,1.0\n0.11,0.5\n", "b.spt")[0];
  EXPECT_FALSE(spectrum.is_directional());
  EXPECT_EQ(spectrum.time_utc, "");
}

TEST(Datawell, SurvivesImpossibleShapes) {
  const WaveSpectrum spectrum = parse_datawell(
      head + "0.10,1.0,10,100,1e300,-1e300\n0.11,0.5,0,0,99,99\n0.12,0,360,81.03,-5,0\n", "b.spt")[0];
  expect_contract(spectrum);
}

TEST(DatawellErrors, NameFileAndLine) {
  const struct {
    std::string text;
    const char* message;
  } cases[] = {
      {"", "b.spt:0: expected twelve header lines of one value, got the end of the file"},
      {"10\n85\n", "b.spt:2: expected twelve header lines of one value, got the end of the file"},
      {"10\n85 7\n", "b.spt:2: expected a header line of one value, got \"85 7\""},
      {"10\nx\n", "b.spt:2: expected a header line of one value, got \"x\""},
      {"1\n2\n3\n-4\n", "b.spt:4: expected the largest density in m^2/Hz, got -4"},
      {head, "b.spt: expected two or more frequencies, got 0"},
      {head + "0.10,1.0,270,30,0,4\n0.10,1.0,270,30,0,4\n", "expected a frequency above 0.1 Hz, got 0.1"},
      {head + "0.10,1.0,270\n", "b.spt:13: expected six values"},
      {head + "0.10,1.0,270,30,0,4,5\n", "b.spt:13: expected six values"},
      {head + "0.10,-1.0,270,30,0,4\n", "b.spt:13: expected a density S/Smax >= 0, got -1"},
      {head + "0.10,1.0,400,30,0,4\n", "b.spt:13: expected a direction within 360 degrees"},
      {head + "0.10,1.0,270,-30,0,4\n", "b.spt:13: expected a direction within 360 degrees"},
      {head + "0.10,1.0,nan,30,0,4\n", "b.spt:13: expected f, S/Smax"},
  };
  for (const auto& c : cases) {
    const std::string hint =
        expect_error(ErrorKind::bad_input, c.message, [&] { parse_datawell(c.text, "b.spt"); });
    EXPECT_FALSE(hint.empty()) << c.message;
  }
}

}  // namespace
}  // namespace offing::spectra
