// Points and lines of GIS files as the questions of terrain commands, and answers as GeoPackage.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/io/height_maps/map_features.h"
#include "tests/cli/folder_content.h"
#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

const std::string lonlat_wkt =
    "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS "
    "84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],"
    "UNIT[\"degree\",0.0174532925199433],AUTHORITY[\"EPSG\",\"4326\"]]";

/// Ground that rises by 5 m a column, with a wall 100 m high across the middle: 21 x 21 posts, 0.001 degrees
/// apart from 70.5 W, 32.48 S on.
class TerrainPoints : public ::testing::Test {
 protected:
  TerrainPoints() {
    std::ofstream grid(path("grid.asc"));
    grid << "ncols 21\nnrows 21\nxllcenter -70.5\nyllcenter -32.5\ncellsize 0.001\n";
    for (int row = 0; row < 21; ++row) {
      for (int column = 0; column < 21; ++column) grid << 5 * column + (row == 10 ? 100 : 0) << ' ';
      grid << "\n";
    }
    std::ofstream(path("grid.prj")) << lonlat_wkt;
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  ProgramResult ask(const std::string& command, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"terrain", command, path("grid.asc")});
    return run_offing(arguments);
  }
  ProgramResult ask_all(const std::string& command, const std::string& points,
                        const std::string& output) const {
    return ask(command, {"--points", path(points), "-o", path(output), "--force"});
  }
  std::string text(const std::string& name) const {
    std::ostringstream content;
    content << std::ifstream(path(name)).rdbuf();
    return content.str();
  }
  /// Two wells, with a name and a depth each.
  void write_wells(const std::string& name, const std::string& system = lonlat_wkt) const {
    const auto writer = create_features(
        path(name), {.shape = FeatureShape::points,
                     .layer = "wells",
                     .coordinate_system = system,
                     .has_heights = false,
                     .columns = {{"name", AttributeKind::text}, {"height_m", AttributeKind::whole}}});
    writer->add(std::vector{glm::dvec3(-70.4967, -32.48, 0.0)},
                std::vector<AttributeValue>{"first, \"old\"", std::int64_t{12}});
    writer->add(std::vector{glm::dvec3(-70.5, -32.48, 0.0)}, std::vector<AttributeValue>{"second", {}});
    writer->commit();
  }

  TemporaryFolder folder_;
};

// Column 3.3 of row 0 is 16.5 m high. Fails if a point is elsewhere, an attribute is lost or takes the place
// of an answer, or text with commas breaks the table.
TEST_F(TerrainPoints, CarryTheirAttributesToCsv) {
  write_wells("wells.gpkg");
  const ProgramResult result = ask_all("height", "wells.gpkg", "heights.csv");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(
      text("heights.csv"),
      ::testing::MatchesRegex(
          "longitude_deg,latitude_deg,name,given_height_m,height_m,normal_x,[^\n]*measured\n"
          "-70.4967,-32.48,\"first, \"\"old\"\"\",12,16.5,[^\n]*,1\n-70.5,-32.48,second,,0,[^\n]*,1\n"));
}

// Fails if a GeoPackage has other places, answers, types or another system than the question's.
TEST_F(TerrainPoints, GetAnswersInGeoPackages) {
  write_wells("wells.gpkg");
  const ProgramResult result = ask_all("height", "wells.gpkg", "heights.gpkg");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output, "");
  const FeatureTable table = read_features(path("heights.gpkg"), FeatureShape::points, "heights");
  EXPECT_TRUE(table.is_lonlat);
  ASSERT_EQ(table.count(), 2u);
  EXPECT_EQ(table.ends[0], glm::dvec3(-70.4967, -32.48, 0.0));
  std::vector<std::string> names;
  for (const AttributeColumn& column : table.columns) names.push_back(column.name);
  EXPECT_THAT(names, ::testing::ElementsAre("name", "given_height_m", "height_m", "normal_x", "normal_y",
                                            "normal_z", "slope_deg", "measured"));
  EXPECT_EQ(table.values[0], AttributeValue("first, \"old\""));
  EXPECT_EQ(table.values[1], AttributeValue(std::int64_t{12}));
  EXPECT_NEAR(std::get<double>(table.values[2]), 16.5, 1e-6);
  EXPECT_EQ(table.values[7], AttributeValue(std::int64_t{1}));
  EXPECT_EQ(table.values[9], AttributeValue());
}

