// Viewsheds from the command line: a GeoTIFF where the map lies.
#include <fstream>
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

/// Level ground 21 x 11 posts, 10 m apart, with a wall 20 m high along column 12 and a void in a corner.
class TerrainViewshed : public ::testing::Test {
 protected:
  TerrainViewshed() {
    std::ofstream grid(path("grid.asc"));
    grid << "ncols 21\nnrows 11\nxllcorner 5000\nyllcorner 700\ncellsize 10\nnodata_value -9\n";
    for (int row = 0; row < 11; ++row) {
      for (int column = 0; column < 21; ++column) {
        grid << (row == 10 && column == 0 ? -9 : column == 12 ? 20 : 0) << ' ';
      }
      grid << "\n";
    }
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  ProgramResult look(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"terrain", "viewshed", path("grid.asc"), "-o", path("seen.tif")});
    return run_offing(arguments);
  }

  TemporaryFolder folder_;
};

// Fails if rows or columns are swapped, the raster lies elsewhere than the map, or voids count as hidden.
TEST_F(TerrainViewshed, WritesWhatIsSeenWhereTheMapLies) {
  const ProgramResult result = look({"--observer", "50,20", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["seen_posts"], 13 * 11 - 1);
  EXPECT_EQ(json["void_posts"], 1);
  EXPECT_NEAR(json["eye_m"].get<double>(), 1.7, 1e-6);
  HeightMapOptions options;
  options.horizontal_unit = HorizontalUnit::metre;
  const HeightMap seen = read_height_map(path("seen.tif"), options).map;
  ASSERT_EQ(seen.columns, 21);
  ASSERT_EQ(seen.rows, 11);
  EXPECT_EQ(seen.georeference.origin_x, 5005.0);
  EXPECT_EQ(seen.georeference.origin_y, 805.0);
  EXPECT_EQ(seen.georeference.step_x, 10.0);
  EXPECT_EQ(seen.georeference.step_y, -10.0);
  for (int row = 0; row < 11; ++row) {
    for (int column = 0; column < 21; ++column) {
      if (row == 10 && column == 0) {
        EXPECT_EQ(seen.is_void[seen.index(column, row)], 1);
      } else {
        EXPECT_EQ(seen.heights_m[seen.index(column, row)], column <= 12 ? 255.0f : 0.0f)
            << column << ' ' << row;
      }
    }
  }
}

// Fails if a flag has no effect: from 30 m up, or to targets of 30 m, the wall hides less; within 30 m there
// are 29 posts, of those in the map 28; on a curved Earth of this size nothing changes.
TEST_F(TerrainViewshed, FlagsChangeWhatIsSeen) {
  const auto seen_posts = [&](std::vector<std::string> flags) {
    flags.insert(flags.end(), {"--observer", "50,20", "--json", "--force"});
    const ProgramResult result = look(flags);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output)["seen_posts"].get<int>();
  };
  EXPECT_GT(seen_posts({"--observer-height-m", "40"}), 13 * 11 - 1);
  EXPECT_GT(seen_posts({"--target-height-m", "40"}), 13 * 11 - 1);
  EXPECT_EQ(seen_posts({"--radius-m", "30"}), 28);
  EXPECT_EQ(seen_posts({"--curvature"}), 13 * 11 - 1);
}

TEST_F(TerrainViewshed, RefusesWithAHint) {
  const auto refuse = [&](const std::vector<std::string>& arguments, const std::string& expected) {
    const ProgramResult result = look(arguments);
    EXPECT_EQ(result.exit_code, 2) << expected;
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n"));
    EXPECT_THAT(result.errors, ::testing::HasSubstr(expected));
    EXPECT_FALSE(std::ifstream(path("seen.tif")).is_open());
  };
  refuse({}, "--observer");
  refuse({"--observer", "50"}, "--observer: expected X,Z");
  refuse({"--observer", "500,20"}, "--observer: expected a place within");
  refuse({"--observer", "50,20", "--observer-height-m", "-1"}, "--observer-height-m: expected");
  refuse({"--observer", "50,20", "--radius-m", "0"}, "--radius-m: expected");
  refuse({"--observer", "50,20", "--refraction", "2"}, "--refraction: expected");
  const ProgramResult name =
      run_offing({"terrain", "viewshed", path("grid.asc"), "--observer", "50,20", "-o", path("seen.png")});
  EXPECT_EQ(name.exit_code, 2);
}

}  // namespace
}  // namespace offing::test
