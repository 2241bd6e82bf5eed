// Hours of sun and shadows from the command line: GeoTIFFs where the map lies.
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/maps/walled_map_test.h"

namespace offing::test {
namespace {

class TerrainSun : public WalledMapTest {
 protected:
  ProgramResult sun(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"terrain", "sun", path("grid.asc"), "-o", path("sun.tif")});
    return run_offing(arguments);
  }

  const std::vector<std::string> place_{"--latitude-deg", "46.5", "--longitude-deg", "8"};
};

// A day of March in Switzerland: 12.2 h of sun in the open, less beside a wall 20 m high. In the mask of the
// morning its west is in shadow, in that of the afternoon its east. Fails if rows or columns are swapped, the
// raster lies elsewhere, bands are exchanged, or times are not UTC.
TEST_F(TerrainSun, WritesHoursSunlightAndMasksWhereTheMapLies) {
  std::vector<std::string> arguments = place_;
  arguments.insert(arguments.end(), {"--from", "2026-03-20", "--to", "2026-03-20", "--step", "1h", "--json",
                                     "--masks", path("masks.tif")});
  const ProgramResult result = sun(arguments);
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["from"], "2026-03-20T00:00Z");
  EXPECT_EQ(json["to"], "2026-03-21T00:00Z");
  EXPECT_EQ(json["times_up"], 12);  // 06 to 17 h: the sun rises at 05:31 and sets at 17:42
  EXPECT_NEAR(json["hours"]["highest"].get<double>(), 12.2, 0.2);
  EXPECT_TRUE(has_text("sun.tif", "role=\"unittype\">h<"));
  EXPECT_TRUE(has_text("sun.tif", "role=\"unittype\">kWh/m2<"));
  EXPECT_TRUE(has_text("masks.tif", ">sunlit at 2026-03-20T06:00Z<"));
  const HeightMap hours = band("sun.tif", 1), energy = band("sun.tif", 2);
  EXPECT_EQ(hours.georeference.origin_x, 5005.0);
  EXPECT_EQ(hours.georeference.origin_y, 905.0);
  EXPECT_EQ(hours.is_void[hours.index(0, 20)], 1);
  // 280 m before the wall, which hides the first 4 degrees of the sun's way up; 10 m before it, where tan h =
  // 2 cos (azimuth - 90) hides it until 1.2 h before noon at 11:35; 20 m behind it, it shines until 14 h.
  EXPECT_NEAR(hours.heights_m[hours.index(2, 10)], 11.7f, 0.2f);
  EXPECT_NEAR(hours.heights_m[hours.index(29, 10)], 7.3f, 0.3f);
  EXPECT_NEAR(hours.heights_m[hours.index(32, 10)], 8.4f, 0.3f);
  EXPECT_GT(energy.heights_m[energy.index(2, 10)], 4.0f);
  EXPECT_LT(energy.heights_m[energy.index(2, 10)], 6.0f);
  const HeightMap morning = band("masks.tif", 3), afternoon = band("masks.tif", 10);
  EXPECT_EQ(morning.heights_m[morning.index(27, 10)], 0.0f);
  EXPECT_EQ(morning.heights_m[morning.index(33, 10)], 255.0f);
  EXPECT_EQ(afternoon.heights_m[afternoon.index(27, 10)], 255.0f);
  EXPECT_EQ(afternoon.heights_m[afternoon.index(33, 10)], 0.0f);
  EXPECT_EQ(morning.is_void[morning.index(0, 20)], 1);
}

