// Places of terrain commands in the map's own coordinates, longitude and latitude, and other systems.
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/folder_content.h"
#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

const std::string wgs84 =
    "GEOGCS[\"GCS_WGS_1984\",DATUM[\"D_WGS_1984\",SPHEROID[\"WGS_1984\",6378137.0,298.257223563]],"
    "PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\",0.0174532925199433]]";
const std::string utm19 =
    "PROJCS[\"WGS_1984_UTM_Zone_19S\"," + wgs84 +
    ",PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"False_Easting\",500000.0],PARAMETER[\"False_Northing\","
    "10000000.0],PARAMETER[\"Central_Meridian\",-69.0],PARAMETER[\"Scale_Factor\",0.9996],"
    "PARAMETER[\"Latitude_Of_Origin\",0.0],UNIT[\"Meter\",1.0]]";

/// Ground that rises by 5 m a column, with a wall 100 m high across the middle: 21 x 21 posts, 0.001 degrees
/// apart from 70.5 W, 32.48 S on, and the same 100 m apart from (500000, 6402000) of UTM 19 S on.
class TerrainPlaces : public ::testing::Test {
 protected:
  TerrainPlaces() {
    write_grid("degrees", "xllcenter -70.5\nyllcenter -32.5\ncellsize 0.001\n", wgs84);
    write_grid("utm", "xllcenter 500000\nyllcenter 6400000\ncellsize 100\n", utm19);
    write_grid("nowhere", "xllcenter 500000\nyllcenter 6400000\ncellsize 100\n", "");
  }
  void write_grid(const std::string& name, const std::string& place, const std::string& system) const {
    std::ofstream grid(path(name + ".asc"));
    grid << "ncols 21\nnrows 21\n" << place;
    for (int row = 0; row < 21; ++row) {
      for (int column = 0; column < 21; ++column) grid << 5 * column + (row == 10 ? 100 : 0) << ' ';
      grid << "\n";
    }
    if (!system.empty()) std::ofstream(path(name + ".prj")) << system;
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  ProgramResult ask(const std::string& command, const std::string& map,
                    std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"terrain", command, path(map + ".asc")});
    return run_offing(arguments);
  }
  nlohmann::json answer(const std::string& command, const std::string& map,
                        std::vector<std::string> arguments) const {
    arguments.push_back("--json");
    const ProgramResult result = ask(command, map, arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output);
  }
  double height(const std::string& map, const std::string& crs, const std::string& at) const {
    return answer("height", map, {"--crs", crs, "--at", at})["height_m"].get<double>();
  }
  std::string bytes(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name), std::ios::binary).rdbuf();
    return text.str();
  }

  TemporaryFolder folder_;
};

// Column 3.3 of row 0 is 16.5 m high. Fails if a system's place is at another post, or south is taken for
// north. Heights change by 5 m a column: 1e-5 of a post is 5e-5 m; text of 10 digits is as exact.
TEST_F(TerrainPlaces, AreWhereTheirSystemSays) {
  EXPECT_NEAR(height("degrees", "map", "-70.4967,-32.48"), 16.5, 1e-6);
  EXPECT_NEAR(height("degrees", "lonlat", "-70.4967,-32.48"), 16.5, 1e-6);
  EXPECT_NEAR(height("degrees", "EPSG:4326", "289.5033,-32.48"), 16.5, 1e-6);
  EXPECT_NEAR(height("degrees", "lonlat", "-70.48,-32.49"), 200.0, 1e-6);
  EXPECT_NEAR(height("utm", "map", "500330,6402000"), 16.5, 1e-9);
  EXPECT_NEAR(height("utm", "EPSG:32719", "500330,6402000"), 16.5, 1e-6);
  EXPECT_NEAR(height("utm", "local", "330,0"), 16.5, 1e-9);
  EXPECT_NEAR(height("utm", "map", "502000,6401000"), 200.0, 1e-9);
  // The central meridian of zone 19, 6401000 m of UTM being 32.5 S.
  EXPECT_NEAR(height("utm", "lonlat", "-69,-32.5255"), 0.0, 1e-6);
  EXPECT_NEAR(height("nowhere", "map", "500330,6402000"), 16.5, 1e-9);
}

