// Sky-view factors and horizons from the command line: GeoTIFFs where the map lies.
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/io/height_maps/read_height_map.h"
#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

/// Level ground 41 x 21 posts, 10 m apart, with a wall 20 m high along column 30 and a void in a corner.
class TerrainSky : public ::testing::Test {
 protected:
  TerrainSky() {
    std::ofstream grid(path("grid.asc"));
    grid << "ncols 41\nnrows 21\nxllcorner 5000\nyllcorner 700\ncellsize 10\nnodata_value -9\n";
    for (int row = 0; row < 21; ++row) {
      for (int column = 0; column < 41; ++column) {
        grid << (row == 20 && column == 0 ? -9 : column == 30 ? 20 : 0) << ' ';
      }
      grid << "\n";
    }
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  ProgramResult sky(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"terrain", "sky", path("grid.asc"), "-o", path("sky.tif")});
    return run_offing(arguments);
  }
  /// A band of a raster, from a copy without its units: height maps are read in metres or feet alone.
  HeightMap band(const std::string& name, int number) const {
    std::ifstream file(path(name), std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(file)), {});
    const std::string unit = "role=\"unittype\"";
    for (auto at = bytes.find(unit); at != std::string::npos; at = bytes.find(unit)) bytes[at + 6] = 'n';
    std::ofstream(path("plain.tif"), std::ios::binary) << bytes;
    HeightMapOptions options;
    options.horizontal_unit = HorizontalUnit::metre;
    options.band = number;
    return read_height_map(path("plain.tif"), options).map;
  }
  /// Whether a raster says this of a band: GDAL keeps units and descriptions as text.
  bool has_text(const std::string& name, const std::string& text) const {
    std::ifstream file(path(name), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    return bytes.find(text) != std::string::npos;
  }

  TemporaryFolder folder_;
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