// Fails if the layer's own system does not count, or a table's places are not those of the same layer.
TEST_F(TerrainPoints, AreInTheSystemOfTheirLayer) {
  std::ofstream(path("point.geojson")) << R"({"type":"Point","coordinates":[-70.4967,-32.48]})";
  ASSERT_EQ(ask_all("height", "point.geojson", "there.gpkg").exit_code, 0);
  const std::string table = "longitude_deg,latitude_deg\n-70.4967,-32.48\n";
  std::ofstream(path("table.csv")) << table;
  ASSERT_EQ(
      ask("height", {"--crs", "lonlat", "--points", path("table.csv"), "-o", path("again.gpkg")}).exit_code,
      0);
  const FeatureTable there = read_features(path("there.gpkg"), FeatureShape::points, ""),
                     again = read_features(path("again.gpkg"), FeatureShape::points, "");
  EXPECT_EQ(there.ends, again.ends);
  EXPECT_EQ(there.values, again.values);
  // Local places go where the map lies.
  std::ofstream(path("local.csv")) << "0,0\n";
  ASSERT_EQ(ask_all("height", "local.csv", "local.gpkg").exit_code, 0);
  const glm::dvec3 first = read_features(path("local.gpkg"), FeatureShape::points, "").ends[0];
  EXPECT_NEAR(first.x, -70.5, 1e-12);
  EXPECT_NEAR(first.y, -32.48, 1e-12);
}

// A line of sight across the wall, and one beside it. Fails if a line's ends change places, or heights are
// not taken from attributes.
TEST_F(TerrainPoints, AreLinesForLinesOfSight) {
  {
    const auto writer =
        create_features(path("lines.gpkg"), {.shape = FeatureShape::lines,
                                             .layer = "links",
                                             .coordinate_system = lonlat_wkt,
                                             .has_heights = false,
                                             .columns = {{"to_height_m", AttributeKind::whole},
                                                         {"id", AttributeKind::whole},
                                                         {"from_height_m", AttributeKind::number}}});
    const glm::dvec3 north(-70.49, -32.482, 0.0), south(-70.49, -32.498, 0.0), near(-70.48, -32.488, 0.0);
    writer->add(std::vector{north, south},
                std::vector<AttributeValue>{std::int64_t{2}, std::int64_t{7}, 2.0});
    writer->add(std::vector{north, near}, std::vector<AttributeValue>{std::int64_t{2}, std::int64_t{8}, 2.0});
    writer->add(std::vector{north, south},
                std::vector<AttributeValue>{std::int64_t{300}, std::int64_t{9}, 300.0});
    writer->commit();
  }
  const ProgramResult result = ask_all("los", "lines.gpkg", "seen.csv");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(text("seen.csv"),
              ::testing::MatchesRegex("from_longitude_deg,from_latitude_deg,from_height_m,to_longitude_deg,"
                                      "to_latitude_deg,to_height_m,id,visible,distance_m,hidden_at_m\n"
                                      "-70.49,-32.482,2,-70.49,-32.498,2,7,0,[^\n]*\n"
                                      "-70.49,-32.482,2,-70.48,-32.488,2,8,1,[^\n]*,\n"
                                      "-70.49,-32.482,300,-70.49,-32.498,300,9,1,[^\n]*,\n"));
  ASSERT_EQ(ask_all("los", "lines.gpkg", "seen.gpkg").exit_code, 0);
  EXPECT_EQ(read_features(path("seen.gpkg"), FeatureShape::lines, "").ends[1].y, -32.498);
}

