#include "host/io/spectra/triaxys_spectra.h"

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/io/spectra/spectrum_checks.h"
#include "tests/ocl/expect_error.h"

namespace offing::spectra {
namespace {

using test::expect_contract;
using test::expect_error;

const std::string report_title =
    "TRIAXYS BUOY DATA REPORT - TAS01970 - TAB01401 - 4857.6668S16631.6837W\nVERSION = WV\n";
const std::string energies =
    report_title +
    "TYPE    = NON-DIRECTIONAL SPECTRUM\nDATE    = 2018-01-31 21:00(UTC)\n"
    "NUMBER OF FREQUENCIES              =   3\nINITIAL FREQUENCY (Hz)             =   0.000\n"
    "FREQUENCY SPACING (Hz)             =   0.010\nCOLUMN 1 = FREQUENCY (Hz)\n"
    "COLUMN 2 = SPECTRAL DENSITY (M^2/Hz)\n";
const std::string densities = report_title +
                              "TYPE\t= DIRECTIONAL SPECTRUM\r\nDATE    = 2018 Feb 09 04:00(UTC)\r\n"
                              "NUMBER OF FREQUENCIES              =      3\r\n"
                              "INITIAL FREQUENCY (Hz)             =   0.100\r\n"
                              "FREQUENCY SPACING (Hz)             =   0.010\r\n"
                              "NUMBER OF DIRECTIONS               =     5\r\n"
                              "DIRECTION SPACING (DEG)            =     90.0\r\n"
                              "COLUMNS = 0.00 TO 360.00 DEG\r\nROWS\t= 0.00 TO   0.64 Hz\r\n";

// Fails if the line of 0 Hz is kept, which no spectrum has, or station and time are read wrongly.
TEST(Triaxys, ReadsEnergies) {
  const auto spectra =
      parse_triaxys(energies + "0.000 0.0E+00\n0.010 1.5E-02\n0.020 2.5E-01\n", "a.NONDIRSPEC");
  ASSERT_EQ(spectra.size(), 1U);
  expect_contract(spectra[0]);
  EXPECT_EQ(spectra[0].station, "TAS01970");
  EXPECT_EQ(spectra[0].time_utc, "2018-01-31T21:00Z");
  EXPECT_EQ(spectra[0].frequencies_hz, (std::vector<double>{0.01, 0.02}));
  EXPECT_EQ(spectra[0].energy, (std::vector<double>{0.015, 0.25}));
  EXPECT_FALSE(spectra[0].is_directional());
}

// Fails if the column of 360 degrees counts twice, densities stay those of a degree, or bearings turn around:
// all waves come from 90 degrees, the east, so that they travel to the west, 180 degrees from +x.
TEST(Triaxys, ReadsDensities) {
  const std::string row = "2.0E-03 4.0E-01 0.0E+00 0.0E+00 2.0E-03\r\n";
  const auto spectra = parse_triaxys(densities + row + row + row, "a.DIRSPEC");
  ASSERT_EQ(spectra.size(), 1U);
  expect_contract(spectra[0]);
  EXPECT_EQ(spectra[0].time_utc, "2018-02-09T04:00Z");
  ASSERT_EQ(spectra[0].directions_rad.size(), 4U);
  EXPECT_NEAR(spectra[0].frequencies_hz[2], 0.12, 1e-15);
  EXPECT_NEAR(spectra[0].energy[1], 0.402 * 90.0, 1e-12);
  EXPECT_NEAR(test::mean_from_deg(spectra[0]), 90.0 - std::atan(0.002 / 0.4) * 180.0 / M_PI, 1e-9);
}

TEST(TriaxysErrors, NameFileAndLine) {
  const auto without = [](std::string text, const std::string& line) {
    return text.erase(text.find(line), text.find('\n', text.find(line)) + 1 - text.find(line));
  };
  const auto with = [](std::string text, const std::string& old, const std::string& other) {
    return text.replace(text.find(old), old.size(), other);
  };
  const std::string rows = "0.0 0\n0.01 1\n0.02 2\n";
  const std::string row = "1 2 3 4 1\n";
  const struct {
    std::string text;
    const char* message;
  } cases[] = {
      {"", "b:0: expected TRIAXYS BUOY DATA REPORT, got the end of the file"},
      {report_title, "b:2: expected lines of numbers after the header, got the end of the file"},
      {with(energies, "NON-DIRECTIONAL", "MEAN DIRECTIONAL") + rows,
       "b:3: expected TYPE = DIRECTIONAL SPECTRUM or NON-DIRECTIONAL SPECTRUM, got \"MEAN DIRECTIONAL "
       "SPECTRUM\""},
      {with(energies, "01-31", "02-31") + rows,
       "b:4: expected a date such as 2018-01-31 21:00(UTC), got \"2018-02-31"},
      {with(energies, "=   3", "=   2.5") + rows,
       "b:5: expected a count that fits the size of the file, got 2.5"},
      {with(energies, "=   3", "=   x") + rows,
       "b:5: expected a number after NUMBER OF FREQUENCIES =, got \"x\""},
      {without(energies, "TYPE") + rows, "b:9: expected a line \"TYPE = ...\" before the numbers, got none"},
      {without(densities, "DIRECTION SPACING") + row, "expected a line \"DIRECTION SPACING (DEG) = ...\""},
      {energies + "0.0 0\n0.01 1\n", "b:11: expected a frequency and a density, got the end of the file"},
      {energies + "0.0 0 1\n", "b:10: expected a frequency and a density, got 3 numbers"},
      {energies + "0.0 0\n0.01 -1\n", "b:11: expected a variance density >= 0, got -1"},
      {energies + "0.0 0\n0.01 1\n0.01 2\n", "b:12: expected a frequency above 0.01 Hz, got 0.01"},
      {energies + rows + "0.03 3\n",
       "b:13: expected the end of the file after 3 frequencies, got \"0.03 3\""},
      {densities + row + "1 2 3 4\n", "b:13: expected 5 densities, got 4"},
      {densities + "1 2 3 4 5 6\n",
       "b:12: expected columns that cover the circle once, got 6 columns 90 degrees apart"},
      {densities + row + row + "1 2 -3 4 1\n", "b:14: expected a variance density >= 0, got -3"},
      {with(densities, "0.010", "0.000") + row + row + row, "expected a frequency above 0.1 Hz, got 0.1"},
  };
  for (const auto& c : cases) {
    const std::string hint =
        expect_error(ErrorKind::bad_input, c.message, [&] { parse_triaxys(c.text, "b"); });
    EXPECT_FALSE(hint.empty()) << c.message;
  }
}

}  // namespace
}  // namespace offing::spectra
