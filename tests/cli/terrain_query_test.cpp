// Heights, profiles, rays and lines of sight from the command line.
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

/// Ground that rises to the east by 1 m in 2, with a wall 100 m high across the middle: 21 x 21 posts, 10 m
/// apart.
class TerrainQuery : public ::testing::Test {
 protected:
  TerrainQuery() {
    std::ofstream grid(path("grid.asc"));
    grid << "ncols 21\nnrows 21\nxllcenter 0\nyllcenter 0\ncellsize 10\n";
    for (int row = 0; row < 21; ++row) {
      for (int column = 0; column < 21; ++column) grid << 5 * column + (row == 10 ? 100 : 0) << ' ';
      grid << "\n";
    }
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  ProgramResult ask(const std::string& command, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"terrain", command, path("grid.asc")});
    return run_offing(arguments);
  }
  nlohmann::json answer(const std::string& command, std::vector<std::string> arguments) const {
    arguments.push_back("--json");
    const ProgramResult result = ask(command, arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output);
  }

  TemporaryFolder folder_;
};

TEST_F(TerrainQuery, HeightIsBilinearBetweenPosts) {
  const auto json = answer("height", {"--at", "33,7"});
  EXPECT_NEAR(json["height_m"].get<double>(), 16.5, 1e-9);
  EXPECT_NEAR(json["slope_deg"].get<double>(), std::atan(0.5) * 180.0 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(json["normal"][0].get<double>(), -1.0 / std::sqrt(5.0), 1e-9);
}

// Straight down, and up to a point below what it would hit.
TEST_F(TerrainQuery, RaysEndOnTheGround) {
  const auto down = answer("ray", {"--from", "33,116.5,7", "--direction", "0,-2,0"});
  EXPECT_EQ(down["hit"], "surface");
  EXPECT_NEAR(down["distance_m"].get<double>(), 100.0, 1e-3);
  EXPECT_NEAR(down["point_m"][1].get<double>(), 16.5, 1e-3);
  EXPECT_EQ(down["cell"], nlohmann::json({3, 0}));
  EXPECT_EQ(answer("ray", {"--from", "33,116.5,7", "--to", "33,20,7"})["hit"], "miss");
  EXPECT_EQ(answer("ray", {"--from", "33,10,7", "--to", "33,20,7"})["hit"], "inside");
}

// At the top of the wall's side patches lean by the wall's 10 m in 1, smooth normals by half of it, as level
// ground follows. Fails if --smooth-normals does nothing.
TEST_F(TerrainQuery, NormalsAreSmoothOnRequest) {
  const auto lean = [](const nlohmann::json& json) {
    return std::abs(json["normal"][2].get<double>() / json["normal"][1].get<double>());
  };
  EXPECT_NEAR(lean(answer("height", {"--at", "33,90.001"})), 10.0, 1e-6);
  EXPECT_NEAR(lean(answer("height", {"--at", "33,90.001", "--smooth-normals"})), 5.0, 1e-3);
  const std::vector<std::string> down{"--from", "33,300,90.001", "--direction", "0,-1,0"};
  std::vector<std::string> smooth = down;
  smooth.push_back("--smooth-normals");
  EXPECT_NEAR(lean(answer("ray", down)), 10.0, 1e-3);
  EXPECT_NEAR(lean(answer("ray", smooth)), 5.0, 1e-2);
}

// On its own side of the wall a target on the very ground is seen; behind the wall only from above it.
TEST_F(TerrainQuery, WallsHide) {
  EXPECT_EQ(answer("los", {"--from", "20,20,2", "--to", "180,80,0"})["visible"], true);
  const auto hidden = answer("los", {"--from", "100,20,2", "--to", "100,180,2"});
  EXPECT_EQ(hidden["visible"], false);
  // Its slope begins at 90 m and rises 10 m in 1: at 2 m above the ground it is 0.2 m farther.
  EXPECT_NEAR(hidden["hidden_at_m"].get<double>(), 70.2, 0.05);
  EXPECT_EQ(answer("los", {"--from", "100,20,101", "--to", "100,180,101"})["visible"], true);
}

// The wall is 100 m high on ground that rises by 0.5 a metre to the east: a line along x = 100 m at 130 m is
// 30 m above it. Fails if the clearance is elsewhere, other in a file, or the Fresnel zone has another width:
// 1,000 MHz at 80 m of 160 m is sqrt(0.2998 m 40 m) = 3.463 m.
TEST_F(TerrainQuery, ClearancesAreThoseOfTheWall) {
  const std::vector<std::string> flags{"--from",      "100,20,130",      "--to",
                                       "100,180,130", "--frequency-mhz", "1000"};
  const auto json = answer("los", flags);
  EXPECT_NEAR(json["clearance_m"].get<double>(), 30.0, 1e-9);
  EXPECT_NEAR(json["clearance_at_m"].get<double>(), 80.0, 1e-9);
  EXPECT_NEAR(json["clearance_ground_m"][1].get<double>(), 150.0, 1e-9);
  EXPECT_NEAR(json["fresnel_share"].get<double>(), 30.0 / std::sqrt(299792458.0 / 1e9 * 40.0), 1e-3);
  EXPECT_NEAR(json["fresnel_radius_m"].get<double>(), 3.463, 1e-3);
  EXPECT_EQ(answer("los", {flags[0], flags[1], flags[2], flags[3]}).contains("clearance_m"), false);
  EXPECT_THAT(
      ask("los", {"--from", "100,20,30", "--to", "100,180,30", "--clearance"}).output,
      ::testing::HasSubstr("smallest clearance -70.000 m, at 80.000 m: above ground at (100, 150, 100)\n"));
  std::ofstream(path("lines.csv")) << "100,20,130,100,180,130\n";
  EXPECT_THAT(
      ask("los", {"--points", path("lines.csv"), "--clearance"}).output,
      ::testing::MatchesRegex("[^\n]*,hidden_at_m,clearance_m,clearance_at_m\n[^\n]*,1,160,,30,80\n"));
}

// The ground of a flat sea 200 km long falls away by d^2 / 2R = 62.8 m within 28.3 km: an eye 10 m up sees
// the water as far as sqrt(2R 10 m) = 11.29 km, and what is 22.6 m above it beyond that at 28.3 km: (28.3
// - 11.29)^2 / 2R.
TEST_F(TerrainQuery, TheEarthCurves) {
  std::ofstream sea(path("sea.asc"));
  sea << "ncols 41\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1000\n";
  for (int i = 0; i < 82; ++i) sea << "0 ";
  sea.close();
  const auto sees = [&](const std::string& target, const std::vector<std::string>& flags) {
    std::vector<std::string> arguments = {"terrain",  "los",  path("sea.asc"), "--from",
                                          "0,500,10", "--to", target,          "--json"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    const ProgramResult result = run_offing(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output)["visible"].get<bool>();
  };
  EXPECT_TRUE(sees("28300,500,1", {}));
  EXPECT_FALSE(sees("28300,500,22.2", {"--refraction", "0"}));
  EXPECT_TRUE(sees("28300,500,23.2", {"--refraction", "0"}));
  EXPECT_TRUE(sees("28300,500,22.2", {"--curvature"}));
  const auto hit =
      nlohmann::json::parse(run_offing({"terrain", "ray", path("sea.asc"), "--from", "0,10,500",
                                        "--direction", "1,-0.0018,0", "--refraction", "0", "--json"})
                                .output);
  // Reaches it where x^2 / 2R - 0.0018 x + 10 = 0, first at 9445 m, on the water.
  EXPECT_NEAR(hit["point_m"][1].get<double>(), 0.0, 0.01);
  EXPECT_NEAR(hit["distance_m"].get<double>(), 9445.0, 5.0);
}

// Fails if an answer of a file is not that of the single question, or another line's.
TEST_F(TerrainQuery, FilesAskManyAtOnce) {
  const auto lines = [&](const std::string& command, const std::string& questions) {
    std::ofstream(path("questions.csv")) << questions;
    const ProgramResult result =
        ask(command, {"--points", path("questions.csv"), "-o", path("answers.csv"), "--force"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.output, "");
    std::ifstream file(path("answers.csv"));
    std::vector<std::string> read;
    for (std::string line; std::getline(file, line);) read.push_back(line);
    return read;
  };
  EXPECT_THAT(lines("height", "33,7\n# a wall\n0,100\n"),
              ::testing::ElementsAre("x_m,z_m,height_m,normal_x,normal_y,normal_z,slope_deg,measured",
                                     ::testing::StartsWith("33,7,16.5,-0.4472136,0.8944272,"),
                                     ::testing::StartsWith("0,100,100,")));
  EXPECT_THAT(lines("los", "20,20,2,180,80,0\n100,20,2,100,180,2\n"),
              ::testing::ElementsAre(::testing::StartsWith("from_x_m,"),
                                     ::testing::MatchesRegex("20,20,2,180,80,0,1,[0-9.]+,"),
                                     ::testing::MatchesRegex("100,20,2,100,180,2,0,160,70.2[0-9]*")));
  EXPECT_THAT(
      lines("ray",
            "name,direction_x,direction_y,direction_z,x_m,y_m,z_m\na,0,-2,0,33,116.5,7\nb,0,1,0,3,900,7\n"),
      ::testing::ElementsAre(::testing::StartsWith("x_m,y_m,z_m,direction_x,"),
                             ::testing::StartsWith("33,116.5,7,0,-2,0,surface,100,33,16.5,7,-0.4472"),
                             "3,900,7,0,1,0,miss,,,,,,,"));
}

// Fails if rays straight down on the far edges are lost, or hit something 45,000 km below, or if a distance
// loses the digits of a long way.
TEST_F(TerrainQuery, FilesOfRaysAtTheEdgesAndFromFarAway) {
  std::ofstream(path("edges.asc")) << "ncols 3\nnrows 3\nxllcenter 0\nyllcenter 0\ncellsize 30.9\n"
                                      "0 0 0\n0 0 0\n0 0 0\n";
  std::ofstream(path("rays.csv")) << "61.8,50,10,0,-1,0\n61.80000000003,50,10,0,-1,0\n10,50,61.8,0,-1,0\n"
                                     "-1000000,1000030.25,10,1,-1,0\n";
  const ProgramResult result =
      run_offing({"terrain", "ray", path("edges.asc"), "--points", path("rays.csv")});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, ::testing::ContainsRegex("\n61.8,50,10,0,-1,0,surface,50,61.8,0,10,"));
  EXPECT_THAT(result.output, ::testing::HasSubstr("\n61.8,50,10,0,-1,0,miss"));
  EXPECT_THAT(result.output, ::testing::ContainsRegex("\n10,50,61.8,0,-1,0,surface,50,10,0,61.8,"));
  // 1,000,030.25 m times the square root of 2.
  EXPECT_THAT(result.output, ::testing::ContainsRegex("surface,1414256\\.342[0-9]*,30.25"));
}

// Fails if a distance has other digits in JSON, in words or in a line of sight than in CSV, where it has
// those of the floats that it was made of and no more: a float's step at 70 m is 7.6e-6 m, at 1 km 6.1e-5 m.
TEST_F(TerrainQuery, DistancesHaveTheirDigitsEverywhere) {
  const std::vector<std::string> ray{"--from", "33.3,1116.5,7.7", "--direction", "0.1,-1,0.1"};
  const auto json = nlohmann::json::parse(ask("ray", {ray[0], ray[1], ray[2], ray[3], "--json"}).output);
  const std::string distance = json["distance_m"].dump();
  EXPECT_THAT(distance, ::testing::MatchesRegex("[0-9]+\\.[0-9]?[0-9]?[0-9]?[0-9]?[0-9]?"));
  EXPECT_THAT(ask("ray", ray).output,
              ::testing::HasSubstr("at " + distance + " m: (" + json["point_m"][0].dump()));
  std::ofstream(path("rays.csv")) << "33.3,1116.5,7.7,0.1,-1,0.1\n";
  EXPECT_THAT(ask("ray", {"--points", path("rays.csv")}).output,
              ::testing::HasSubstr("surface," + distance + ","));
  const std::vector<std::string> sight{"--from", "100,20,2", "--to", "100,180,2"};
  const auto hidden =
      nlohmann::json::parse(ask("los", {sight[0], sight[1], sight[2], sight[3], "--json"}).output);
  const std::string hidden_at = hidden["hidden_at_m"].dump();
  EXPECT_THAT(hidden_at, ::testing::MatchesRegex("70\\.2[0-9]?[0-9]?[0-9]?[0-9]?"));
  EXPECT_THAT(ask("los", sight).output, ::testing::HasSubstr("), " + hidden_at + " m of 160 m"));
}

// Fails if a bad line is not named, or leaves a file.
TEST_F(TerrainQuery, FilesNameTheirBadLines) {
  const auto refuse = [&](const std::string& command, const std::string& questions,
                          const std::string& expected) {
    std::ofstream(path("questions.csv")) << questions;
    const ProgramResult result = ask(command, {"--points", path("questions.csv"), "-o", path("answers.csv")});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, ::testing::HasSubstr("questions.csv:" + expected));
    EXPECT_THAT(result.errors, ::testing::HasSubstr("\nhint: "));
    EXPECT_FALSE(std::ifstream(path("answers.csv")).is_open());
  };
  refuse("height", "1,2\n3,4\n900,2\n", "3: expected a place within");
  refuse("height", "1,2\n3\n", "2: expected x_m,z_m as two numbers");
  refuse("los", "1,2,3,4,5,-6\n", "1: expected a height above ground");
  refuse("los", "x,y\n1,2,3,1,2,3\n", "1: expected from_x_m,");
  refuse("los", "1,2,3,1,2,3\n", "1: expected a place away");
  refuse("ray", "1,2,3,0,0,0\n", "1: expected a direction");
  refuse("ray", "1e7,2,3,0,1,0\n9e7,2,3,0,1,0\n", "2: expected x_m,y_m");
}

TEST_F(TerrainQuery, ProfilesHaveBothEnds) {
  const ProgramResult result = ask("profile", {"--from", "0,5", "--to", "100,5", "--step-m", "50"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output, "distance_m,x_m,z_m,height_m,measured\n0,0,5,0,1\n50,50,5,25,1\n100,100,5,50,1\n");
}

// Heights fall away as for lines of sight, by (1 - K) d^2 / 2R: 100 km from the beginning by 784.8 m without
// refraction, 682.8 m with it.
TEST_F(TerrainQuery, ProfilesFallAwayAsTheEarthCurves) {
  std::ofstream(path("sea.asc")) << "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 100000\n7 7 7 7\n";
  const auto last_line = [&](const std::string& flag, const std::string& value) {
    const ProgramResult result = run_offing({"terrain", "profile", path("sea.asc"), "--from", "0,0", "--to",
                                             "100000,0", "--step-m", "50000", flag, value});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output,
                ::testing::StartsWith("distance_m,x_m,z_m,height_m,measured,fallen_height_m\n0,0,0,7,1,7\n"));
    return result.output.substr(result.output.rfind('\n', result.output.size() - 2) + 1);
  };
  EXPECT_THAT(last_line("--refraction", "0"), ::testing::StartsWith("100000,100000,0,7,1,-777.8"));
  EXPECT_THAT(last_line("--refraction", "0.13"), ::testing::StartsWith("100000,100000,0,7,1,-675.7"));
}

// Fails if ground that was filled in passes for measured: 3 x 3 posts with a void in the middle, which all
// patches have as a corner, but not their outer edges.
TEST_F(TerrainQuery, TellsWhatWasNotMeasured) {
  std::ofstream(path("holed.asc"))
      << "ncols 3\nnrows 3\nxllcenter 0\nyllcenter 0\ncellsize 10\nnodata_value -9\n"
         "1 1 1\n1 -9 1\n1 1 1\n";
  const auto measured = [&](const std::string& at) {
    const ProgramResult result = run_offing({"terrain", "height", path("holed.asc"), "--at", at, "--json"});
    return nlohmann::json::parse(result.output)["measured"].get<bool>();
  };
  EXPECT_FALSE(measured("10,10"));
  EXPECT_FALSE(measured("5,5"));
  EXPECT_TRUE(measured("0,5"));
  EXPECT_TRUE(measured("20,20"));
  EXPECT_THAT(run_offing({"terrain", "height", path("holed.asc"), "--at", "5,5"}).output,
              ::testing::HasSubstr("not measured"));
  EXPECT_THAT(run_offing({"terrain", "profile", path("holed.asc"), "--from", "0,10", "--to", "20,10"}).output,
              ::testing::HasSubstr("10,10,10,1,0\n20,20,10,1,1\n"));
  // A store of tiles tells the same.
  ASSERT_EQ(run_offing({"terrain", "tile", path("holed.asc"), "-o", path("holed.tiles")}).exit_code, 0);
  EXPECT_THAT(run_offing({"terrain", "height", path("holed.tiles"), "--at", "5,5", "--json"}).output,
              ::testing::HasSubstr("\"measured\": false"));
  EXPECT_THAT(run_offing({"terrain", "height", path("holed.tiles"), "--at", "0,5", "--json"}).output,
              ::testing::HasSubstr("\"measured\": true"));
}

// Fails if the end of a line that leaves the map is taken for its beginning.
TEST_F(TerrainQuery, ProfilesNameTheEndThatIsOffTheMap) {
  const auto errors = [&](const std::string& from, const std::string& to) {
    return ask("profile", {"--from", from, "--to", to}).errors;
  };
  EXPECT_THAT(errors("0,0", "9000,0"), ::testing::HasSubstr("--to: "));
  EXPECT_THAT(errors("0,0", "9000,0"), ::testing::HasSubstr("9000"));
  EXPECT_THAT(errors("9000,0", "0,0"), ::testing::HasSubstr("--from: "));
}

TEST_F(TerrainQuery, RefusesWithAHint) {
  const auto refuse = [&](const std::string& command, const std::vector<std::string>& arguments) {
    const ProgramResult result = ask(command, arguments);
    EXPECT_EQ(result.exit_code, 2) << command << ' ' << arguments.back();
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n")) << arguments.back();
    EXPECT_EQ(result.output, "");
  };
  refuse("height", {"--at", "201,0"});
  refuse("height", {"--at", "1"});
  refuse("ray", {"--from", "1,2,3"});
  refuse("ray", {"--from", "1,2,3", "--to", "1,2,3"});
  refuse("ray", {"--from", "1,2,3", "--to", "4,5,6", "--direction", "1,0,0"});
  refuse("height", {"--points", "missing.csv"});
  refuse("height", {"--points", "missing.csv", "--at", "1,2"});
  refuse("height", {"--at", "1,2", "-o", "answers.csv"});
  refuse("los", {"--points", "missing.csv", "--json"});
  refuse("los", {"--from", "1,2,-1", "--to", "4,5,6"});
  refuse("los", {"--from", "1,2,3", "--to", "1,2,3"});
  refuse("profile", {"--from", "0,0", "--to", "500,0"});
  refuse("profile", {"--from", "0,0", "--to", "100,0", "--step-m", "0"});
}

// Fails if `lake` prints other figures than those of the pit, or writes an outline that is not its shore.
TEST_F(TerrainQuery, FillsALake) {
  std::ofstream grid(path("pit.asc"));
  grid << "ncols 5\nnrows 5\nxllcenter 0\nyllcenter 0\ncellsize 10\n";
  for (int post = 0; post < 25; ++post)
    grid << (post == 12 ? 50 : post == 13 ? 58 : 60) << (post % 5 == 4 ? "\n" : " ");
  grid.close();
  const auto fill = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"terrain", "lake", path("pit.asc"), "--at", "20,20"});
    return run_offing(arguments);
  };
  const ProgramResult full = fill({"--json"});
  ASSERT_EQ(full.exit_code, 0) << full.errors;
  const auto json = nlohmann::json::parse(full.output);
  EXPECT_EQ(json["level_m"], 60.0);
  EXPECT_EQ(json["greatest_depth_m"], 10.0);
  const ProgramResult half = fill({"--level-m", "55", "-o", path("pit.geojson")});
  ASSERT_EQ(half.exit_code, 0) << half.errors;
  EXPECT_THAT(half.output, testing::StartsWith("level 55.000 m, area "));
  EXPECT_THAT(half.output, testing::HasSubstr("spill level 60.000 m"));
  std::ifstream written(path("pit.geojson"));
  const auto outline = nlohmann::json::parse(written)["features"][0];
  EXPECT_EQ(outline["geometry"]["coordinates"][0].size(), 5u);
  EXPECT_EQ(outline["properties"]["level_m"], 55.0);
  const ProgramResult high = fill({"--level-m", "61"});
  EXPECT_EQ(high.exit_code, 2);
  EXPECT_THAT(high.errors,
              testing::HasSubstr("--at: expected a level up to its spill level, 60 m, found 61 m"));
}

}  // namespace
}  // namespace offing::test
