#include "host/io/spectra/swan_spectra.h"

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

const std::string locations = "LONLAT\n 3\n 1.00 50.00\n 1.20 51.00\n 1.40 52.00\n";
const std::string frequencies = "AFREQ  absolute frequencies in Hz\n 2\n 0.1\n 0.2\n";
const std::string origins = "NDIR  nautical\n 4\n 0.\n 90.\n 180.\n 270.\n";
const std::string density_2d =
    "QUANT\n 1  number\nVaDens  variance densities\nm2/Hz/degr  unit\n -99  exception value\n";
// At 0.1 Hz all from the west (270), at 0.2 Hz a third from the north and two thirds from the south.
const std::string factor = "FACTOR\n 0.5E-01\n 0 0 0 40\n 10 0 20 0\n";

std::string two_dimensional(const std::string& records) {
  return "SWAN   1   Swan standard spectral file, version\n$ a comment\nTIME  time-dependent data\n 1  "
         "option\n" +
         locations + frequencies + origins + density_2d + records;
}

TEST(Swan2d, ReadsLocationsTimesAndKeywords) {
  const auto spectra = parse_swan(two_dimensional("20161011.000000 date\n" + factor + "NODATA\nZERO\n" +
                                                  "20161011.013015\nNODATA\n" + factor + "NODATA\n"),
                                  "f.spec");
  ASSERT_EQ(spectra.size(), 3U);
  for (const WaveSpectrum& spectrum : spectra) expect_contract(spectrum);
  EXPECT_EQ(spectra[0].station, "location 1");
  EXPECT_EQ(spectra[0].time_utc, "2016-10-11T00:00Z");
  EXPECT_EQ(spectra[1].station, "location 3");
  EXPECT_EQ(spectra[1].energy, (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(spectra[2].station, "location 2");
  EXPECT_EQ(spectra[2].time_utc, "2016-10-11T01:30:15Z");
  EXPECT_EQ(spectra[2].latitude_deg, 51.0);
  EXPECT_EQ(spectra[2].longitude_deg, 1.2);
}

// Fails on a wrong factor or unit (m2/Hz/degr over bins of 90 degrees) or a wrong turn: from the west is
// toward +x.
TEST(Swan2d, NauticalDirectionsAreOrigins) {
  const WaveSpectrum spectrum =
      parse_swan(two_dimensional("20161011.000000\n" + factor + "ZERO\nZERO\n"), "f")[0];
  EXPECT_NEAR(spectrum.energy[0], 40 * 0.05 * 90, 1e-9);
  EXPECT_NEAR(spectrum.energy[1], 30 * 0.05 * 90, 1e-9);
  EXPECT_NEAR(std::abs(test::row_moment(spectrum, 0, 1) - 1.0), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(test::row_moment(spectrum, 1, 1) - std::complex<double>(0.0, -1.0 / 3.0)), 0.0, 1e-9);
}

// Cartesian: 90 degrees is toward north, that is toward -z; and energy density is turned into variance
// density.
TEST(Swan2d, CartesianDirectionsAreOfTravel) {
  const std::string text =
      "SWAN 1\nLOCATIONS\n 1\n 10.5 20\nRFREQ\n 2\n 0.1\n 0.2\nCDIR\n 4\n 0\n 90\n 180\n 270\n" +
      std::string("QUANT\n 1\nEnDens\nJ/m2/Hz/degr\n -99\nFACTOR\n 1\n 0 1 0 0\n 1 0 0 0\n");
  const auto spectra = parse_swan(text, "f");
  ASSERT_EQ(spectra.size(), 1U);
  EXPECT_EQ(spectra[0].station, "location 1 (x 10.5 m, y 20 m)");
  EXPECT_EQ(spectra[0].time_utc, "");
  EXPECT_NEAR(spectra[0].energy[0], 90.0 / (1025 * 9.81), 1e-12);
  EXPECT_NEAR(std::abs(test::row_moment(spectra[0], 0, 1) - std::complex<double>(0.0, -1.0)), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(test::row_moment(spectra[0], 1, 1) - 1.0), 0.0, 1e-9);
}

// Fails if a sector is stretched over the circle or its energy changes: 7 directions from 200 to 260 in steps
// of 10 degrees, density 1 and a triangle. Mean and energy by hand.
TEST(Swan2d, ASectorStaysASector) {
  std::string text = "SWAN 1\nLOCATIONS\n 1\n 0 0\nAFREQ\n 2\n 0.1\n 0.2\nNDIR\n 7\n";
  for (int direction = 200; direction <= 260; direction += 10) text += std::to_string(direction) + "\n";
  text += density_2d + "FACTOR\n 1\n 1 1 1 1 1 1 1\n 0 0 3 0 0 0 0\n";
  const WaveSpectrum spectrum = parse_swan(text, "f")[0];
  expect_contract(spectrum);
  EXPECT_NEAR(spectrum.energy[0], 70.0, 1e-9);
  EXPECT_NEAR(spectrum.energy[1], 30.0, 1e-9);
  EXPECT_NEAR(test::angle_between_deg(test::mean_from_deg(spectrum), 230.0 - 10.0 * 30.0 / 100.0), 0.0, 0.2);
  const double from_bin_deg = 270.0 + std::arg(test::row_moment(spectrum, 1, 1)) * 180.0 / std::numbers::pi;
  EXPECT_NEAR(test::angle_between_deg(from_bin_deg, 220.0), 0.0, 1e-6);
}

// Fails if a direction of absurd size is not brought into one turn; it once ended in an endless loop.
TEST(Swan2d, WrapsDirectionsOfAnySize) {
  const std::string text =
      "SWAN 1\nLOCATIONS\n 1\n 0 0\nAFREQ\n 2\n .1\n .2\nCDIR\n 3\n 10\n -1e300\n 1e307\n" + density_2d +
      "FACTOR\n 1\n 1 2 3\n 4 5 6\n";
  expect_contract(parse_swan(text, "f")[0]);
}

TEST(Swan2d, LeavesFrequenciesWithExceptionValuesOut) {
  const std::string text =
      "SWAN 1\nLOCATIONS\n 1\n 0 0\nAFREQ\n 3\n .1\n .2\n .3\nNDIR\n 4\n 0\n 90\n 180\n 270\n" + density_2d +
      "FACTOR\n 1\n 1 1 1 1\n -99 -99 -99 -99\n 2 2 2 2\n";
  const WaveSpectrum spectrum = parse_swan(text, "f")[0];
  EXPECT_EQ(spectrum.frequencies_hz, (std::vector<double>{0.1, 0.3}));
  EXPECT_NEAR(spectrum.energy[1], 720.0, 1e-9);
}

const std::string quantities_1d =
    "QUANT\n 3\nVaDens\nm2/Hz\n -0.9900E+02\nCDIR\ndegr\n -0.9990E+03\nDSPRDEGR\ndegr\n -0.9000E+01\n";

TEST(Swan1d, ReadsDirectionAndSpread) {
  const std::string text =
      "SWAN 1\nTIME\n 1\n" + locations + "RFREQ\n 3\n 0.1\n 0.2\n 0.3\n" + quantities_1d +
      "19680606.030000\nLOCATION   1\n 1.5  90.0  30.0\n 0.5 -999. -9.\n -99 -999. -9.\n" +
      "NODATA\nLOCATION   3\n 0 -999 -9\n 0 -999 -9\n 0 -999 -9\n";
  const auto spectra = parse_swan(text, "f");
  ASSERT_EQ(spectra.size(), 2U);
  expect_contract(spectra[0]);
  EXPECT_EQ(spectra[0].energy, (std::vector<double>{1.5, 0.5}));
  const double r1 = 1.0 - 0.5 * std::pow(std::numbers::pi / 6.0, 2);
  EXPECT_NEAR(std::abs(test::row_moment(spectra[0], 0, 1) - std::complex<double>(0.0, -r1)), 0.0, 1e-6);
  EXPECT_EQ(test::row_moment(spectra[0], 1, 1), test::row_moment(spectra[0], 0, 1));
  EXPECT_FALSE(spectra[1].is_directional());
}

TEST(Swan1d, ReadsAllTimeCodings) {
  const struct {
    const char* coding;
    const char* time;
    const char* iso;
  } cases[] = {
      {"1", "19870530.153000", "1987-05-30T15:30Z"},   {"2", "30-May-87 15:30:00", "1987-05-30T15:30Z"},
      {"3", "05/30/87.15:30:00", "1987-05-30T15:30Z"}, {"4", "15:30:00", "15:30:00"},
      {"5", "87/05/30 15:30:00", "1987-05-30T15:30Z"}, {"6", "8705301530", "1987-05-30T15:30Z"},
  };
  for (const auto& c : cases) {
    const std::string text =
        "SWAN 1\nTIME\n " + std::string(c.coding) + "\nLOCATIONS\n 1\n 0 0\nAFREQ\n 2\n 0.1\n 0.2\n" +
        "QUANT\n 1\nVaDens\nm2/Hz\n -99\n" + c.time + " date and time\nLOCATION 1\n 1\n 2\n";
    const auto spectra = parse_swan(text, "f");
    EXPECT_EQ(spectra[0].time_utc, c.iso);
    EXPECT_FALSE(spectra[0].is_directional());
  }
}

TEST(SwanErrors, NameFileAndLine) {
  const std::string to_frequencies = "SWAN 1\nLOCATIONS\n 1\n 0 0\n";
  const std::string to_quantities = to_frequencies + frequencies + origins;
  const std::string to_records = to_quantities + density_2d;
  const std::string zeros = "ZERO\n";
  const struct {
    std::string text;
    const char* message;
  } cases[] = {
      {"", "f:0: expected SWAN and the version 1, got the end of the file"},
      {"SWAN 2\n", "f:1: expected SWAN and the version 1"},
      {"SWAN 1\nTIME\n 7\n", "f:3: expected a time coding option within [1, 6], got 7"},
      {"SWAN 1\nPLACES\n", "f:2: expected LONLAT or LOCATIONS"},
      {"SWAN 1\nLOCATIONS\n 999999\n", "f:3: expected the number of locations, got 999999"},
      {"SWAN 1\nLOCATIONS\n 1\n 5\n", "f:4: expected the second coordinate of a location"},
      {to_frequencies + "FREQ\n", "f:5: expected AFREQ or RFREQ"},
      {to_frequencies + "AFREQ\n 0\n", "f:6: expected the number of frequencies, got 0"},
      {to_frequencies + "AFREQ\n 1e300\n", "f:6: expected the number of frequencies, got 1e+300"},
      {to_frequencies + "AFREQ\n 2\n 0.2\n 0.1\n", "f:8: expected a frequency above 0.2 Hz, got 0.1"},
      {to_frequencies + "AFREQ\n 2\n -1\n 0.1\n", "expected a frequency above 0 Hz, got -1"},
      {to_frequencies + frequencies + "NDIR\n 1\n 5\n", "expected two or more directions, got 1"},
      {to_frequencies + frequencies + "NDIR\n 3\n 5\n 5\n 9\n", "is listed twice"},
      {to_quantities + "QUANT\n 2\n", "f:16: expected one quantity, got 2"},
      {to_quantities + "QUANT\n 1\nVaDens\nm2/Hz\n -99\n",
       "f:18: expected the unit m2/Hz/degr, got \"m2/Hz\""},
      {to_quantities + "QUANT\n 1\nHsig\nm\n -9\n", "f:17: expected VaDens, EnDens"},
      {to_records, "expected FACTOR, ZERO, NODATA or LOCATION, got the end of the file"},
      {to_records + "LOCATION 1\n", "f:20: expected FACTOR, ZERO or NODATA"},
      {to_records + "FACTOR\n 1\n 1 2 3 4\n 5 6 7\n",
       "f:23: expected a value of the spectrum, got the end of the file"},
      {to_records + "FACTOR\n 1\n 1 2 3 4\n 5 6 7 -8\n", "f:21: expected a variance density >= 0"},
      {to_records + "FACTOR\n 1\n 1 2 3 4\n 5 6 7 8 9\n", "f:23: expected the end of the record"},
      {to_records + "FACTOR\n nan\n", "f:21: expected the factor, got \"nan\""},
      {to_records + zeros + "more\n", "f:21: expected the end of the file"},
      {to_records + "NODATA\n", "expected at least one location with data, got none"},
      {two_dimensional("2016-10-11\n"), "expected a time of the form YYYYMMDD.hhmmss"},
      {two_dimensional("20161311.000000\n"), "expected a time of the form YYYYMMDD.hhmmss"},
  };
  for (const auto& c : cases) {
    const std::string hint = expect_error(ErrorKind::bad_input, c.message, [&] { parse_swan(c.text, "f"); });
    EXPECT_FALSE(hint.empty()) << c.message;
  }
}

// Fails if a few bytes can claim the memory of many spectra: two header lines promise 10^5 x 10^5 densities,
// or each ZERO stands for a spectrum of ten thousand frequencies.
TEST(SwanErrors, TheSizeOfTheFileBoundsTheMemory) {
  std::string text = "SWAN 1\nTIME\n 1\nLOCATIONS\n 1\n 0 0\nAFREQ\n 10000\n";
  for (int i = 1; i <= 10000; ++i) text += std::to_string(i) + "\n";
  std::string directional = text + "NDIR\n 10000\n";
  for (int i = 0; i < 10000; ++i) directional += std::to_string(i * 0.036) + "\n";
  directional += density_2d + "20161011.000000\n";
  expect_error(ErrorKind::bad_input, "expected as many values as the header says",
               [&] { parse_swan(directional + "FACTOR\n 1\n 1 2 3\n", "f"); });
  for (int i = 0; i < 5000; ++i) directional += "ZERO\n20161011.000000\n";
  expect_error(ErrorKind::bad_input, "expected as many spectra as the file's size can hold",
               [&] { parse_swan(directional + "ZERO\n", "f"); });
}

}  // namespace
}  // namespace offing::spectra
