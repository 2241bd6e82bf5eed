#include "host/io/spectra/ndbc_spectra.h"

#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/io/spectra/spectrum_checks.h"
#include "tests/ocl/expect_error.h"

namespace offing::spectra {
namespace {

using test::expect_contract;
using test::expect_error;

constexpr std::string_view energy =
    "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) spec_3 (freq_3) ... >\n"
    "2020 06 08 03 50 0.225 0.000 (0.050) 4.000 (0.100) 2.000 (0.150) 0.500 (0.200)\n"
    "2020 06 08 02 50 9.999 1.000 (0.050) 999.0 (0.100) 2.000 (0.150) MM (0.200)\n";
constexpr std::string_view alpha1 =
    "#YY  MM DD hh mm alpha1_1 (freq_1) alpha1_2 (freq_2) alpha1_3 (freq_3) ... >\n"
    "2020 06 08 03 50 999.0 (0.050) 225.0 (0.100) 0.0 (0.150) 999.0 (0.200)\n";
constexpr std::string_view alpha2 =
    "#YY  MM DD hh mm alpha2_1 (freq_1) alpha2_2 (freq_2) alpha2_3 (freq_3) ... >\n"
    "2020 06 08 03 50 999.0 (0.050) 225.0 (0.100) 999.0 (0.150) 999.0 (0.200)\n";
constexpr std::string_view r1 =
    "#YY  MM DD hh mm r1_1 (freq_1) r1_2 (freq_2) r1_3 (freq_3) ... >\n"
    "2020 06 08 03 50 999.0 (0.050) 0.80 (0.100) 0.50 (0.150) 999.0 (0.200)\n";
constexpr std::string_view r2 =
    "#YY  MM DD hh mm r2_1 (freq_1) r2_2 (freq_2) r2_3 (freq_3) ... >\n"
    "2020 06 08 03 50 999.0 (0.050) 0.40 (0.100) 999.0 (0.150) 999.0 (0.200)\n";

NdbcCompanions all_companions() {
  return {NamedText{alpha1, "a1"}, NamedText{alpha2, "a2"}, NamedText{r1, "r1"}, NamedText{r2, "r2"}};
}

TEST(NdbcRealtime, ReadsDensitiesAndLeavesMissingOnesOut) {
  const auto spectra = parse_ndbc(energy, "41010.data_spec");
  ASSERT_EQ(spectra.size(), 2U);
  EXPECT_EQ(spectra[0].station, "41010");
  EXPECT_EQ(spectra[0].time_utc, "2020-06-08T03:50Z");
  EXPECT_EQ(spectra[0].energy, (std::vector<double>{0.0, 4.0, 2.0, 0.5}));
  EXPECT_EQ(spectra[1].frequencies_hz, (std::vector<double>{0.05, 0.15}));
  EXPECT_EQ(spectra[1].energy, (std::vector<double>{1.0, 2.0}));
  EXPECT_FALSE(spectra[0].is_directional());
}

// Fails if alpha is taken for a direction of travel or turned the wrong way: waves from the south-west (225)
// travel to the north-east, which is -45 degrees from east toward south; waves from the north travel toward
// +z (90).
TEST(NdbcRealtime, TurnsOriginsIntoDirectionsOfTravel) {
  const auto spectra = parse_ndbc(energy, "41010.data_spec", all_companions());
  ASSERT_EQ(spectra.size(), 2U);
  const WaveSpectrum& first = spectra[0];
  expect_contract(first);
  ASSERT_TRUE(first.is_directional());
  EXPECT_NEAR(std::abs(test::row_moment(first, 1, 1) - std::polar(0.8, -std::numbers::pi / 4)), 0.0, 1e-3);
  EXPECT_NEAR(std::abs(test::row_moment(first, 1, 2) - std::polar(0.4, -std::numbers::pi / 2)), 0.0, 1e-3);
  EXPECT_NEAR(std::abs(test::row_moment(first, 2, 1) - std::polar(0.5, std::numbers::pi / 2)), 0.0, 1e-3);
  // Where r2 is missing the spreading is cos^2s with s = 1, so that r2 = 0.
  EXPECT_NEAR(std::abs(test::row_moment(first, 2, 2)), 0.0, 1e-3);
}

// Fails if a frequency without directions blends foreign ones in: it takes the nearest frequency's.
TEST(NdbcRealtime, GivesFrequenciesWithoutDirectionsTheNearestOnes) {
  const auto spectra = parse_ndbc(energy, "41010.data_spec", all_companions());
  EXPECT_EQ(test::row_moment(spectra[0], 0, 1), test::row_moment(spectra[0], 1, 1));
  EXPECT_EQ(test::row_moment(spectra[0], 3, 1), test::row_moment(spectra[0], 2, 1));
}

TEST(NdbcRealtime, LeavesRecordsWithoutACompanionRowNonDirectional) {
  const auto spectra = parse_ndbc(energy, "41010.data_spec", all_companions());
  EXPECT_FALSE(spectra[1].is_directional());
}

TEST(NdbcRealtime, NeedsAlpha1AndR1ForDirections) {
  NdbcCompanions companions = all_companions();
  companions.r1.reset();
  EXPECT_FALSE(parse_ndbc(energy, "41010.data_spec", companions)[0].is_directional());
  companions = all_companions();
  companions.alpha2.reset();
  const auto spectra = parse_ndbc(energy, "41010.data_spec", companions);
  // cos^2s with s = 4: r2 = 4 * 3 / (5 * 6).
  EXPECT_NEAR(std::abs(test::row_moment(spectra[0], 1, 2)), 0.4, 1e-3);
}

TEST(NdbcRealtime, ReadsCrlf) {
  std::string text;
  for (const char c : energy) {
    if (c == '\n') text += '\r';
    text += c;
  }
  EXPECT_EQ(parse_ndbc(text, "41010.data_spec").size(), 2U);
}

// Historical files hold r in hundredths; each header below is one that NDBC has used.
TEST(NdbcHistorical, ReadsAllHeaders) {
  const struct {
    const char* text;
    const char* time;
  } cases[] = {
      {"#YY  MM DD hh mm   .0200   .0325   .0375\n2020 01 02 03 40   0.00   1.50   0.25\n",
       "2020-01-02T03:40Z"},
      {"YYYY MM DD hh   .0200   .0325   .0375\n2003 01 02 03   0.00   1.50   0.25\n", "2003-01-02T03:00Z"},
      {"YY MM DD hh 0.020 0.0325 0.0375\n96 01 02 03 0.00 1.50 0.25\n", "1996-01-02T03:00Z"},
      {"YY MM DD hh .0200 .0325 .0375\n05 01 02 03 0.00 1.50 0.25\n", "2005-01-02T03:00Z"},
  };
  for (const auto& c : cases) {
    const auto spectra = parse_ndbc(c.text, "46042w2020.txt");
    ASSERT_EQ(spectra.size(), 1U);
    EXPECT_EQ(spectra[0].time_utc, c.time);
    EXPECT_EQ(spectra[0].station, "46042");
    EXPECT_EQ(spectra[0].frequencies_hz, (std::vector<double>{0.02, 0.0325, 0.0375}));
    EXPECT_EQ(spectra[0].energy, (std::vector<double>{0.0, 1.5, 0.25}));
  }
}

TEST(NdbcHistorical, ScalesMomentsInHundredths) {
  const std::string head = "#YY  MM DD hh mm   .0500   .1000   .1500\n2020 01 02 03 40 ";
  const std::string w = head + "1.00 2.00 1.00\n";
  const std::string d = head + "270 270 270\n";
  const std::string j = head + "80 90 999\n";
  const std::string k = head + "40.0 70.0 70.0\n";
  const auto spectra = parse_ndbc(
      w, "46042w2020.txt", {NamedText{d, "d"}, NamedText{d, "i"}, NamedText{j, "j"}, NamedText{k, "k"}});
  expect_contract(spectra[0]);
  EXPECT_NEAR(std::abs(test::row_moment(spectra[0], 0, 1) - 0.8), 0.0, 1e-3);
  EXPECT_NEAR(std::abs(test::row_moment(spectra[0], 1, 2) - 0.7), 0.0, 1e-3);
}

// Fails if rows marked missing become records of 99 m^2/Hz.
TEST(NdbcHistorical, DropsRowsMarkedMissing) {
  const std::string text =
      "#YY  MM DD hh mm   .0500   .1000\n2020 01 02 03 40 99.00 99.00\n2020 01 02 04 40 999.0 999.0\n"
      "2020 01 02 05 40 99.00 1.0\n";
  const auto spectra = parse_ndbc(text, "46042w2020.txt");
  ASSERT_EQ(spectra.size(), 1U);
  EXPECT_EQ(spectra[0].time_utc, "2020-01-02T05:40Z");
}

TEST(NdbcHistorical, AHeaderMayChangeTheFrequencies) {
  const std::string text =
      "YY MM DD hh .0500 .1000\n96 01 02 03 1.0 2.0\nYY MM DD hh .0300 .0500 .1000\n96 01 02 04 1.0 2.0 "
      "3.0\n";
  const auto spectra = parse_ndbc(text, "46042w1996.txt");
  ASSERT_EQ(spectra.size(), 2U);
  EXPECT_EQ(spectra[1].frequencies_hz.size(), 3U);
}

TEST(NdbcCompanionNames, FollowNdbc) {
  const auto realtime = ndbc_companion_paths("/a/41010.data_spec");
  ASSERT_TRUE(realtime);
  EXPECT_EQ(realtime->alpha1, "/a/41010.swdir");
  EXPECT_EQ(realtime->alpha2, "/a/41010.swdir2");
  EXPECT_EQ(realtime->r1, "/a/41010.swr1");
  EXPECT_EQ(realtime->r2, "/a/41010.swr2");
  const auto historical = ndbc_companion_paths("/a/tplm2w1999.txt");
  ASSERT_TRUE(historical);
  EXPECT_EQ(historical->alpha1, "/a/tplm2d1999.txt");
  EXPECT_EQ(historical->alpha2, "/a/tplm2i1999.txt");
  EXPECT_EQ(historical->r1, "/a/tplm2j1999.txt");
  EXPECT_EQ(historical->r2, "/a/tplm2k1999.txt");
  EXPECT_FALSE(ndbc_companion_paths("w.txt"));
  EXPECT_FALSE(ndbc_companion_paths("41010h2020.txt"));
  EXPECT_FALSE(ndbc_companion_paths(""));
}

// Each fails if that damage goes unnoticed; the part of the message says which line it must name.
TEST(NdbcErrors, NameFileAndLine) {
  const std::string head = "#YY  MM DD hh mm   .0500   .1000\n";
  const struct {
    std::string text;
    const char* message;
  } cases[] = {
      {"", "f.txt:0: expected an NDBC header line"},
      {"2020 01 02\n", "f.txt:1: expected an NDBC header line starting with #YY"},
      {"#YY MM\n", "f.txt:1: expected the date columns"},
      {"#YY MM DD hh mm WVHT SwH\n", "f.txt:1: expected columns of spectral densities"},
      {"#YY MM DD hh mm alpha1_1 (freq_1)\n2020 01 02 03 40 1 (0.1)\n",
       "expected spectral densities, got directions"},
      {head, "expected at least one row with two densities, got none"},
      {head + "2020 01 02 03 40 1.0\n",
       "f.txt:2: expected a value for each frequency, got the end of the line"},
      {head + "2020 01 02 03 40 1.0 2.0 3.0\n", "f.txt:2: expected 2 values"},
      {head + "2020 01 02 03 40 1.0 nan\n", "f.txt:2: expected a value for each frequency, got \"nan\""},
      {head + "2020 01 02 03 40 1.0 -2.0\n",
       "f.txt:2: expected a variance density >= 0 m^2/Hz, got -2 at 0.1 Hz"},
      {head + "2020 13 02 03 40 1.0 2.0\n", "f.txt:2: expected a date"},
      {head + "2020 01 02.5 03 40 1.0 2.0\n", "f.txt:2: expected a date"},
      {"#YY MM DD hh mm .05 .05\n2020 01 02 03 40 1.0 2.0\n", "f.txt:2: expected a frequency above 0.05 Hz"},
      {"#YY MM DD hh mm .1 .05\n2020 01 02 03 40 1.0 2.0\n", "f.txt:2: expected a frequency above 0.1 Hz"},
      {"#YY MM DD hh mm .1 x\n2020 01 02 03 40 1.0 2.0\n", "f.txt:1: expected a frequency in Hz, got \"x\""},
      {"#YY MM DD hh mm Sep_Freq < spec_1 (freq_1)\n2020 06 08 03 50 0.2 1.0 (0.05) 2.0 0.1\n",
       "f.txt:2: expected a frequency in brackets"},
      {"#YY MM DD hh mm Sep_Freq < spec_1 (freq_1)\n2020 06 08 03 50 0.2 1.0 (0.05) 2.0\n",
       "f.txt:2: expected a frequency in brackets"},
  };
  for (const auto& c : cases) {
    const std::string hint =
        expect_error(ErrorKind::bad_input, c.message, [&] { parse_ndbc(c.text, "f.txt"); });
    EXPECT_FALSE(hint.empty()) << c.message;
  }
}

TEST(NdbcErrors, NameTheCompanion) {
  const std::string bad_alpha = "#YY MM DD hh mm alpha1_1 (freq_1)\n2020 06 08 03 50 361.0 (0.05)\n";
  NdbcCompanions companions = all_companions();
  companions.alpha1 = NamedText{bad_alpha, "x.swdir"};
  expect_error(ErrorKind::bad_input, "x.swdir:2: expected a value within [0, 360], got 361",
               [&] { parse_ndbc(energy, "x.data_spec", companions); });
  companions.alpha1 = NamedText{r1, "x.swdir"};
  expect_error(ErrorKind::bad_input, "x.swdir:1: expected the columns that the file's name promises",
               [&] { parse_ndbc(energy, "x.data_spec", companions); });
}

}  // namespace
}  // namespace offing::spectra
