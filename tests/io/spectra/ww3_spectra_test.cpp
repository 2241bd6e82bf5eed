#include "host/io/spectra/ww3_spectra.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host/io/spectra/write_ww3_spectra.h"
#include "tests/io/spectra/spectrum_checks.h"
#include "tests/io/temporary_folder.h"
#include "tests/ocl/expect_error.h"

namespace offing::spectra {
namespace {

using test::expect_contract;
using test::expect_error;

// Two frequencies, four directions: toward east (bearing pi/2), north, west, south, as WAVEWATCH III orders
// them.
const std::string head =
    "'WAVEWATCH III SPECTRA'     2     4     2 'grid              '\n 0.100E+00 0.200E+00\n"
    "  0.157E+01  0.000E+00  0.471E+01  0.314E+01\n";
const std::string point_a = "'it''s A   '  40.98-171.12      46.6   1.45 225.6   0.18  94.1\n";
const std::string point_b = "'B         '  41.98 171.12      -1.0   1.45 225.6   0.18  94.1\n";
// Frequency runs fastest: at 0.1 Hz all energy goes east, at 0.2 Hz a third goes north and two thirds south.
const std::string density =
    "  0.400E+01  0.000E+00  0.000E+00  0.100E+01\n  0.000E+00  0.000E+00  0.000E+00 0.200D+01\n";
const std::string small_file = head + "20220912 060000\n" + point_a + density + point_b + density +
                               "20220912 070030\n" + point_a + density + point_b + density;

TEST(Ww3, ReadsTimesAndPoints) {
  const auto spectra = parse_ww3(small_file, "f.spec");
  ASSERT_EQ(spectra.size(), 4U);
  for (const WaveSpectrum& spectrum : spectra) expect_contract(spectrum);
  EXPECT_EQ(spectra[0].station, "it's A");
  EXPECT_EQ(spectra[1].station, "B");
  EXPECT_EQ(spectra[1].time_utc, "2022-09-12T06:00Z");
  EXPECT_EQ(spectra[2].time_utc, "2022-09-12T07:00:30Z");
  EXPECT_EQ(spectra[0].latitude_deg, 40.98);
  EXPECT_EQ(spectra[0].longitude_deg, -171.12);
  EXPECT_EQ(spectra[0].depth_m, 46.6);
  EXPECT_EQ(spectra[1].depth_m, std::nullopt);
}

// Fails if bearings are taken for "from", for mathematical angles, or the two loops are swapped.
TEST(Ww3, DirectionsAreOfTravel) {
  const WaveSpectrum spectrum = parse_ww3(small_file, "f.spec")[0];
  EXPECT_NEAR(spectrum.energy[0], 4.0 * std::numbers::pi / 2, 1e-9);
  EXPECT_NEAR(spectrum.energy[1], 3.0 * std::numbers::pi / 2, 1e-9);
  // Directions are printed with three digits: the grid is off by up to 0.002 rad here.
  EXPECT_NEAR(std::abs(test::row_moment(spectrum, 0, 1) - 1.0), 0.0, 3e-3);
  EXPECT_NEAR(std::abs(test::row_moment(spectrum, 1, 1) - std::complex<double>(0.0, 1.0 / 3.0)), 0.0, 3e-3);
}

// Fails if a printed digit is lost: the file has seven, so relative differences stay below 5e-7 (energy) and
// absolute ones of D below 5e-7 of its largest value, here 2.
TEST(Ww3Writer, RoundTrips) {
  const TemporaryFolder folder;
  std::vector<WaveSpectrum> spectra = parse_ww3(small_file, "f.spec");
  spectra[1].time_utc = spectra[0].time_utc = "";
  write_ww3_spectra(folder.path() / "out.spec", spectra);
  const auto again = parse_ww3(test::read_text(folder.path() / "out.spec"), "out.spec");
  ASSERT_EQ(again.size(), spectra.size());
  for (std::size_t i = 0; i < spectra.size(); ++i) {
    expect_contract(again[i]);
    EXPECT_EQ(again[i].station, spectra[i].station);
    EXPECT_EQ(again[i].time_utc, spectra[i].time_utc);
    EXPECT_EQ(again[i].latitude_deg, spectra[i].latitude_deg);
    EXPECT_EQ(again[i].longitude_deg, spectra[i].longitude_deg);
    EXPECT_EQ(again[i].depth_m, spectra[i].depth_m);
    ASSERT_EQ(again[i].directions_rad.size(), spectra[i].directions_rad.size());
    for (std::size_t f = 0; f < 2; ++f) {
      EXPECT_NEAR(again[i].energy[f], spectra[i].energy[f], 5e-7 * spectra[i].energy[f]);
      EXPECT_NEAR(std::abs(test::row_moment(again[i], f, 1) - test::row_moment(spectra[i], f, 1)), 0.0, 2e-6);
    }
  }
}

/// 12 records, the newest first, all energy of direction 40 of `directions`, with a peak at 0.1 Hz.
std::vector<WaveSpectrum> narrow_sea(std::size_t frequencies, std::size_t directions) {
  std::vector<WaveSpectrum> spectra;
  for (int hour = 11; hour >= 0; --hour) {
    WaveSpectrum& spectrum = spectra.emplace_back();
    spectrum.station = "buoy";
    spectrum.time_utc = fmt::format("2022-09-12T{:02}:00Z", hour);
    for (std::size_t j = 0; j < directions; ++j)
      spectrum.directions_rad.push_back(2.0 * std::numbers::pi * static_cast<double>(j) /
                                        static_cast<double>(directions));
    for (std::size_t i = 0; i < frequencies; ++i) {
      const double f_hz = 0.03 + 0.4 * static_cast<double>(i) / static_cast<double>(frequencies);
      spectrum.frequencies_hz.push_back(f_hz);
      spectrum.energy.push_back((1.0 + hour) * std::exp(-std::pow((f_hz - 0.1) / 0.03, 2)));
      for (std::size_t j = 0; j < directions; ++j)
        spectrum.spreading.push_back(j == 40 ? static_cast<double>(directions) / (2.0 * std::numbers::pi)
                                             : 0.0);
    }
  }
  return spectra;
}

// Other readers take two digits for each count, and need times that rise. Fails if a count has three, if the
// newest record comes first, if a record loses variance (seven digits are written), or its waves turn: half a
// cell of 7.2 degrees is 0.063 rad, and three digits of a direction are 0.005. 102 directions become 51 by
// twos, 101 are prime.
TEST(Ww3Writer, WritesWhatOtherReadersTake) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "out.spec";
  for (const auto& [frequencies, directions] :
       {std::pair<std::size_t, std::size_t>{150, 102}, {20, 101}, {99, 99}}) {
    const std::vector<WaveSpectrum> given = narrow_sea(frequencies, directions);
    write_ww3_spectra(out, given);
    const auto written = parse_ww3(test::read_text(out), "out.spec");
    ASSERT_EQ(written.size(), given.size());
    for (std::size_t i = 0; i < written.size(); ++i) {
      const WaveSpectrum& source = given[given.size() - 1 - i];
      expect_contract(written[i]);
      EXPECT_LE(written[i].frequencies_hz.size(), 99u);
      EXPECT_LE(written[i].directions_rad.size(), 99u);
      EXPECT_EQ(written[i].time_utc, source.time_utc);
      EXPECT_NEAR(variance_m2(written[i]) / variance_m2(source), 1.0, 1e-5)
          << frequencies << " " << directions;
      const double turned = std::arg(test::row_moment(written[i], 9, 1) / test::row_moment(source, 9, 1));
      EXPECT_LT(std::abs(turned), 0.07) << directions;
    }
  }
}

TEST(Ww3Writer, KeepsUnknownsUnknown) {
  const TemporaryFolder folder;
  WaveSpectrum spectrum = parse_ww3(small_file, "f.spec")[0];
  spectrum.latitude_deg.reset();
  spectrum.longitude_deg.reset();
  spectrum.depth_m.reset();
  spectrum.station = "a name\nthat's much too long";
  write_ww3_spectra(folder.path() / "out.spec", std::span(&spectrum, 1));
  const WaveSpectrum again = parse_ww3(test::read_text(folder.path() / "out.spec"), "out.spec")[0];
  EXPECT_EQ(again.latitude_deg, std::nullopt);
  EXPECT_EQ(again.longitude_deg, std::nullopt);
  EXPECT_EQ(again.depth_m, std::nullopt);
  EXPECT_EQ(again.station, "a name tha");
}

// Fails if the file would say something else than the spectra.
TEST(Ww3Writer, RefusesWhatTheFormatCannotHold) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "out.spec";
  const auto write = [&](const std::vector<WaveSpectrum>& spectra) { write_ww3_spectra(out, spectra); };
  std::vector<WaveSpectrum> spectra = parse_ww3(small_file, "f.spec");
  expect_error(ErrorKind::bad_input, "expected spectra to write, got none", [&] { write({}); });
  expect_error(ErrorKind::bad_input, "expected 2 spectra at 2022-09-12T07:00:30Z, got 1", [&] {
    write({spectra[0], spectra[1], spectra[2]});
  });
  spectra[1].frequencies_hz[0] = 0.05;
  expect_error(ErrorKind::bad_input, "record 1: expected the grid of record 0 (", [&] { write(spectra); });
  spectra[0].directions_rad.clear();
  spectra[0].spreading.clear();
  expect_error(ErrorKind::bad_input, "record 0: expected a directional spectrum", [&] { write(spectra); });
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Ww3Errors, NameFileAndLine) {
  const std::string grid = "'WAVEWATCH III SPECTRA' ";
  const std::string time = "20220912 060000\n";
  const struct {
    std::string text;
    const char* message;
  } cases[] = {
      {"", "f.spec:0: expected 'WAVEWATCH III SPECTRA', got the end of the file"},
      {"'OTHER' 2 2 1 'g'\n", "f.spec:1: expected 'WAVEWATCH III SPECTRA', got 'OTHER'"},
      {"'WAVEWATCH III SPECTRA\n", "f.spec:1: expected 'WAVEWATCH III SPECTRA', got"},
      {grid + "99999999 2 1 'g'\n", "f.spec:1: expected the number of frequencies, got 1e+08"},
      {grid + "-2 2 1 'g'\n", "f.spec:1: expected the number of frequencies, got -2"},
      {grid + "2.5 2 1 'g'\n", "f.spec:1: expected the number of frequencies, got 2.5"},
      {grid + "15 15 1 'g'\n",
       "f.spec:1: expected counts that fit the size of the file, got 15 x 15 densities"},
      {grid + "2 2 1 g\n" + std::string(50, ' '), "f.spec:1: expected the name of the grid in quotes"},
      {grid + "2 2 1 'g'\n0.2 0.1\n0 3.14\n", "expected a frequency above 0.2 Hz, got 0.1"},
      {grid + "2 2 1 'g'\n0.1 0.1\n0 3.14\n", "expected a frequency above 0.1 Hz, got 0.1"},
      {grid + "2 2 1 'g'\n0.1 0.2\n1 1\n", "is listed twice"},
      {grid + "2 2 1 'g'\n0.1 nan\n1 1\n", "f.spec:2: expected a frequency in Hz, got \"nan\""},
      {head + "20221312 060000\n", "f.spec:4: expected a date and time such as 20220912 060000"},
      {head + time + "A 1 2 3\n", "f.spec:5: expected the name of a point in quotes"},
      {head + time + point_a + "1 2 3 4 5 6 7\n",
       "f.spec:6: expected a density in m^2/Hz/rad, got the end of the file"},
      {head + time + point_a + "1 2 3 4 5 6 7 -8\n", "f.spec:5: expected a variance density >= 0, got -8"},
      {head + time + point_a + "1 2 3 4 5 6 7 inf\n",
       "f.spec:6: expected a density in m^2/Hz/rad, got \"inf\""},
      {head + time + point_a + density + point_b + density.substr(0, density.size() - 1) + " 9\n",
       "f.spec:10: expected a new line after the last density"},
  };
  for (const auto& c : cases) {
    const std::string hint =
        expect_error(ErrorKind::bad_input, c.message, [&] { parse_ww3(c.text, "f.spec"); });
    EXPECT_FALSE(hint.empty()) << c.message;
  }
}

}  // namespace
}  // namespace offing::spectra