// Fails if the corners that are printed are not those that can be asked for.
TEST_F(TerrainPlaces, OfCornersArePrintedAndTaken) {
  const auto corners = answer("info", "utm", {"--crs", "EPSG:3857"})["corners"];
  EXPECT_EQ(corners["local"], nlohmann::json({{0.0, 0.0}, {2000.0, 0.0}, {2000.0, 2000.0}, {0.0, 2000.0}}));
  EXPECT_EQ(corners["map"][1], nlohmann::json({502000.0, 6402000.0}));
  EXPECT_EQ(corners["map"][3], nlohmann::json({500000.0, 6400000.0}));
  EXPECT_NEAR(corners["lonlat"][0][0].get<double>(), -69.0, 1e-9);
  for (const std::string crs : {"map", "lonlat", "EPSG:3857"}) {
    const auto& corner = corners[crs][2];
    EXPECT_NEAR(height("utm", crs, corner[0].dump() + "," + corner[1].dump()), 100.0, 1e-4) << crs;
  }
  const ProgramResult text = ask("info", "degrees", {});
  EXPECT_THAT(text.output,
              HasSubstr("corners    north-west: local 0, 0; map -70.5, -32.48; lonlat -70.5000000000,"));
  EXPECT_THAT(ask("info", "nowhere", {}).output,
              HasSubstr("south-east: local 2000, 2000; map 502000, 6400000\n"));
  ASSERT_EQ(run_offing({"terrain", "tile", path("utm.asc"), "-o", path("utm.tiles")}).exit_code, 0);
  const ProgramResult store = run_offing({"terrain", "info", path("utm.tiles"), "--json"});
  EXPECT_EQ(nlohmann::json::parse(store.output)["corners"]["lonlat"], corners["lonlat"]);
}

// Fails if a command takes another place than the local one, or prints results elsewhere: local (330, 500) is
// (500330, 6401500).
TEST_F(TerrainPlaces, AreTheSameForEachCommand) {
  const std::vector<std::string> map{"--crs", "map"};
  const auto with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), map.begin(), map.end());
    return arguments;
  };
  EXPECT_EQ(
      ask("profile", "utm", with({"--from", "500000,6401950", "--to", "501000,6401950", "--step-m", "500"}))
          .output,
      "distance_m,x,y,height_m,measured\n0,500000,6401950,0,1\n500,500500,6401950,25,1\n"
      "1000,501000,6401950,50,1\n");
  const auto ray = answer("ray", "utm", with({"--from", "500330,6401950,1000", "--direction", "0,-1,0"}));
  EXPECT_EQ(ray["point_m"][0], 330.0);
  EXPECT_EQ(ray["point_m"][2], 50.0);
  EXPECT_NEAR(ray["point"]["x"].get<double>(), 500330.0, 1e-6);
  EXPECT_NEAR(ray["point"]["y"].get<double>(), 6401950.0, 1e-6);
  EXPECT_NEAR(ray["point"]["height_m"].get<double>(), 16.5, 1e-3);
  EXPECT_EQ(answer("ray", "utm", with({"--from", "500330,6401950,1000", "--to", "500330,6401950,20"}))["hit"],
            "miss");
  const auto hidden = answer("los", "utm", with({"--from", "501000,6401800,2", "--to", "501000,6400200,2"}));
  const auto local = answer("los", "utm", {"--from", "1000,200,2", "--to", "1000,1800,2"});
  EXPECT_EQ(hidden["hidden_by_m"], local["hidden_by_m"]);
  EXPECT_NEAR(hidden["hidden_by"]["y"].get<double>(), 6402000.0 - local["hidden_by_m"][2].get<double>(),
              1e-6);
  ASSERT_EQ(ask("viewshed", "utm", {"--observer", "330,500", "-o", path("local.tif")}).exit_code, 0);
  ASSERT_EQ(ask("viewshed", "utm", with({"--observer", "500330,6401500", "-o", path("map.tif")})).exit_code,
            0);
  EXPECT_EQ(bytes("local.tif"), bytes("map.tif"));
  const auto render = answer(
      "render", "utm", with({"--camera", "500330,6401500,900,0,-15", "--size", "8x8", "-o", path("a.png")}));
  EXPECT_EQ(render["eye_m"], nlohmann::json({330.0, 900.0, 500.0}));
  EXPECT_NEAR(render["eye"]["y"].get<double>(), 6401500.0, 1e-6);
}

// Fails if words have other places than JSON, or metres of the map instead of the system asked for.
TEST_F(TerrainPlaces, OfAnswersInWordsAreInTheSystem) {
  const std::vector<std::string> ray{"--crs",       "lonlat", "--from", "-70.48,-32.485,1000",
                                     "--direction", "0,-1,0"};
  EXPECT_THAT(ask("ray", "degrees", ray).output,
              ::testing::ContainsRegex(
                  "^surface at [0-9.]+ m: longitude -70.4800000[0-9], latitude -32.4850000[0-9], height "
                  "(100|99.9[0-9]*|100.0[0-9]*) m, normal"));
  const std::vector<std::string> sight{
      "--crs", "map", "--from", "501000,6401800,2", "--to", "501000,6400200,2", "--clearance"};
  EXPECT_THAT(
      ask("los", "utm", sight).output,
      ::testing::ContainsRegex("^hidden: ground at x 501000, y 640[0-9.]+, height [0-9.]+ m, [0-9.]+ m "
                               "of 1600 m\nsmallest clearance -98.000 m, at 800.000 m: above ground at "
                               "x 501000, y 6401000, height 150 m\n"));
}

