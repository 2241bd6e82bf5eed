#include "host/scene/schema/unused_parameters.h"

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/scene/file/scene_file.h"
#include "host/scene/schema/parameter_table.h"

namespace offing::scene {
namespace {

using Settings = std::vector<std::pair<const char*, const char*>>;  // key, value

enum class Record { none, without_directions, directional };

struct Case {
  const char* name;
  Settings settings;
  Record record = Record::none;
  double depth_m = std::numeric_limits<double>::infinity();
  std::vector<std::string> lines = {};
};

std::vector<std::string> unused(const Case& asked) {
  Scene scene;
  for (const auto& [key, value] : asked.settings) {
    const Parameter& row = *find_parameter(key);
    store(scene, row, read_flag_value(row, value), Place{"a.toml:1:2: " + std::string(key), ""});
  }
  Sea sea;
  sea.spectrum.dispersion.depth_m = asked.depth_m;
  if (asked.record != Record::none) {
    scene.ocean.spectrum_file = "buoy";
    sea.measured.emplace();
    sea.measured->frequencies_hz = {0.1, 0.5};
    if (asked.record == Record::directional) {
      sea.measured->directions_rad = {0.0, 2.0, 4.0};
    }
  }
  return unused_parameters(scene, sea);
}

class UnusedParameters : public testing::TestWithParam<Case> {};

// Each fails if a value that was set and has no part in the sea is passed over in silence, is told without
// its place and the reason, or if one that has a part is complained of.
TEST_P(UnusedParameters, AreToldWithPlaceAndReason) {
  std::vector<std::string> expected;
  for (const std::string& line : GetParam().lines) {
    expected.push_back("a.toml:1:2: " + line);
  }
  EXPECT_THAT(unused(GetParam()), testing::ElementsAreArray(expected));
}

const Settings winds = {{"wind.speed_mps", "9"},
                        {"wind.direction_deg", "8"},
                        {"ocean.wind_speed_mps", "9"},
                        {"ocean.wind_direction_deg", "8"}};
const Settings spreadings = {
    {"ocean.spreading", "hasselmann"}, {"ocean.spreading_exponent", "3"}, {"ocean.spreading_swell", "0.5"}};
const Settings models = {{"ocean.fetch_m", "1000"},
                         {"ocean.depth_factor", "kitaigorodskii"},
                         {"ocean.gamma", "2"},
                         {"ocean.phillips_constant", "0.001"},
                         {"ocean.phillips_cutoff_m", "0.01"},
                         {"ocean.phillips_upwind", "0.5"},
                         {"ocean.swell_hs_m", "2"},
                         {"ocean.swell_period_s", "9"},
                         {"ocean.swell_bandwidth_hz", "0.01"},
                         {"ocean.swell_exponent", "50"}};

Settings operator+(Settings first, const Settings& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

const Case cases[] = {
    {.name = "nothing_set", .settings = {}},
    {.name = "used_by_any_sea",
     .settings =
         {{"world.seed", "3"}, {"ocean.size", "64"}, {"ocean.depth_m", "9"}, {"ocean.choppiness", "1"}}},
    {.name = "no_ground",
     .settings = {{"ocean.shoals", "off"}},
     .lines = {"ocean.shoals: not used: the scene has no terrain"}},
    {.name = "no_gerstner_waves",
     .settings = {{"ocean.gerstner.count", "0"}, {"ocean.gerstner.split_wavelength_m", "40"}},
     .lines = {"ocean.gerstner.split_wavelength_m: not used: there are no Gerstner waves"}},
    {.name = "gerstner_waves",
     .settings = {{"ocean.gerstner.count", "4"}, {"ocean.gerstner.split_wavelength_m", "40"}}},
    {.name = "no_record",
     .settings = {{"ocean.record", "0"}, {"ocean.tail_hz", "3"}},
     .lines = {"ocean.record: not used: there is no measured spectrum",
               "ocean.tail_hz: not used: there is no measured spectrum"}},
    {.name = "jonswap",
     .settings = winds + spreadings + models,
     .lines = {"ocean.depth_factor: not used: the spectrum is jonswap",
               "ocean.phillips_constant: not used: the spectrum is jonswap",
               "ocean.phillips_cutoff_m: not used: the spectrum is jonswap",
               "ocean.phillips_upwind: not used: the spectrum is jonswap",
               "ocean.swell_hs_m: not used: the spectrum is jonswap",
               "ocean.swell_period_s: not used: the spectrum is jonswap",
               "ocean.swell_bandwidth_hz: not used: the spectrum is jonswap",
               "ocean.swell_exponent: not used: the spectrum is jonswap",
               "ocean.spreading_exponent: not used: the spreading is hasselmann"}},
    {.name = "tma_in_deep_water",
     .settings = {{"ocean.spectrum", "tma"}, {"ocean.depth_factor", "kitaigorodskii"}, {"ocean.gamma", "2"}},
     .lines = {"ocean.depth_factor: not used: the water is deep"}},
    {.name = "tma",
     .settings = {{"ocean.spectrum", "tma"}, {"ocean.depth_factor", "kitaigorodskii"}, {"ocean.gamma", "2"}},
     .depth_m = 9.0},
    {.name = "phillips",
     .settings =
         Settings{{"ocean.spectrum", "phillips"}, {"ocean.phillips_upwind", "0.5"}} + spreadings + winds,
     .lines =
         {"ocean.spreading: not used: the spectrum is phillips, which has a spreading of its own",
          "ocean.spreading_exponent: not used: the spectrum is phillips, which has a spreading of its own",
          "ocean.spreading_swell: not used: the spectrum is phillips, which has a spreading of its own"}},
    {.name = "swell",
     .settings = Settings{{"ocean.spectrum", "swell"}, {"ocean.swell_exponent", "50"}} + winds,
     .lines = {"wind.speed_mps: not used: the spectrum is swell"}},
    {.name = "swell_whose_foam_is_given",
     .settings = {{"ocean.spectrum", "swell"},
                  {"ocean.wind_speed_mps", "9"},
                  {"ocean.foam.fraction", "0.02"}},
     .lines = {"ocean.wind_speed_mps: not used: the spectrum is swell"}},
    {.name = "cosine", .settings = {{"ocean.spreading", "cosine"}, {"ocean.spreading_exponent", "3"}}},
    {.name = "record_without_directions",
     .settings = winds + Settings{{"ocean.spreading", "hasselmann"}, {"ocean.record", "0"}},
     .record = Record::without_directions,
     .lines = {"wind.speed_mps: not used: a measured sea uses only its own wind, ocean.wind_speed_mps"}},
    {.name = "record_with_a_spreading_without_wave_age",
     .settings = {{"ocean.wind_speed_mps", "9"}, {"ocean.spreading", "cosine"}, {"ocean.foam.fraction", "0"}},
     .record = Record::without_directions,
     .lines = {"ocean.wind_speed_mps: not used: the spreading is cosine"}},
    {.name = "record_with_directions",
     .settings = Settings{{"ocean.spectrum", "pm"}, {"ocean.gamma", "2"}, {"ocean.swell_hs_m", "2"}} +
                 spreadings + winds,
     .record = Record::directional,
     .lines = {"wind.speed_mps: not used: a measured sea uses only its own wind, ocean.wind_speed_mps",
               "wind.direction_deg: not used: buoy has directions of its own",
               "ocean.spectrum: not used: the sea comes from buoy",
               "ocean.wind_direction_deg: not used: buoy has directions of its own",
               "ocean.gamma: not used: the sea comes from buoy",
               "ocean.swell_hs_m: not used: the sea comes from buoy",
               "ocean.spreading: not used: buoy has directions of its own",
               "ocean.spreading_exponent: not used: buoy has directions of its own",
               "ocean.spreading_swell: not used: buoy has directions of its own"}},
    {.name = "tail_that_the_record_has",
     .settings = {{"ocean.tail_hz", "0.4"}},
     .record = Record::directional,
     .lines = {"ocean.tail_hz: not used: buoy reaches 0.5 Hz by itself"}},
    {.name = "tail", .settings = {{"ocean.tail_hz", "0.5"}}, .record = Record::directional},
    {.name = "cascades_beside_patches",
     .settings = {{"ocean.cascade_count", "2"}, {"ocean.cascade.patch_m", "100"}},
     .lines = {"ocean.cascade_count: not used: the patches are given"}},
    {.name = "place_without_a_date",
     .settings = {{"world.latitude_deg", "50"}, {"sun.time_scale", "60"}},
     .lines = {"world.latitude_deg: not used: sun.time_utc is not given",
               "sun.time_scale: not used: sun.time_utc is not given"}},
    {.name = "dated_sun", .settings = {{"world.longitude_deg", "50"}, {"sun.time_utc", "2024-06-21T12:00Z"}}},
    {.name = "cascades", .settings = {{"ocean.cascade_count", "2"}}},
};

INSTANTIATE_TEST_SUITE_P(Seas, UnusedParameters, testing::ValuesIn(cases),
                         [](const auto& tested) { return std::string(tested.param.name); });

// Fails if a light that does not light the clouds is passed over in silence, or one that does is complained
// of.
TEST(UnusedLights, AreToldWithPlaceAndReason) {
  const auto unused = [&](const std::string& text) {
    return unused_parameters(parse_scene("version = 1\n" + text, "a.toml", ""));
  };
  std::string lights;
  for (int i = 0; i < 4; ++i) lights += "[[light]]\nazimuth_deg = 9\nilluminance_klx = 5\n";
  EXPECT_THAT(unused(lights), testing::IsEmpty());
  EXPECT_THAT(unused("[[cloud]]\n" + lights),
              testing::ElementsAre(
                  testing::HasSubstr("does not light the clouds: clouds use only the first 3 lights")));
  EXPECT_THAT(unused("[clouds]\nlight = \"harris\"\n[[cloud]]\n[[light]]\nazimuth_deg = 9\n"),
              testing::ElementsAre(testing::HasSubstr(
                  "a.toml:6:15: light.azimuth_deg: does not light the clouds: clouds.light "
                  "is harris")));
}

}  // namespace
}  // namespace offing::scene
