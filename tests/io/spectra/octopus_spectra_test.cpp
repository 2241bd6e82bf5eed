#include "host/io/spectra/octopus_spectra.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/io/spectra/spectrum_checks.h"
#include "tests/ocl/expect_error.h"

namespace offing::spectra {
namespace {

using test::expect_contract;
using test::expect_error;

const std::string site_head =
    "Forecast valid for 11-Mar-2018 00:00:00\nnfreqs,3\nndir,4\nnrecs,1\nLatitude, -39.9723\n"
    "Longitude, 173.3090\nDepth,102.5\n\n";
const std::string record_head =
    "CCYYMM,DDHHmm,LPoint,WD,WS,ETot\n201803,'110600,maari_20180311_06z,123,11.64,0.0759\n"
    "freq,0.10,0.20,0.40,anspec\n";
const std::string record_rows =
    "0,0.0,0.0,0.0,0.0,\n90,0.01,0.02,0.03,0.06,\n180,0.0,0.0,0.0,0.0,\n270,0.0,0.0,0.0,0.0,\n";
const std::string record_sums = "fSpec,0.01,0.02,0.03,\nden,0.2,0.13,0.3,\n\n";

// Fails if the sum of the variances in the file, 0.06 m^2, is not that of the spectrum, or waves from the
// east travel anywhere but to the west.
TEST(Octopus, KeepsVariances) {
  const auto spectra = parse_octopus(site_head + record_head + record_rows + record_sums, "a.oct");
  ASSERT_EQ(spectra.size(), 1U);
  expect_contract(spectra[0]);
  EXPECT_EQ(spectra[0].station, "maari");
  EXPECT_EQ(spectra[0].time_utc, "2018-03-11T06:00Z");
  EXPECT_EQ(spectra[0].latitude_deg, -39.9723);
  EXPECT_EQ(spectra[0].longitude_deg, 173.309);
  EXPECT_EQ(spectra[0].depth_m, 102.5);
  EXPECT_NEAR(variance_m2(spectra[0]), 0.06, 1e-15);
  EXPECT_NEAR(test::mean_from_deg(spectra[0]), 90.0, 1e-9);
}

// Fails if a second site_head is taken for a fault, or a record with missing values for waves.
TEST(Octopus, ReadsSitesAndLeavesOutMissingRecords) {
  std::string missing = record_rows;
  missing.replace(missing.find("0.02"), 4, "-99999");
  std::string two = site_head;
  two.replace(two.find("nrecs,1"), 7, "nrecs,2");
  const auto spectra = parse_octopus(two + record_head + missing + record_sums + record_head + record_rows +
                                         record_sums + site_head + record_head + record_rows + record_sums,
                                     "a.oct");
  EXPECT_EQ(spectra.size(), 2U);
}

TEST(OctopusErrors, NameFileAndLine) {
  const auto with = [](std::string text, const std::string& old, const std::string& other) {
    return text.replace(text.find(old), old.size(), other);
  };
  const std::string whole = site_head + record_head + record_rows + record_sums;
  const struct {
    std::string text;
    const char* message;
  } cases[] = {
      {"", "b:0: expected Forecast valid for ..., got the end of the file"},
      {"x", "b:1: expected Forecast valid for ... or the end of the file, got \"x\""},
      {with(whole, "ndir", "nd"), "b:3: expected a line that begins with ndir, got \"nd\""},
      {with(whole, "nfreqs,3", "nfreqs,3e9"), "b:2: expected a count after nfreqs,, got 3e+09"},
      {with(whole, "nrecs,1", "nrecs,100"),
       "b:4: expected counts that fit the size of the file, got 1200 values"},
      {with(whole, "Depth,102.5", "Depth,"), "b:7: expected a number after Depth,, got the end of the line"},
      {with(whole, "'110600", "'320600"),
       "b:10: expected a time such as 201803,'110000, got \"201803,320600\""},
      {with(whole, "0.10,0.20", "0.10,0.10"), "b:11: expected a frequency above 0.1 Hz, got 0.1"},
      {with(whole, ",0.03,0.06,", ""), "b:13: expected a variance in m^2, got the end of the line"},
      {with(whole, "270,", "275,"), "b:15: expected 4 bearings evenly spaced over the circle, got others"},
      {with(whole, "fSpec", "f"), "b:16: expected a line that begins with fSpec, got \"f\""},
      {with(whole, "0.02", "-1"), "b: expected at least one record without missing values, got none"},
      {site_head + record_head, "b:11: expected a line for each direction, got the end of the file"},
      {whole + record_head, "b:19: expected Forecast valid for ... or the end of the file, got \"CCYYMM"},
  };
  for (const auto& c : cases) {
    const std::string hint =
        expect_error(ErrorKind::bad_input, c.message, [&] { parse_octopus(c.text, "b"); });
    EXPECT_FALSE(hint.empty()) << c.message;
  }
}

}  // namespace
}  // namespace offing::spectra
