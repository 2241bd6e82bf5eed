#include "host/io/spectra/netcdf_spectra.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/io/spectra/netcdf_units.h"
#include "tests/io/spectra/netcdf_writer.h"
#include "tests/io/spectra/spectrum_checks.h"
#include "tests/ocl/expect_error.h"
#include "tests/ocl/log_capture.h"

namespace offing::spectra {
namespace {

using test::expect_contract;
using test::expect_error;
using test::NetcdfFormat;
using test::TestNetcdf;

std::vector<WaveSpectrum> parse(const TestNetcdf& file, NetcdfFormat format = NetcdfFormat::classic) {
  const std::string bytes = test::netcdf_bytes(file, format);
  return parse_netcdf(std::as_bytes(std::span(bytes)), "f.nc");
}

constexpr double fill = 9.96921e36;

// As ww3_ounp writes: two times, two stations, frequencies 0.1 and 0.2 Hz, directions 90 (toward east), 0,
// 270, 180 degrees. First spectrum: at 0.1 Hz 4 m^2/Hz/rad toward east, at 0.2 Hz 1 toward north and 2 toward
// south; the second station's first is missing; at the second time both are twice the first.
TestNetcdf ww3_file() {
  return {
      {{"time", 2}, {"station", 2}, {"string16", 4}, {"frequency", 2}, {"direction", 4}},
      {{"time",
        {"time"},
        {{"units", "days since 1990-01-01 00:00:00"}, {"calendar", "standard"}},
        {0.0, 365.25}},
       {"station_name", {"station", "string16"}, {}, {}, "A1  B234"},
       {"longitude", {"time", "station"}, {{"units", "degree_east"}}, {-71.5, 10.0, -71.5, 10.0}},
       {"latitude", {"time", "station"}, {{"units", "degree_north"}}, {40.5, 50.0, 40.5, 50.0}},
       {"dpt", {"time", "station"}, {{"units", "m"}, {"_FillValue", "", fill}}, {46.5, 100.0, 46.5, fill}},
       {"frequency", {"frequency"}, {{"units", "s-1"}}, {0.1, 0.2}},
       {"direction",
        {"direction"},
        {{"units", "degree"}, {"standard_name", "sea_surface_wave_to_direction"}},
        {90, 0, 270, 180}},
       {"efth",
        {"time", "station", "frequency", "direction"},
        {{"units", "m2 s rad-1"}, {"_FillValue", "", fill}},
        {4, 0, 0, 0, 0, 1, 0, 2, fill, fill, fill, fill, fill, fill, fill, fill,
         8, 0, 0, 0, 0, 2, 0, 4, 8,    0,    0,    0,    0,    2,    0,    4}}},
      {}};
}

void expect_first_ww3_spectrum(const WaveSpectrum& spectrum, double factor) {
  expect_contract(spectrum);
  EXPECT_NEAR(spectrum.energy[0], factor * 4.0 * std::numbers::pi / 2, 1e-9);
  EXPECT_NEAR(spectrum.energy[1], factor * 3.0 * std::numbers::pi / 2, 1e-9);
  EXPECT_NEAR(std::abs(test::row_moment(spectrum, 0, 1) - 1.0), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(test::row_moment(spectrum, 1, 1) - std::complex<double>(0.0, 1.0 / 3.0)), 0.0, 1e-9);
}

TEST(NetcdfWw3, ReadsTimesAndStations) {
  for (const NetcdfFormat format : {NetcdfFormat::classic, NetcdfFormat::hdf5}) {
    const auto spectra = parse(ww3_file(), format);
    ASSERT_EQ(spectra.size(), 3U);
    expect_first_ww3_spectrum(spectra[0], 1.0);
    expect_first_ww3_spectrum(spectra[1], 2.0);
    EXPECT_EQ(spectra[0].station, "A1");
    EXPECT_EQ(spectra[2].station, "B234");
    EXPECT_EQ(spectra[0].time_utc, "1990-01-01T00:00Z");
    EXPECT_EQ(spectra[1].time_utc, "1991-01-01T06:00Z");
    EXPECT_EQ(spectra[0].latitude_deg, 40.5);
    EXPECT_EQ(spectra[2].longitude_deg, 10.0);
    EXPECT_EQ(spectra[0].depth_m, 46.5);
    EXPECT_EQ(spectra[2].depth_m, std::nullopt);
  }
}

// Each fails if that unit, convention or packing is not respected: the same sea told in another way.
TEST(NetcdfWw3, RespectsUnitsAndConventions) {
  const struct {
    const char* name;
    std::function<void(TestNetcdf&)> change;
  } cases[] = {
      {"per degree",
       [](TestNetcdf& file) {
         auto& efth = file.variable("efth");
         efth.attributes[0].text = "m2 s degree-1";
         for (double& value : efth.values) value = value == fill ? fill : value * std::numbers::pi / 180.0;
       }},
      {"energy",
       [](TestNetcdf& file) {
         auto& efth = file.variable("efth");
         efth.attributes[0].text = "J/m2/Hz/rad";
         for (double& value : efth.values) value = value == fill ? fill : value * 1025.0 * 9.81;
       }},
      {"radians per second",
       [](TestNetcdf& file) {
         auto& frequency = file.variable("frequency");
         frequency.attributes[0].text = "rad s-1";
         for (double& value : frequency.values) value *= 2.0 * std::numbers::pi;
       }},
      {"origins in radians",
       [](TestNetcdf& file) {
         auto& direction = file.variable("direction");
         direction.attributes = {{"units", "radians"}, {"standard_name", "sea_surface_wave_from_direction"}};
         for (double& value : direction.values) value = (value + 180.0) * std::numbers::pi / 180.0;
       }},
      {"cartesian",
       [](TestNetcdf& file) {
         file.attributes = {{"Directional_convention", "cartesian"}};
         for (double& value : file.variable("direction").values) value = 90.0 - value;
       }},
      {"no standard_name", [](TestNetcdf& file) { file.variable("direction").attributes.pop_back(); }},
      {"other names",
       [](TestNetcdf& file) {
         for (auto& dimension : file.dimensions) {
           if (dimension.name == "frequency") dimension.name = "freq";
           if (dimension.name == "direction") dimension.name = "dir";
         }
         file.variable("frequency").dimensions = {"freq"};
         file.variable("direction").dimensions = {"dir"};
         file.variable("efth").dimensions = {"time", "station", "freq", "dir"};
         file.variable("frequency").name = "freq";
         file.variable("direction").name = "dir";
       }},
      {"scale and offset",
       [](TestNetcdf& file) {
         auto& efth = file.variable("efth");
         efth.attributes.push_back({"scale_factor", "", 0.5});
         efth.attributes.push_back({"add_offset", "", -1.0});
         for (double& value : efth.values) value = value == fill ? fill : (value + 1.0) / 0.5;
       }},
      {"direction before frequency",
       [](TestNetcdf& file) {
         auto& efth = file.variable("efth");
         efth.dimensions = {"time", "station", "direction", "frequency"};
         const std::vector<double> before = efth.values;
         for (std::size_t i = 0; i < before.size(); ++i)
           efth.values[i] = before[i / 8 * 8 + i % 2 * 4 + i % 8 / 2];
       }},
      {"hours",
       [](TestNetcdf& file) {
         auto& time = file.variable("time");
         time.attributes[0].text = "hours since 1990-01-01T00:00:00Z";
         time.values = {0.0, 8766.0};
       }},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.name);
    TestNetcdf file = ww3_file();
    c.change(file);
    const auto spectra = parse(file);
    ASSERT_EQ(spectra.size(), 3U);
    expect_first_ww3_spectrum(spectra[0], 1.0);
    expect_first_ww3_spectrum(spectra[2], 2.0);
    EXPECT_EQ(spectra[1].time_utc, "1991-01-01T06:00Z");
  }
}

// As SWAN writes: packed densities with a scale a spectrum, radians, a grid of points, seconds.
// Fails if what wavespectra leaves unsaid is taken for radians, or for directions that waves go to: all comes
// from 90 degrees, 0.5 m^2/Hz/degree over a quarter of the circle.
TEST(NetcdfWavespectra, ReadsWithoutAttributes) {
  const TestNetcdf bare{{{"time", 1}, {"freq", 2}, {"dir", 4}},
                        {{"time", {"time"}, {{"units", "seconds since 1970-01-01"}}, {1577836800.0}},
                         {"freq", {"freq"}, {}, {0.1, 0.2}},
                         {"dir", {"dir"}, {}, {0, 90, 180, 270}},
                         {"efth", {"time", "freq", "dir"}, {}, {0, 0.5, 0, 0, 0, 0.5, 0, 0}}},
                        {}};
  const auto spectra = parse(bare);
  ASSERT_EQ(spectra.size(), 1U);
  expect_contract(spectra[0]);
  EXPECT_EQ(spectra[0].time_utc, "2020-01-01T00:00Z");
  EXPECT_NEAR(spectra[0].energy[1], 45.0, 1e-9);
  EXPECT_NEAR(test::mean_from_deg(spectra[0]), 90.0, 1e-9);
}

TEST(NetcdfSwan, ReadsPackedGrids) {
  TestNetcdf file{{{"time", 1}, {"yc", 1}, {"xc", 3}, {"frequency", 2}, {"direction", 4}},
                  {{"time", {"time"}, {{"units", "seconds since 1970-01-01"}}, {1600000000}},
                   {"longitude", {"yc", "xc"}, {}, {1.0, 2.0, 3.0}},
                   {"latitude", {"yc", "xc"}, {}, {51.0, 52.0, 53.0}},
                   {"frequency", {"frequency"}, {{"units", "s-1"}}, {0.1, 0.2}},
                   {"direction",
                    {"direction"},
                    {{"units", "radians"}, {"standard_name", "sea_surface_wave_from_direction"}},
                    {0.0, std::numbers::pi / 2, std::numbers::pi, 1.5 * std::numbers::pi}},
                   {"density",
                    {"time", "yc", "xc", "frequency", "direction"},
                    {{"units", "m2 s rad-1"}, {"_FillValue", "", -32767}},
                    {0,      0,      0,      4,      2, 0, 1, 0, -32767, -32767, -32767, -32767,
                     -32767, -32767, -32767, -32767, 0, 0, 0, 4, 2,      0,      1,      0},
                    "",
                    true},
                   {"scale_density", {"time", "yc", "xc"}, {}, {0.5, 1.0, 2.0}}},
                  {{"Directional_convention", "nautical"}}};
  const auto spectra = parse(file);
  ASSERT_EQ(spectra.size(), 2U);
  EXPECT_EQ(spectra[0].station, "xc 1");
  EXPECT_EQ(spectra[1].station, "xc 3");
  EXPECT_EQ(spectra[1].latitude_deg, 53.0);
  EXPECT_EQ(spectra[0].time_utc, "2020-09-13T12:26:40Z");
  EXPECT_NEAR(spectra[0].energy[0], 0.5 * 4.0 * std::numbers::pi / 2, 1e-9);
  EXPECT_NEAR(spectra[1].energy[1], 2.0 * 3.0 * std::numbers::pi / 2, 1e-9);
  // From the west is toward east; two thirds from the north are toward south.
  EXPECT_NEAR(std::abs(test::row_moment(spectra[0], 0, 1) - 1.0), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(test::row_moment(spectra[0], 1, 1) - std::complex<double>(0.0, 1.0 / 3.0)), 0.0, 1e-9);
}

TEST(NetcdfSwan, ReadsEnergyWithoutDirections) {
  const TestNetcdf file{{{"points", 2}, {"frequency", 3}},
                        {{"frequency", {"frequency"}, {{"units", "Hz"}}, {0.1, 0.2, 0.3}},
                         {"energy_1d", {"points", "frequency"}, {{"units", "m2 s"}}, {1, 2, 3, 4, 5, 6}}},
                        {}};
  const auto spectra = parse(file);
  ASSERT_EQ(spectra.size(), 2U);
  EXPECT_EQ(spectra[1].station, "points 2");
  EXPECT_EQ(spectra[1].energy, (std::vector<double>{4, 5, 6}));
  EXPECT_FALSE(spectra[1].is_directional());
  EXPECT_EQ(spectra[1].time_utc, "");
}

// Fails if directions that a file holds are dropped without a word, or a file without them is warned of.
TEST(NetcdfSwan, WarnsOfDirectionsThatItDoesNotRead) {
  TestNetcdf file{{{"points", 1}, {"frequency", 2}},
                  {{"frequency", {"frequency"}, {{"units", "Hz"}}, {0.1, 0.2}},
                   {"energy_1d", {"points", "frequency"}, {{"units", "m2 s"}}, {1, 2}}},
                  {}};
  const test::LogCapture log;
  parse(file);
  EXPECT_EQ(log.text(), "");
  file.variables.push_back({"theta_1d", {"points", "frequency"}, {{"units", "degree"}}, {270, 280}});
  EXPECT_FALSE(parse(file).front().is_directional());
  EXPECT_THAT(log.text(), testing::HasSubstr("theta_1d and spread_1d do not state their conventions"));
}

TEST(NetcdfErrors, NameTheVariable) {
  const struct {
    const char* message;
    std::function<void(TestNetcdf&)> change;
  } cases[] = {
      {"expected a variable efth, density, energy or energy_1d",
       [](TestNetcdf& f) { f.variable("efth").name = "hs"; }},
      {"efth: expected units of m2 s rad-1, got \"\"",
       [](TestNetcdf& f) { f.variable("efth").attributes.clear(); }},
      {"efth: expected units of m2 s rad-1, got \"m\"",
       [](TestNetcdf& f) { f.variable("efth").attributes[0].text = "m"; }},
      {"efth: expected units of m2 s rad-1, got \"m2 s\"",
       [](TestNetcdf& f) { f.variable("efth").attributes[0].text = "m2 s"; }},
      {"frequency: expected units of s-1, got \"km\"",
       [](TestNetcdf& f) { f.variable("frequency").attributes[0].text = "km"; }},
      {"frequency: expected a frequency above 0.2 Hz, got 0.1",
       [](TestNetcdf& f) {
         f.variable("frequency").values = {0.2, 0.1};
       }},
      {"frequency: expected a frequency above 0.1 Hz, got nan",
       [](TestNetcdf& f) {
         f.variable("frequency").values = {0.1, std::nan("")};
       }},
      {"expected a dimension and a variable frequency",
       [](TestNetcdf& f) { f.variable("frequency").name = "k"; }},
      {"expected a variable direction in degrees or radians",
       [](TestNetcdf& f) { f.variable("direction").attributes[0].text = "m"; }},
      {"direction: expected a standard_name",
       [](TestNetcdf& f) { f.variable("direction").attributes[1].text = "x"; }},
      {"is listed twice",
       [](TestNetcdf& f) {
         f.variable("direction").values = {0, 90, 90, 180};
       }},
      {"direction: expected finite directions",
       [](TestNetcdf& f) { f.variable("direction").values[1] = INFINITY; }},
      {"time: expected units such as", [](TestNetcdf& f) { f.variable("time").attributes[0].text = "days"; }},
      {"time: expected units such as",
       [](TestNetcdf& f) { f.variable("time").attributes[1].text = "360_day"; }},
      {"efth: expected a variance density >= 0, got -4",
       [](TestNetcdf& f) { f.variable("efth").values[0] = -4.0; }},
      {"efth: expected a variance density >= 0, got inf",
       [](TestNetcdf& f) { f.variable("efth").values[0] = INFINITY; }},
      {"efth: expected at least one spectrum with data",
       [](TestNetcdf& f) { f.variable("efth").values.assign(32, fill); }},
      {"frequency: expected 2 values, got 4",
       [](TestNetcdf& f) {
         f.variable("frequency").dimensions = {"direction"};
         f.variable("frequency").values = {1, 2, 3, 4};
       }},
  };
  for (const auto& c : cases) {
    TestNetcdf file = ww3_file();
    c.change(file);
    const std::string hint = expect_error(ErrorKind::bad_input, c.message, [&] { parse(file); });
    EXPECT_FALSE(hint.empty()) << c.message;
  }
}

// Fails if a header can claim memory: 2^40 densities that a chunked file never stored.
TEST(NetcdfErrors, BoundsTheMemory) {
  TestNetcdf file = ww3_file();
  file.dimensions[0].length = std::size_t{1} << 30;
  file.variable("time").values.clear();
  for (auto& variable : file.variables) {
    if (variable.name == "efth" || variable.name == "dpt" || variable.name.ends_with("itude"))
      variable.values.clear();
  }
  file.variable("time").dimensions = {};
  file.variable("time").name = "clock";
  const std::string bytes = test::netcdf_bytes(file, NetcdfFormat::hdf5);
  expect_error(ErrorKind::bad_input, "efth: expected at most 134217728 values",
               [&] { parse_netcdf(std::as_bytes(std::span(bytes)), "f.nc"); });
}

// Fails if a length or offset that libnetcdf would trust gets past the check of the header: each field of
// four bytes set to values that wrap, overflow or reach past the end. What is left must be spectra or an
// Error.
TEST(NetcdfErrors, EveryDamagedFieldIsReadOrRefused) {
  const std::string bytes = test::netcdf_bytes(ww3_file());
  for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
    for (const std::string_view field :
         {std::string_view("\x7f\xff\xff\xff", 4), std::string_view("\xff\xff\xff\xff", 4),
          std::string_view("\0\0\0\0", 4), std::string_view("\0\0\1\0", 4)}) {
      std::string damaged = bytes;
      damaged.replace(at, 4, field);
      try {
        for (const WaveSpectrum& spectrum : parse_netcdf(std::as_bytes(std::span(damaged)), "f.nc")) {
          expect_contract(spectrum);
        }
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      }
    }
  }
}

