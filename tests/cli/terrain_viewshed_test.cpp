// Viewsheds from the command line: a GeoTIFF where the map lies.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
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

/// Posts of a raster that a command wrote; NaN where it has nodata.
std::vector<float> posts_in(const std::string& file) {
  HeightMapOptions options;
  options.horizontal_unit = HorizontalUnit::metre;
  const HeightMap map = read_height_map(file, options).map;
  std::vector<float> values = map.heights_m;
  for (std::size_t i = 0; i < map.is_void.size(); ++i) {
    if (map.is_void[i] != 0) values[i] = std::numeric_limits<float>::quiet_NaN();
  }
  return values;
}

// Fails if a count is not the sum of what single runs see, a column or a flag does not reach an observer, or
// the union, the shares or the best observers are not those of the counts.
TEST_F(TerrainViewshed, CountsManyObservers) {
  std::ofstream(path("masts.csv"))
      << "name,x_m,z_m,observer_height_m,azimuth_from_deg,azimuth_to_deg,radius_m\n"
         "west,50,20,,,,\neast,150,80,,,,\nhigh,20,50,60,,,\nsector,50,20,,350,45,\nnear,50,20,3,,,31\n";
  const std::vector<std::vector<std::string>> single{
      {"--observer", "50,20"},
      {"--observer", "150,80"},
      {"--observer", "20,50", "--observer-height-m", "60"},
      {"--observer", "50,20", "--azimuth-from-deg", "350", "--azimuth-to-deg", "45"},
      {"--observer", "50,20", "--observer-height-m", "3", "--radius-m", "31"}};
  std::vector<float> sums(21 * 11, 0.0f);
  std::vector<int> seen_posts;
  for (std::vector<std::string> flags : single) {
    flags.insert(flags.end(), {"--target-height-m", "1", "--curvature", "--force", "--json"});
    const ProgramResult result = look(flags);
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    seen_posts.push_back(nlohmann::json::parse(result.output)["seen_posts"].get<int>());
    const std::vector<float> seen = posts_in(path("seen.tif"));
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += seen[i] / 255.0f;
  }
  EXPECT_LT(seen_posts[3], seen_posts[0]);
  EXPECT_LT(seen_posts[4], 50);
  const ProgramResult all =
      look({"--points", path("masts.csv"), "--target-height-m", "1", "--curvature", "--force", "--json",
            "--best", "2", "--union", path("union.tif"), "--shares", path("shares.csv")});
  ASSERT_EQ(all.exit_code, 0) << all.errors;
  const auto json = nlohmann::json::parse(all.output);
  const std::vector<float> counts = posts_in(path("seen.tif")), united = posts_in(path("union.tif"));
  int union_posts = 0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    EXPECT_EQ(std::isnan(counts[i]), std::isnan(sums[i])) << i;
    if (std::isnan(sums[i])) continue;
    EXPECT_EQ(counts[i], sums[i]) << i;
    EXPECT_EQ(united[i], sums[i] > 0.0f ? 255.0f : 0.0f) << i;
    union_posts += sums[i] > 0.0f ? 1 : 0;
  }
  EXPECT_EQ(json["observers"], 5);
  EXPECT_EQ(json["seen_posts"], union_posts);
  EXPECT_EQ(json["best_exhaustive"], true);
  ASSERT_EQ(json["best"].size(), 2u);
  EXPECT_EQ(json["best"][1]["seen_posts"], union_posts);
  const auto first = json["best"][0]["observer"].get<std::size_t>();
  EXPECT_EQ(json["best"][0]["seen_posts"], seen_posts[first - 1]);
  EXPECT_THAT(json["best"][0]["place"].get<std::string>(),
              ::testing::EndsWith("masts.csv:" + std::to_string(first + 1)));
  std::ifstream shares(path("shares.csv"));
  std::string line;
  std::getline(shares, line);
  EXPECT_EQ(line, "x_m,z_m,seen_posts,seen_area_m2,seen_share,only_posts,best_rank");
  std::getline(shares, line);
  EXPECT_THAT(line, ::testing::StartsWith("50,20," + std::to_string(seen_posts[0]) + ","));
}

