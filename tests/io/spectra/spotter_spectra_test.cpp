#include "host/io/spectra/spotter_spectra.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/io/spectra/spectrum_checks.h"
#include "tests/ocl/expect_error.h"

namespace offing::spectra {
namespace {

using test::expect_contract;
using test::expect_error;

// Waves that travel 30 degrees north of east, so that they come from 240 degrees; r1 = 0.8.
const std::string json_head = R"({"data":{"spotterId":"SPOT-0070","waves":[],"frequencyData":[)";
const std::string json_record =
    R"({"frequency":[0.1,0.2],"df":[0.1,0.1],"a1":[0.692820323,0.692820323],"b1":[0.4,0.4],)"
    R"("a2":[0.25,0.25],"b2":[0.433012702,0.433012702],"varianceDensity":[1.5,0.5],"direction":[240,240],)"
    R"("directionalSpread":[36.2371,36.2371],"timestamp":"2018-02-14T00:27:19.000Z","latitude":-61.5,)"
    "\n"
    R"("longitude":173.25})";
const std::string csv_names =
    "Battery Voltage (V) ,Epoch Time ,Latitude (deg) ,Longitude (deg) ,f_0 ,f_1 ,df_0 ,df_1 ,"
    "varianceDensity_0 ,varianceDensity_1 ,direction_0 ,direction_1 ,directionalSpread_0 ,"
    "directionalSpread_1 ,Surface Temperature (\xC2\xB0"
    "C) ,Partition0 Start Frequency (hz)\n";
const std::string csv_row =
    "  4.07 ,1518568039 ,  -61.5 ,173.25 ,0.1 ,0.2 ,0.1 ,0.1 ,1.5 ,0.5 ,240 ,240 ,36.2371 ,36.2371 ,15 ,-\n";

void expect_the_sea(const WaveSpectrum& spectrum) {
  expect_contract(spectrum);
  EXPECT_EQ(spectrum.time_utc, "2018-02-14T00:27:19Z");
  EXPECT_EQ(spectrum.latitude_deg, -61.5);
  EXPECT_EQ(spectrum.longitude_deg, 173.25);
  EXPECT_EQ(spectrum.energy, (std::vector<double>{1.5, 0.5}));
  // The frame's angles grow from east to south. Tables of spreadings keep moments to 1e-3.
  EXPECT_NEAR(std::abs(test::row_moment(spectrum, 0, 1) - std::polar(0.8, -std::numbers::pi / 6)), 0.0, 1e-3);
}

// Fails if moments are turned, mirrored or taken for those of where waves come from, in either form of the
// file.
TEST(Spotter, ReadsJson) {
  const auto spectra = parse_spotter(json_head + json_record + "]}}", "a.json");
  ASSERT_EQ(spectra.size(), 1U);
  expect_the_sea(spectra[0]);
  EXPECT_EQ(spectra[0].station, "SPOT-0070");
  EXPECT_NEAR(std::abs(test::row_moment(spectra[0], 0, 2) - std::polar(0.5, -std::numbers::pi / 3)), 0.0,
              1e-3);
}

TEST(Spotter, ReadsCsv) {
  const auto spectra = parse_spotter(csv_names + csv_row + csv_row, "x/SPOT-1.csv.gz");
  ASSERT_EQ(spectra.size(), 2U);
  expect_the_sea(spectra[1]);
  EXPECT_EQ(spectra[0].station, "SPOT-1");
}

// Fails if a missing value becomes a wave, or its frequency or record is not left out.
TEST(Spotter, LeavesOutMissingValues) {
  std::string gap = csv_names;
  gap.replace(gap.find("f_1"), 3, "f_1 ,f_2");
  gap.replace(gap.find("varianceDensity_1"), 17, "varianceDensity_1 ,varianceDensity_2");
  gap.replace(gap.find("direction_1"), 11, "direction_1 ,direction_2");
  gap.replace(gap.find("directionalSpread_1"), 19, "directionalSpread_1 ,directionalSpread_2");
  const auto spectra = parse_spotter(
      gap + "4 ,1518568039 ,- ,- ,0.1 ,0.2 ,0.3 ,0.1 ,0.1 ,1.5 ,- ,0.5 ,240 ,240 ,- ,36 ,36 ,- ,15 ,-\n" +
          "4 ,1518568039 ,- ,- ,0.1 ,0.2 ,0.3 ,0.1 ,0.1 ,1.5 ,- ,- ,240 ,240 ,240 ,36 ,36 ,36 ,15 ,-\n",
      "a.csv");
  EXPECT_EQ(spectra.size(), 1U);
}

TEST(SpotterErrors, NameFileAndPlace) {
  const auto with = [](std::string text, const std::string& old, const std::string& other) {
    return text.replace(text.find(old), old.size(), other);
  };
  const std::string whole = json_head + json_record + "]}}";
  const std::string table = csv_names + csv_row;
  const struct {
    std::string text;
    const char* message;
  } cases[] = {
      {"", "b:0: expected a line of column names, got the end of the file"},
      {"{", "b:1: expected JSON, got a fault after 2 bytes"},
      {with(whole, "\n", "\n?"), "b:2: expected JSON, got a fault after"},
      {with(whole, "1.5", "1e999"), "b: expected JSON with finite numbers, got others"},
      {"{}", "b: expected a list data.frequencyData, got none"},
      {json_head + "]}}", "b: expected at least one record with two densities, got none"},
      {with(whole, "\"varianceDensity\":[1.5,", "\"varianceDensity\":["),
       "b: data.frequencyData[0]: expected 2 values of varianceDensity, got 1"},
      {with(whole, "\"a1\":[0.69", "\"a1\":[1.69"),
       "b: data.frequencyData[0]: expected a1 within [-1, 1], got 1.69"},
      {with(whole, "1.5", "\"1\""),
       "b: data.frequencyData[0].varianceDensity: expected numbers, or null where"},
      {with(whole, "1.5", "-1.5"), "b: data.frequencyData[0]: expected a variance density >= 0, got -1.5"},
      {with(whole, "[0.1,0.2]", "[0.2,0.2]"),
       "b: data.frequencyData[0]: expected a frequency above 0.2 Hz, got 0.2"},
      {with(whole, "T00", "T25"), "b: data.frequencyData[0].timestamp: expected a time such as"},
      {with(table, "Epoch", "Epic"), "b:1: expected a column Epoch Time, got none"},
      {with(table, "1518568039", "1e99"), "b:2: expected a time in seconds since 1970, got 1e+99"},
      {with(table, ",15 ,-", ""), "b:2: expected 16 columns, got 14"},
      {with(table, ",1.5", ",x"), "b:2: expected a number, or - where it is missing, got \"x\""},
      {with(table, "36.2371", "200"), "b:2: expected a direction within 360 degrees and a spread within"},
  };
  for (const auto& c : cases) {
    const std::string hint =
        expect_error(ErrorKind::bad_input, c.message, [&] { parse_spotter(c.text, "b"); });
    EXPECT_FALSE(hint.empty()) << c.message;
  }
}

}  // namespace
}  // namespace offing::spectra