// Fails if a cut file ends in anything but an Error, or if values that are not there are read as zeros.
TEST(NetcdfErrors, EveryPrefixIsAnError) {
  const std::string bytes = test::netcdf_bytes(ww3_file());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const std::string cut = bytes.substr(0, length);
    expect_error(ErrorKind::bad_input,
                 "f.nc: ", [&] { parse_netcdf(std::as_bytes(std::span(cut)), "f.nc"); });
  }
}

TEST(NetcdfUnits, ReadsTheUsualSpellings) {
  for (const char* unit :
       {"m2 s rad-1", "m2/Hz/rad", "m^2 Hz^-1 rad^-1", "m**2 s radian**-1", "m2 s radians-1"}) {
    ASSERT_TRUE(parse_density_unit(unit)) << unit;
    EXPECT_TRUE(parse_density_unit(unit)->is_directional);
    EXPECT_EQ(parse_density_unit(unit)->in_si, 1.0);
  }
  for (const char* unit : {"m2 s degree-1", "m2/Hz/degr", "m2 Hz-1 deg-1", "m2/Hz/deg"}) {
    ASSERT_TRUE(parse_density_unit(unit)) << unit;
    EXPECT_NEAR(parse_density_unit(unit)->in_si, 180.0 / std::numbers::pi, 1e-12);
  }
  for (const char* unit : {"", "m", "m2", "m2 rad-1", "m2 s K-1", "m2 s rad-1 x", "cm2 s rad-1", "J s"}) {
    EXPECT_FALSE(parse_density_unit(unit)) << unit;
  }
  EXPECT_EQ(parse_time_unit("seconds since 1970-1-1")->origin_unix, 0);
  EXPECT_EQ(parse_time_unit("days since 2000-01-01 12:30:05.0 UTC")->iso_time(0.5), "2000-01-02T00:30:05Z");
  EXPECT_EQ(parse_time_unit("days since 1990-01-01")->iso_time(std::nan("")), "");
  EXPECT_EQ(parse_time_unit("days since 1990-01-01")->iso_time(1e30), "");
  for (const char* unit : {"", "days", "days since", "fortnights since 1990-01-01", "days since 1990-13-01",
                           "days since 99999999999-01-01", "since 1990-01-01"}) {
    EXPECT_FALSE(parse_time_unit(unit)) << unit;
  }
}

}  // namespace
}  // namespace offing::spectra
