// Points and lines of GeoPackage and GeoJSON, which this file writes and reads by OGR itself.
#include "host/io/height_maps/map_features.h"

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <gdal.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include "host/base/error.h"
#include "tests/io/local_server.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

/// A GeoPackage by OGR: layers, each of geometries as WKT with a name and a height.
class MadeLayers {
 public:
  explicit MadeLayers(const std::string& file) {
    GDALAllRegister();
    dataset_ = GDALCreate(GDALGetDriverByName("GPKG"), file.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
  }
  MadeLayers(const MadeLayers&) = delete;
  MadeLayers& operator=(const MadeLayers&) = delete;
  ~MadeLayers() { GDALClose(dataset_); }

  void add(const std::string& name, const char* system, const std::vector<const char*>& geometries) const {
    const OGRSpatialReferenceH reference = system == nullptr ? nullptr : OSRNewSpatialReference(nullptr);
    if (reference != nullptr) OSRSetFromUserInput(reference, system);
    const OGRLayerH layer = GDALDatasetCreateLayer(dataset_, name.c_str(), reference, wkbUnknown, nullptr);
    if (reference != nullptr) OSRRelease(reference);
    for (const auto& [field, type] :
         {std::pair{"name", OFTString}, {"floors", OFTInteger}, {"mast_m", OFTReal}}) {
      const OGRFieldDefnH definition = OGR_Fld_Create(field, type);
      OGR_L_CreateField(layer, definition, FALSE);
      OGR_Fld_Destroy(definition);
    }
    int number = 0;
    for (const char* text : geometries) {
      const OGRFeatureH feature = OGR_F_Create(OGR_L_GetLayerDefn(layer));
      OGR_F_SetFieldString(feature, 0, ("well " + std::to_string(number)).c_str());
      OGR_F_SetFieldInteger(feature, 1, number);
      if (number != 1) OGR_F_SetFieldDouble(feature, 2, 0.5 + number);
      OGRGeometryH geometry = nullptr;
      std::string wkt = text;
      char* cursor = wkt.data();
      if (!wkt.empty()) OGR_G_CreateFromWkt(&cursor, nullptr, &geometry);
      if (geometry != nullptr) OGR_F_SetGeometryDirectly(feature, geometry);
      EXPECT_EQ(OGR_L_CreateFeature(layer, feature), OGRERR_NONE);
      OGR_F_Destroy(feature);
      ++number;
    }
  }

 private:
  GDALDatasetH dataset_;
};

class MapFeatures : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  std::string layer_of(const std::vector<const char*>& geometries, const char* system = "EPSG:32719") const {
    std::filesystem::remove(path("a.gpkg"));
    MadeLayers(path("a.gpkg")).add("wells", system, geometries);
    return path("a.gpkg");
  }
  static void refuse(const std::string& file, const std::string& expected, const std::string& layer = "",
                     FeatureShape shape = FeatureShape::points) {
    try {
      read_features(file, shape, layer);
      ADD_FAILURE() << file;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_THAT(error.what(), HasSubstr(expected));
      EXPECT_NE(error.hint(), "");
    }
  }

  TemporaryFolder folder_;
};

// Fails if a place, a type, a missing value, the order of features or the system is lost.
TEST_F(MapFeatures, HavePlacesAndAttributes) {
  const FeatureTable table =
      read_features(layer_of({"POINT(372500 6400000)", "POINT(372600.5 6400000.25)", "MULTIPOINT((1 2))"}),
                    FeatureShape::points, "");
  EXPECT_EQ(table.layer, "wells");
  EXPECT_THAT(table.coordinate_system, HasSubstr("UTM zone 19S"));
  EXPECT_FALSE(table.is_lonlat);
  EXPECT_FALSE(table.has_heights);
  ASSERT_EQ(table.count(), 3u);
  EXPECT_EQ(table.ends[1], glm::dvec3(372600.5, 6400000.25, 0.0));
  EXPECT_EQ(table.ends[2], glm::dvec3(1.0, 2.0, 0.0));
  ASSERT_EQ(table.columns.size(), 3u);
  EXPECT_EQ(table.columns[0].name, "name");
  EXPECT_EQ(table.columns[0].kind, AttributeKind::text);
  EXPECT_EQ(table.columns[1].kind, AttributeKind::whole);
  EXPECT_EQ(table.columns[2].kind, AttributeKind::number);
  const std::vector<AttributeValue> expected{"well 0", std::int64_t{0}, 0.5,
                                             "well 1", std::int64_t{1}, std::monostate{},
                                             "well 2", std::int64_t{2}, 2.5};
  EXPECT_EQ(table.values, expected);
  EXPECT_THAT(table.place_of(1), HasSubstr("a.gpkg: wells: feature id 2"));
}