// Fails if the height of a ray's start is not its point's.
TEST_F(TerrainPoints, HaveHeightsForRays) {
  std::ofstream(path("rays.geojson"))
      << R"({"type":"Feature","properties":{"direction_x":0,"direction_y":-1,"direction_z":0},)"
      << R"("geometry":{"type":"Point","coordinates":[-70.4967,-32.4801,116.5]}})";
  const ProgramResult result = ask("ray", {"--points", path("rays.geojson")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output,
              ::testing::MatchesRegex("longitude_deg,latitude_deg,height_m,direction_x,[^\n]*\n"
                                      "-70.4967,-32.4801,116.5,0,-1,0,surface,(100|99.99)[^\n]*\n"));
}

// Fails if a layer that cannot be asked is no error with its place and a fix, or leaves a file.
TEST_F(TerrainPoints, AreRefusedWithAHint) {
  const auto refuse = [&](const std::string& command, const std::vector<std::string>& arguments,
                          const std::string& expected) {
    const auto before = folder_content(folder_.path());
    const ProgramResult result = ask(command, arguments);
    EXPECT_EQ(result.exit_code, 2) << expected;
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n")) << expected;
    EXPECT_THAT(result.errors, HasSubstr(expected));
    EXPECT_EQ(folder_content(folder_.path()), before) << expected;
  };
  write_wells("wells.gpkg");
  const auto wells = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--points", path("wells.gpkg"), "-o", path("out.gpkg")});
    return more;
  };
  refuse("height", wells({"--layer", "masts"}), "--layer: expected one of wells, found masts");
  refuse("height", wells({"--crs", "map"}), "--crs: expected none, because");
  refuse("los", wells({}), "wells: feature id 1: expected a line of two points, found POINT");
  refuse("ray", wells({}), "wells.gpkg: wells: expected an attribute \"direction_x\", found none");
  std::ofstream(path("far.geojson"))
      << R"({"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[-70.4,-32.49]}})";
  refuse("height", {"--points", path("far.geojson"), "-o", path("out.gpkg")},
         "feature id 0: expected a place on the map");
  const auto ray_from = [](const char* point) {
    return std::string(
               R"({"type":"Feature","properties":{"direction_x":0,"direction_y":-1,"direction_z":0},)") +
           R"("geometry":{"type":"Point","coordinates":)" + point + "}}";
  };
  // A height of 0 m is not what a point without one means.
  std::ofstream(path("mixed.geojson"))
      << R"({"type":"FeatureCollection","features":[)" << ray_from("[-70.4967,-32.49,900]") << ','
      << ray_from("[-70.4967,-32.49]") << "]}";
  refuse("ray", {"--points", path("mixed.geojson"), "-o", path("out.csv")},
         "feature id 1: expected a point with a z");
  std::ofstream(path("high.geojson")) << ray_from("[-70.4967,-32.49,1e10]");
  refuse("ray", {"--points", path("high.geojson"), "-o", path("out.csv")},
         "feature id 0: z: expected a number within [-1e+09, 1e+09], found 1e+10");
  std::ofstream(path("empty.geojson")) << R"({"type":"FeatureCollection","features":[]})";
  refuse("height", {"--points", path("empty.geojson"), "-o", path("out.csv")}, "expected points, found none");
  std::ofstream(path("plain.csv")) << "1,2\n";
  refuse("height", {"--points", path("plain.csv"), "--layer", "a"}, "--layer: expected a GeoPackage");
  // GIS formats that are neither read nor written: the first was read as text, the second written as CSV.
  std::ofstream(path("wells.shp"), std::ios::binary) << std::string("\0\0\x27\n", 4);
  refuse("height", {"--points", path("wells.shp"), "-o", path("out.csv")},
         "hint: convert it: ogr2ogr wells.gpkg " + path("wells.shp"));
  refuse("height", {"--points", path("wells.gpkg"), "-o", path("out.geojson")},
         "out.geojson: expected a name that ends in .gpkg or .csv");
  refuse("profile", {"--from", "0,0", "--to", "9,9", "-o", path("out.gpkg")},
         "out.gpkg: expected a name that ends in .csv");
  refuse("viewshed", {"--points", path("wells.gpkg"), "--shares", path("out.shp"), "-o", path("out.tif")},
         "out.shp: expected a name that ends in .gpkg or .csv");
  std::ofstream(path("broken.json")) << "{";
  refuse("height", {"--points", path("broken.json")},
         "as with ogr2ogr broken_points.gpkg " + path("broken.json") + ", or");
  write_wells("nowhere.gpkg", "");
  refuse("height", {"--points", path("nowhere.gpkg")}, "nowhere.gpkg: wells: expected a coordinate system");
  EXPECT_EQ(ask("height", {"--points", path("nowhere.gpkg"), "--crs", "lonlat"}).exit_code, 0);
  std::ofstream(path("grid.asc"))
      << "ncols 2\nnrows 2\nxllcorner 500000\nyllcorner 900000\ncellsize 10\n1 2\n3 4\n";
  std::filesystem::remove(path("grid.prj"));
  refuse("height", {"--points", path("plain.csv"), "-o", path("out.gpkg")},
         "grid.asc: expected a map with a coordinate system for a GeoPackage");
}

}  // namespace
}  // namespace offing::test