// Fails if a field beyond those that the header names counts as columns that it does not name.
TEST_F(TerrainViewshed, LeavesSurplusFieldsAlone) {
  const auto counts_of = [&](const char* points) {
    std::ofstream(path("points.csv")) << points;
    const ProgramResult result = look({"--points", path("points.csv"), "--force"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return posts_in(path("seen.tif"));
  };
  const std::vector<float> plain = counts_of("x_m,z_m\n50,20\n"), more = counts_of("x_m,z_m\n50,20,35\n");
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_EQ(std::isnan(plain[i]) ? -1.0f : plain[i], std::isnan(more[i]) ? -1.0f : more[i]) << i;
  }
}

// The wall is 20 m high and 70 m from an eye 1.7 m up: 80 m behind it a target must be 1.7 + 150 / 70 18.3 m
// high. Fails if the raster lies elsewhere, several observers do not give the least, or voids are no nodata.
TEST_F(TerrainViewshed, WritesTheHeightsThatAreNeeded) {
  const auto needed_m = [&](std::vector<std::string> flags) {
    flags.insert(flags.end(), {"--force", "--needed", path("needed.tif")});
    const ProgramResult result = look(flags);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return posts_in(path("needed.tif"));
  };
  const std::vector<float> west = needed_m({"--observer", "50,20"}),
                           east = needed_m({"--observer", "190,20"});
  EXPECT_NEAR(west[2 * 21 + 20], 1.7 + 150.0 / 70.0 * 18.3, 1e-4);
  EXPECT_EQ(west[2 * 21 + 4], 0.0f);
  EXPECT_EQ(east[2 * 21 + 20], 0.0f);
  EXPECT_TRUE(std::isnan(west[10 * 21]));
  std::ofstream(path("two.csv")) << "50,20\n190,20\n";
  const std::vector<float> both = needed_m({"--points", path("two.csv")});
  for (std::size_t i = 0; i < both.size(); ++i) {
    if (i == 210) continue;
    EXPECT_EQ(both[i], std::min(west[i], east[i])) << i;
  }
}

// Within 31 m of 50,20 there are posts of 3 columns and rows each way. Fails if posts beyond the radius or
// the angles are hidden where nodata is asked for, or nodata where it is not.
TEST_F(TerrainViewshed, MarksWhatIsOutside) {
  const auto nodata_posts = [&](std::vector<std::string> flags) {
    flags.insert(flags.end(), {"--force", "--radius-m", "31"});
    const ProgramResult result = look(flags);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    const std::vector<float> seen = posts_in(path("seen.tif"));
    return std::count_if(seen.begin(), seen.end(), [](float value) { return std::isnan(value); });
  };
  EXPECT_EQ(nodata_posts({"--observer", "50,20"}), 1);
  // 29 posts within the circle, but for the row that the map does not have.
  EXPECT_EQ(nodata_posts({"--observer", "50,20", "--outside", "nodata"}), 21 * 11 - 28);
  EXPECT_EQ(nodata_posts({"--observer", "50,20", "--outside", "nodata", "--azimuth-from-deg", "90",
                          "--azimuth-to-deg", "180"}),
            21 * 11 - 11);
  std::ofstream(path("two.csv")) << "50,20\n60,20\n";
  EXPECT_EQ(nodata_posts({"--points", path("two.csv"), "--outside", "nodata"}), 21 * 11 - 28 - 6);
}

// Fails if many observers that cannot be used are no error with their line and a fix, or leave a file.
TEST_F(TerrainViewshed, RefusesObserversWithAHint) {
  const auto refuse = [&](const std::string& points, std::vector<std::string> more,
                          const std::string& expected) {
    std::ofstream(path("points.csv")) << points;
    more.insert(more.end(), {"--points", path("points.csv"), "--shares", path("shares.csv")});
    const ProgramResult result = look(more);
    EXPECT_EQ(result.exit_code, 2) << expected;
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n"));
    EXPECT_THAT(result.errors, ::testing::HasSubstr(expected));
    EXPECT_FALSE(std::ifstream(path("seen.tif")).is_open());
    EXPECT_FALSE(std::ifstream(path("shares.csv")).is_open());
  };
  refuse("50,20\n500,20\n", {}, "points.csv:2: expected a place within");
  refuse("x_m,z_m,observer_height_m\n50,20,-3\n", {}, "points.csv:2: observer_height_m: expected");
  refuse("x_m,z_m,lowest_deg\n50,20,95\n", {}, "points.csv:2: lowest_deg: expected -90 ... 90 degrees");
  refuse("x_m,z_m,radius_m\n50,20,far\n", {},
         "points.csv:2: radius_m: expected a number within [-2e+07, 2e+07], found \"far\"");
  refuse("\n", {}, "points.csv: expected points, found none");
  refuse("50,20\n", {"--observer", "50,20"}, "--observer");
  refuse("50,20\n", {"--best", "0"}, "--best: expected");
  refuse("50,20\n", {"--lowest-deg", "10", "--highest-deg", "5"},
         "--highest-deg: expected an angle above --lowest-deg 10, found 5");
  refuse("50,20\n", {"--union", path("union.png")}, "union.png");
}

}  // namespace
}  // namespace offing::test
