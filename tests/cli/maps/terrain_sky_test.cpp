// Sky-view factors and horizons from the command line: GeoTIFFs where the map lies.
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

class TerrainSky : public WalledMapTest {
 protected:
  ProgramResult sky(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"terrain", "sky", path("grid.asc"), "-o", path("sky.tif")});
    return run_offing(arguments);
  }
};

// Fails if rows or columns are swapped, the raster lies elsewhere than the map, voids are no nodata, or a
// band is of another azimuth than it says: the wall is 100 m east of column 20, at an angle of atan
// 0.2, 11.31 degrees, and level ground is everywhere else.
TEST_F(TerrainSky, WritesFactorsAndHorizonsWhereTheMapLies) {
  const ProgramResult result = sky({"--horizons", path("horizons.tif"), "--azimuths", "16", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["void_posts"], 1);
  EXPECT_EQ(json["azimuths"], 16);
  EXPECT_LT(json["mean"].get<double>(), json["highest"].get<double>());
  EXPECT_TRUE(has_text("sky.tif", ">sky-view factor<"));
  EXPECT_TRUE(has_text("horizons.tif", ">horizon at azimuth 22.5 deg<"));
  EXPECT_TRUE(has_text("horizons.tif", "role=\"unittype\">deg<"));
  const HeightMap factors = band("sky.tif", 1);
  ASSERT_EQ(factors.columns, 41);
  ASSERT_EQ(factors.rows, 21);
  EXPECT_EQ(factors.georeference.origin_x, 5005.0);
  EXPECT_EQ(factors.georeference.origin_y, 905.0);
  EXPECT_EQ(factors.georeference.step_y, -10.0);
  EXPECT_EQ(factors.is_void[factors.index(0, 20)], 1);
  EXPECT_GT(factors.heights_m[factors.index(5, 10)], 0.99f);
  EXPECT_LT(factors.heights_m[factors.index(28, 10)], 0.9f);
  for (int number = 1; number <= 16; ++number) {
    const HeightMap angles = band("horizons.tif", number);
    const float angle_deg = angles.heights_m[angles.index(20, 10)];
    // The wall reaches 100 m to both sides, as far as it is away.
    const bool is_east = number >= 4 && number <= 6;
    if (number == 5) {
      EXPECT_NEAR(angle_deg, 11.31f, 0.2f);
    }
    EXPECT_EQ(angle_deg > 1.0f, is_east || number == 3 || number == 7) << number;
    EXPECT_EQ(angles.is_void[angles.index(0, 20)], 1);
  }
}

TEST_F(TerrainSky, RefusesWithAHint) {
  const auto refuse = [&](const std::vector<std::string>& arguments, const std::string& expected) {
    const ProgramResult result = sky(arguments);
    EXPECT_EQ(result.exit_code, 2) << expected;
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n"));
    EXPECT_THAT(result.errors, ::testing::HasSubstr(expected));
    EXPECT_FALSE(std::ifstream(path("sky.tif")).is_open());
  };
  refuse({"--azimuths", "4"}, "--azimuths: expected");
  refuse({"--refraction", "2"}, "--refraction: expected");
  refuse({"--horizons", path("horizons.png")}, "horizons.png");
  refuse({"--horizons", path("sky.tif")}, "--horizons");
}

}  // namespace
}  // namespace offing::test