// Fails if coordinates of another system than the local one get a hint that does not help.
TEST_F(TerrainPlaces, OfOtherSystemsGetTheirFlagAsAHint) {
  const auto hint = [&](const std::string& map, const std::string& at) {
    const ProgramResult result = ask("height", map, {"--at", at});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, HasSubstr("--at: expected a place within 0 ... "));
    return result.errors;
  };
  EXPECT_THAT(hint("degrees", "-70.49,-32.49"),
              HasSubstr("hint: add --crs lonlat if these are longitude and"));
  EXPECT_THAT(hint("utm", "-68.99,-32.53"), HasSubstr("hint: add --crs lonlat if"));
  EXPECT_THAT(hint("utm", "-32.53,-68.99"), HasSubstr("hint: add --crs lonlat if"));
  EXPECT_THAT(hint("utm", "500330,6401950"),
              HasSubstr("hint: add --crs map if these are coordinates of the"));
  EXPECT_THAT(hint("nowhere", "500330,6401950"), HasSubstr("hint: add --crs map if"));
  EXPECT_THAT(hint("utm", "5000,7000"), HasSubstr("hint: `offing terrain info FILE` prints"));
  std::ofstream(path("points.csv")) << "0,0\n-70.49,-32.49\n";
  EXPECT_THAT(ask("height", "degrees", {"--points", path("points.csv")}).errors,
              HasSubstr("points.csv:2: expected a place within"));
}

// Fails if a file's places are not read by the names of the system, or answers do not carry them.
TEST_F(TerrainPlaces, OfFilesAreNamedByTheirSystem) {
  const auto lines = [&](const std::string& command, const std::string& map, const std::string& crs,
                         const std::string& questions) {
    std::ofstream(path("questions.csv")) << questions;
    const ProgramResult result = ask(command, map, {"--points", path("questions.csv"), "--crs", crs});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return result.output;
  };
  EXPECT_THAT(
      lines("height", "degrees", "lonlat",
            "name,latitude_deg,longitude_deg\na,-32.48,-70.4967\nb,-32.49,-70.5\n"),
      ::testing::MatchesRegex("longitude_deg,latitude_deg,height_m,normal_x,.*\n-70.4967,-32.48,16.[0-9]+,"
                              "[^\n]*\n-70.5,-32.49,(100|99.9+[0-9]*),[^\n]*\n"));
  EXPECT_THAT(lines("los", "utm", "map", "501000,6401800,2,501000,6400200,2\n"),
              ::testing::MatchesRegex("from_x,from_y,from_height_m,to_x,to_y,to_height_m,visible,[^\n]*\n"
                                      "501000,6401800,2,501000,6400200,2,0,1600,[^\n]*\n"));
  EXPECT_THAT(
      lines("ray", "utm", "map", "500330,6401950,1000,0,-1,0\n500330,6401950,1000,0,1,0\n"),
      ::testing::MatchesRegex("x,y,height_m,direction_x,direction_y,direction_z,hit,distance_m,hit_x,hit_y,"
                              "hit_height_m,[^\n]*\n500330,6401950,1000,0,-1,0,surface,983.5[0-9]*,500330,"
                              "6401950,16.5[0-9]*,[^\n]*\n500330,6401950,1000,0,1,0,miss,,,,,,,\n"));
}