// Fails if a file says when it was written: equal features are equal bytes.
TEST_F(MapFeatures, AreWrittenAlike) {
  const auto bytes_of = [&](const char* name) {
    const auto writer = create_features(
        path(name),
        {.layer = "points", .coordinate_system = "EPSG:32719", .columns = {{"name", AttributeKind::text}}});
    writer->add(std::vector{glm::dvec3(1.0, 2.0, 0.0)}, std::vector<AttributeValue>{"a"});
    writer->commit();
    std::ifstream file(path(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string first = bytes_of("first.gpkg");
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_TRUE(first == bytes_of("second.gpkg"));
  EXPECT_THAT(first, HasSubstr("1970-01-01T00:00:00.000Z"));
}

// Fails if the latitude of degrees comes first, heights are lost, or a line has other ends.
TEST_F(MapFeatures, AreInTheOrderOfMaps) {
  const FeatureTable points =
      read_features(layer_of({"POINT Z(-70.5 -32.5 90)"}, "EPSG:4326"), FeatureShape::points, "wells");
  EXPECT_EQ(points.ends[0], glm::dvec3(-70.5, -32.5, 90.0));
  EXPECT_TRUE(points.is_lonlat);
  EXPECT_TRUE(points.has_heights);
  EXPECT_EQ(read_features(layer_of({"POINT Z(1 2 3)", "POINT(1 2)"}), FeatureShape::points, "").is_raised,
            (std::vector{true, false}));
  const FeatureTable lines =
      read_features(layer_of({"LINESTRING(-70.5 -32.5,-70.4 -32.6)"}, "EPSG:4326"), FeatureShape::lines, "");
  ASSERT_EQ(lines.ends.size(), 2u);
  EXPECT_EQ(lines.ends[1], glm::dvec3(-70.4, -32.6, 0.0));
  const FeatureTable json = read_features(
      write(
          "a.geojson",
          R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"name":"a","floors":3},)"
          R"("geometry":{"type":"Point","coordinates":[-70.5,-32.5]}}]})"),
      FeatureShape::points, "");
  EXPECT_TRUE(json.is_lonlat);
  EXPECT_EQ(json.ends[0], glm::dvec3(-70.5, -32.5, 0.0));
  EXPECT_EQ(json.values, (std::vector<AttributeValue>{"a", std::int64_t{3}}));
  EXPECT_EQ(read_features(layer_of({"POINT(1 2)"}, nullptr), FeatureShape::points, "").coordinate_system, "");
}

// Fails if what is no point, or not where it says, is taken for one.
TEST_F(MapFeatures, OfOtherShapesAreRefused) {
  refuse(layer_of({"POINT(1 2)", "LINESTRING(1 2,3 4)"}), "feature id 2: expected a point, found LINESTRING");
  refuse(layer_of({"MULTIPOINT((1 2),(3 4))"}), "found MULTIPOINT of 2 parts");
  refuse(layer_of({"POINT EMPTY"}), "found an empty geometry");
  refuse(layer_of({""}), "feature id 1: expected a point, found no geometry");
  refuse(layer_of({"LINESTRING(1 2,3 4,5 6)"}), "expected a line of two points, found LINESTRING of 3 parts",
         "", FeatureShape::lines);
  refuse(layer_of({}), "wells: expected points, found none");
  refuse(layer_of({"POINT(1 2)"}), "--layer: expected one of wells, found lakes", "lakes");
  {
    const MadeLayers layers(path("two.gpkg"));
    layers.add("wells", "EPSG:32719", {"POINT(1 2)"});
    layers.add("masts", "EPSG:32719", {"POINT(3 4)"});
  }
  refuse(path("two.gpkg"), "--layer: expected one of wells, masts, found none");
  EXPECT_EQ(read_features(path("two.gpkg"), FeatureShape::points, "masts").ends[0].x, 3.0);
}

// Fails if another format is opened, a damaged file ends otherwise than in an error, or an address is called.
TEST_F(MapFeatures, OfOtherFilesAreRefused) {
  refuse(path("none.gpkg"), "none.gpkg");
  refuse(folder_.path().string(), "GeoPackage or a GeoJSON");
  refuse(write("a.csv", "x,y\n1,2\n"),
         "expected a GeoPackage or a GeoJSON, found a file that cannot be opened");
  refuse(write("a.kml", "<kml><Placemark><Point><coordinates>1,2</coordinates></Point></Placemark></kml>"),
         "expected a GeoPackage or a GeoJSON");
  refuse(write("cut.gpkg", "SQLite format 3"), "expected a GeoPackage or a GeoJSON");
  refuse(write("cut.geojson", R"({"type":"FeatureCollection","features":[{"type":"Fea)"),
         "expected a GeoPackage or a GeoJSON");
  const LocalServer server;
  for (const char* kind : {"link", "url"}) {
    const std::string file = write(
        "linked.geojson",
        std::string(R"({"type":"FeatureCollection","crs":{"type":")") + kind + R"(","properties":{"url":")" +
            server.url() + R"(/a","href":")" + server.url() +
            R"(/a"}},"features":[{"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[1,2]}}]})");
    try {
      read_features(file, FeatureShape::points, "");
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    }
  }
  EXPECT_EQ(server.callers(), 0);
}

// Fails if OGR reads something else than was written, or a file appears before it is whole.
TEST_F(MapFeatures, AreWritten) {
  const std::string file = path("out.gpkg");
  const OGRSpatialReferenceH utm = OSRNewSpatialReference(nullptr);
  OSRImportFromEPSG(utm, 32719);
  char* wkt = nullptr;
  OSRExportToWkt(utm, &wkt);
  OSRRelease(utm);
  NewFeatures features{.shape = FeatureShape::points,
                       .layer = "answers",
                       .coordinate_system = wkt,
                       .has_heights = true,
                       .columns = {{"name", AttributeKind::text},
                                   {"visible", AttributeKind::whole},
                                   {"distance_m", AttributeKind::number}}};
  CPLFree(wkt);
  {
    const auto writer = create_features(file, features);
    const std::array ends{glm::dvec3(372500.0, 6400000.0, 7.5)};
    writer->add(ends, std::vector<AttributeValue>{"a \"b\"", std::int64_t{1}, 0.1});
    writer->add(ends, std::vector<AttributeValue>{{}, {}, {}});
    EXPECT_FALSE(std::filesystem::exists(file));
    writer->commit();
  }
  GDALAllRegister();
  const GDALDatasetH dataset = GDALOpenEx(file.c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr);
  ASSERT_NE(dataset, nullptr);
  const OGRLayerH layer = GDALDatasetGetLayer(dataset, 0);
  EXPECT_STREQ(OGR_L_GetName(layer), "answers");
  EXPECT_STREQ(OSRGetAuthorityCode(OGR_L_GetSpatialRef(layer), nullptr), "32719");
  const OGRFeatureH feature = OGR_L_GetNextFeature(layer);
  ASSERT_NE(feature, nullptr);
  EXPECT_STREQ(OGR_F_GetFieldAsString(feature, 0), "a \"b\"");
  EXPECT_EQ(OGR_F_GetFieldAsInteger(feature, 1), 1);
  EXPECT_EQ(OGR_F_GetFieldAsDouble(feature, 2), 0.1);
  EXPECT_EQ(OGR_G_GetZ(OGR_F_GetGeometryRef(feature), 0), 7.5);
  OGR_F_Destroy(feature);
  const OGRFeatureH empty = OGR_L_GetNextFeature(layer);
  EXPECT_FALSE(OGR_F_IsFieldSetAndNotNull(empty, 2));
  OGR_F_Destroy(empty);
  GDALClose(dataset);
  EXPECT_THROW(create_features(file, features, Existing::keep)->commit(), Error);
}

}  // namespace
}  // namespace offing::test