// Fails if a flag has no effect.
TEST_F(TerrainSun, FlagsChangeTheAnswer) {
  const auto json_of = [&](std::vector<std::string> flags) {
    flags.insert(flags.end(), {"--json", "--force"});
    flags.insert(flags.end(), place_.begin(), place_.end());
    const ProgramResult result = sun(flags);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output);
  };
  const auto usual = json_of({"--from", "2026-03-20", "--to", "2026-03-20"});
  const auto half = json_of({"--from", "2026-03-20T00:00", "--to", "2026-03-20T12:00Z"});
  EXPECT_NEAR(half["hours"]["highest"].get<double>(), 6.4, 0.2);
  const auto shifted =
      json_of({"--from", "2026-03-20T00:00", "--to", "2026-03-20T12:00", "--utc-offset-h", "3"});
  EXPECT_NEAR(shifted["hours"]["highest"].get<double>(), 3.4, 0.2);
  EXPECT_EQ(shifted["from"], "2026-03-19T21:00Z");
  const auto hazy = json_of({"--from", "2026-03-20", "--to", "2026-03-20", "--turbidity", "6"});
  EXPECT_LT(hazy["energy_kwh_per_m2"]["highest"].get<double>(),
            0.8 * usual["energy_kwh_per_m2"]["highest"].get<double>());
  EXPECT_EQ(hazy["hours"], usual["hours"]);
  EXPECT_EQ(json_of({"--from", "2026-03-20", "--to", "2026-03-21", "--step", "30min"})["step_s"], 1800);
}

TEST_F(TerrainSun, RefusesWithAHint) {
  const auto refuse = [&](std::vector<std::string> arguments, const std::string& expected,
                          bool is_placed = true) {
    if (is_placed) arguments.insert(arguments.end(), place_.begin(), place_.end());
    const ProgramResult result = sun(arguments);
    EXPECT_EQ(result.exit_code, 2) << expected;
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n"));
    EXPECT_THAT(result.errors, ::testing::HasSubstr(expected));
    EXPECT_FALSE(std::ifstream(path("sun.tif")).is_open());
  };
  const std::vector<std::string> day{"--from", "2026-06-21", "--to", "2026-06-21"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), day.begin(), day.end());
    return more;
  };
  refuse({"--to", "2026-06-21"}, "--from");
  for (const std::string day_of_none : {"2026-06-31", "2026-21-06"}) {
    refuse({"--from", day_of_none, "--to", "2026-07-01"},
           "--from: expected a day that exists, as YYYY-MM-DD");
  }
  for (const std::string other_form : {"21-06-2026", "2026/06/21"}) {
    refuse({"--from", other_form, "--to", "2026-07-01"},
           "--from: expected a day or a time of the years 1901 to 2099, as YYYY-MM-DD, ");
  }
  refuse({"--from", "2026-06-21T09:30-04:30", "--to", "2026-07-01"},
         "hint: write --from 2026-06-21T09:30 --utc-offset-h -4.5\n");
  refuse({"--from", "June", "--to", "2026-07-01"}, "--from: expected a day or a time");
  refuse({"--from", "2026-06-21", "--to", "2160-06-21"}, "--to: expected a day or a time of the years 1901");
  refuse({"--from", "2026-06-21", "--to", "2026-06-20"}, "--to: expected a time after --from");
  refuse(with({"--step", "0h"}), "--step: expected a time");
  refuse(with({"--step", "-5min"}), "--step: expected a time");
  refuse(with({"--step", "15"}), "--step: expected a time");
  refuse(with({"--step", "30m"}), "hint: write --step 30min\n");
  refuse(with({"--step", "two"}), "--step: expected a time");
  refuse({"--from", "1990-01-01", "--to", "2026-06-20", "--step", "1min"},
         "--step: expected at most 100000 steps");
  refuse(with({"--turbidity", "0"}), "--turbidity: expected");
  refuse(with({"--azimuths", "1"}), "--azimuths: expected");
  refuse(with({}), "grid.asc: expected a map with a place in the world, found no coordinate system\n", false);
  refuse(with({"--latitude-deg", "46"}), "--longitude-deg", false);
  refuse(with({"--latitude-deg", "95", "--longitude-deg", "8"}), "--latitude-deg: expected", false);
  refuse({"--from", "2026-06-21T00:00", "--to", "2026-06-21T02:00", "--masks", path("masks.tif")},
         "--masks: expected");
  EXPECT_FALSE(std::ifstream(path("masks.tif")).is_open());
}

}  // namespace
}  // namespace offing::test