// Fails if a place that is elsewhere, a system that is none, or columns of another system are not an error
// with their place and a fix, or leave a file.
TEST_F(TerrainPlaces, AreRefusedWithAHint) {
  const auto before = folder_content(folder_.path());
  const auto refuse = [&](const std::string& command, const std::string& map,
                          const std::vector<std::string>& arguments, const std::string& expected) {
    const ProgramResult result = ask(command, map, arguments);
    EXPECT_EQ(result.exit_code, 2) << expected;
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n")) << expected;
    EXPECT_THAT(result.errors, HasSubstr(expected));
    EXPECT_EQ(result.output, "");
  };
  refuse("height", "utm", {"--crs", "EPSG:999999", "--at", "1,2"}, "--crs: expected local, map, lonlat");
  refuse("height", "utm", {"--crs", "lonlat", "--at", "-70,-32"}, "--at: expected a place on the map");
  refuse("height", "utm", {"--crs", "map", "--at", "499000,6403500"},
         "found 499000, 6403500, 1000 m west and 1500 m north of its north-west post\nhint: `offing terrain "
         "info " +
             path("utm.asc") + " --crs map` prints");
  refuse("height", "utm", {"--crs", "lonlat", "--at", "-32.53,-68.99"}, "write -68.99,-32.53");
  refuse("height", "utm", {"--crs", "lonlat", "--at", "-69,-132"}, "nowhere in the map's coordinate system");
  refuse("height", "utm", {"--crs", "lonlat", "--at", "-69"}, "--at: expected LON,LAT");
  refuse("ray", "utm", {"--crs", "map", "--from", "1,2"}, "--from: expected X,Y,HEIGHT");
  refuse("height", "nowhere", {"--crs", "lonlat", "--at", "-69,-32"},
         "nowhere.asc: expected a map with a place");
  refuse("ray", "degrees", {"--crs", "lonlat", "--from", "-70.49,-32.49,900", "--to", "289.51,-32.49,900"},
         "--to: expected a point other than --from");
  refuse("info", "nowhere", {"--crs", "EPSG:32719"}, "nowhere.asc: expected a map with a place");
  refuse("viewshed", "utm", {"--crs", "map", "--observer", "0,0", "-o", path("out.tif")},
         "--observer: expected a place on the map");
  EXPECT_EQ(folder_content(folder_.path()), before);
  std::ofstream(path("local.csv")) << "0,0\n";
  const std::vector<float> heights(16, 1.0f);
  std::ofstream(path("raw.r32"), std::ios::binary)
      .write(reinterpret_cast<const char*>(heights.data()), 16 * sizeof(float));
  std::ofstream(path("utm.geojson"))
      << R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::32719"}},)"
      << R"("features":[{"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[1,2]}}]})";
  const auto refuse_raw = [&](const char* points, const std::string& expected) {
    const ProgramResult result =
        run_offing({"terrain", "height", path("raw.r32"), "--raw-size", "4x4", "--spacing-m", "10",
                    "--points", path(points), "-o", path("out.gpkg")});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n"));
    EXPECT_THAT(result.errors, HasSubstr(expected));
    EXPECT_THAT(result.errors, ::testing::Not(HasSubstr("--crs")));
  };
  refuse_raw("local.csv", "out.gpkg: expected a map with a place in the world for a GeoPackage");
  // Systems are called by their names: WKT has a thousand characters.
  refuse_raw("utm.geojson", "utm.geojson: utm WGS 84 / UTM zone 19S needs, found none");
  const auto refuse_points = [&](const std::string& questions, const std::string& expected) {
    std::ofstream(path("questions.csv")) << questions;
    refuse("height", "degrees", {"--crs", "lonlat", "--points", path("questions.csv"), "-o", path("out.csv")},
           expected);
    EXPECT_FALSE(std::ifstream(path("out.csv")).is_open());
  };
  refuse_points("x_m,z_m\n1,2\n", "questions.csv:1: expected longitude_deg,latitude_deg");
  refuse_points("longitude_deg,z_m\n1,2\n", "questions.csv:1: expected longitude_deg,latitude_deg");
  refuse_points("-70.49,-32.49\n-70.6,-32.49\n", "questions.csv:2: expected a place on the map");
}

// Fails if levels of lakes are asked for as heights above ground, or if lakes that share water are drawn
// twice. Before: "X,Z,H", with a level of 1.7 proposed, and both were drawn.
TEST_F(TerrainPlaces, LevelsOfLakes) {
  const auto refusal = [this](const std::string& map, std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"-o", path("lake.png")});
    const ProgramResult result = ask("render", map, arguments);
    EXPECT_EQ(result.exit_code, 2);
    return result.errors;
  };
  const std::string local = refusal("utm", {"--lake", "700,700,high"});
  EXPECT_THAT(local, HasSubstr("X,Z,LEVEL"));
  EXPECT_THAT(local, HasSubstr("1200,350.5,2600"));
  const std::string lonlat = refusal("utm", {"--crs", "lonlat", "--lake", "-69,-32.5,high"});
  EXPECT_THAT(lonlat, HasSubstr("LON,LAT,LEVEL"));
  EXPECT_THAT(lonlat, HasSubstr("-70.5,-32.5,2500"));
  {
    std::ofstream grid(path("bowl.asc"));
    grid << "ncols 21\nnrows 21\nxllcenter 0\nyllcenter 0\ncellsize 10\n";
    for (int row = 0; row < 21; ++row) {
      for (int column = 0; column < 21; ++column) grid << std::hypot(column - 10.0, row - 10.0) << ' ';
      grid << "\n";
    }
  }
  EXPECT_THAT(
      refusal("bowl", {"--unit", "metre", "--lake", "100,100,4", "--lake", "110,100"}),
      HasSubstr("--lake: expected no other lake there, found 110,100 in the water of 100,100,4\nhint: leave"));
}

}  // namespace
}  // namespace offing::test
