// Places on maps in local metres, the maps' own coordinates and other systems, against transformations that
// this file makes of OGR itself.
#include "host/io/height_maps/map_coordinates.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gdal.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include "host/base/error.h"
#include "host/io/height_maps/read_height_map.h"
#include "tests/io/height_maps/raster_writer.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

/// What GDAL itself says of a file: posts at the centres of pixels.
struct Place {
  int columns = 0, rows = 0;
  std::array<double, 6> transform{};
  std::string wkt;
};

Place place_by_gdal(const std::string& file) {
  GDALAllRegister();
  Place place;
  const GDALDatasetH raster = GDALOpen(file.c_str(), GA_ReadOnly);
  if (raster == nullptr) throw std::runtime_error(file);
  place.columns = GDALGetRasterXSize(raster);
  place.rows = GDALGetRasterYSize(raster);
  GDALGetGeoTransform(raster, place.transform.data());
  place.wkt = GDALGetProjectionRef(raster);
  GDALClose(raster);
  return place;
}

/// A system whose axes are in the order that its authority gives, unlike those of the code that is tested.
struct Axes {
  explicit Axes(const std::string& text) {
    if (system.SetFromUserInput(text.c_str()) != OGRERR_NONE) throw std::runtime_error(text);
    system.SetAxisMappingStrategy(OAMS_AUTHORITY_COMPLIANT);
    OGRAxisOrientation first = OAO_Other;
    system.GetAxis(nullptr, 0, &first);
    is_north_first = first == OAO_North;
  }
  mutable OGRSpatialReference system;  // OGR takes it without const
  bool is_north_first = false;
};

/// OGR's way from one system to another, east first.
class WayByOgr {
 public:
  WayByOgr(const Axes& from, const Axes& to)
      : from_north_first_(from.is_north_first),
        to_north_first_(to.is_north_first),
        way_(OGRCreateCoordinateTransformation(&from.system, &to.system)) {
    if (!way_) throw std::runtime_error("no way");
  }
  glm::dvec2 operator()(const glm::dvec2& place) const {
    double x = from_north_first_ ? place.y : place.x, y = from_north_first_ ? place.x : place.y;
    if (way_->Transform(1, &x, &y) == 0) throw std::runtime_error("no way");
    return to_north_first_ ? glm::dvec2(y, x) : glm::dvec2(x, y);
  }

 private:
  bool from_north_first_, to_north_first_;
  std::unique_ptr<OGRCoordinateTransformation> way_;
};

// Of a post, as the issue asks for: posts are 20 m or more, and both ways take the same steps in doubles,
// whose rounding is 1e-9 m of coordinates up to 1e7 m. Measured at most 2e-10.
constexpr double tolerance_posts = 1e-6;
// There and back between two datums: PROJ leaves out the height above the second ellipsoid, which costs a
// fraction of a millimetre. Measured 9e-6 of 30 m from NAD 27 to WGS 84.
constexpr double tolerance_of_datums_posts = 5e-5;

double farthest(const glm::dvec2& a, const glm::dvec2& b) {
  const double far = std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
  return std::isnan(far) ? 1e9 : far;
}

/// 1,000 random places of a map in a system: to posts, from posts, and back. Fails if either way leads
/// elsewhere than OGR's does, or if both together do not end where they began.
void check(const std::string& file, const std::vector<std::string>& systems,
           double back_tolerance_posts = tolerance_posts) {
  SCOPED_TRACE(file);
  const Place by_gdal = place_by_gdal(file);
  const HeightMapFile read = read_height_map(file);
  const MapFrame frame = frame_of(file, read.map);
  const std::array<double, 6>& t = by_gdal.transform;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> column(0.0, by_gdal.columns - 1.0), row(0.0, by_gdal.rows - 1.0);
  std::vector<glm::dvec2> posts, local;
  for (int i = 0; i < 1000; ++i) {
    posts.emplace_back(column(random), row(random));
    local.emplace_back(posts.back().x * frame.spacing_x_m, posts.back().y * frame.spacing_z_m);
  }
  const auto posts_of = [&](const glm::dvec2& place_m) {
    return glm::dvec2(place_m.x / frame.spacing_x_m, place_m.y / frame.spacing_z_m);
  };
  const Axes own(by_gdal.wkt);
  for (const std::string& system : systems) {
    SCOPED_TRACE(system);
    const auto coordinates = map_coordinates(frame, system);
    std::optional<WayByOgr> there, back;
    if (system != "local" && system != "map") {
      const Axes other(system == "lonlat" ? "EPSG:4326" : system);
      there.emplace(own, other);
      back.emplace(other, own);
    }
    const std::vector<glm::dvec2> places = coordinates->from_local(local),
                                  again = coordinates->to_local(places);
    double worst_there = 0.0, worst_back = 0.0, worst_again = 0.0;
    for (std::size_t i = 0; i < posts.size(); ++i) {
      const glm::dvec2 in_map(t[0] + (posts[i].x + 0.5) * t[1], t[3] + (posts[i].y + 0.5) * t[5]);
      glm::dvec2 place = in_map, post = posts[i];
      if (there) {
        place = (*there)(in_map);
        const glm::dvec2 back_in_map = (*back)(places[i]);
        post = {(back_in_map.x - t[0]) / t[1] - 0.5, (back_in_map.y - t[3]) / t[5] - 0.5};
      }
      if (system == "local") place = local[i];
      // A post of the map is about as many units of a system in metres, and of one in degrees 1e-5 of them.
      const double unit_posts =
          std::abs(place.x) <= 360.0 ? 111e3 / frame.spacing_x_m : 1.0 / frame.spacing_x_m;
      worst_there = std::max(worst_there, unit_posts * farthest(places[i], place));
      worst_back = std::max(worst_back, farthest(posts_of(again[i]), post));
      worst_again = std::max(worst_again, farthest(posts_of(again[i]), posts[i]));
    }
    EXPECT_LT(worst_there, tolerance_posts);
    EXPECT_LT(worst_back, tolerance_posts);
    EXPECT_LT(worst_again, back_tolerance_posts);
  }
}

/// A file of the data folder, each in a test of its own.
void check_data(const std::string& name, const std::vector<std::string>& systems,
                double back_tolerance_posts = tolerance_posts) {
  const char* const folder = std::getenv("OFFING_TEST_DATA");
  if (folder == nullptr) GTEST_SKIP() << "OFFING_TEST_DATA is not set: no real height maps";
  check((std::filesystem::path(folder) / "terrain" / name).string(), systems, back_tolerance_posts);
}

// Degrees on WGS 84; SIRGAS 2000 (EPSG:4674) names latitude first.
TEST(MapCoordinates, OfGeoTiffOfDegrees) {
  check_data("S33W071.tif", {"local", "map", "lonlat", "EPSG:4326", "EPSG:32719", "EPSG:3857", "EPSG:4674"});
}

// LAEA Europe (EPSG:3035) names north first.
TEST(MapCoordinates, OfHgtOfThreeSeconds) {
  check_data("N42E001.hgt.zip", {"local", "map", "lonlat", "EPSG:32631", "EPSG:3035", "EPSG:3857"},
             tolerance_of_datums_posts);
}

TEST(MapCoordinates, OfHgtOfOneSecond) {
  check_data("N48W125.hgt.zip", {"local", "map", "lonlat", "EPSG:32610", "EPSG:4269"});
}

// UTM on NAD 27, whose way to WGS 84 is a choice of PROJ's.
TEST(MapCoordinates, OfUsgsDem) {
  check_data("SainteHelens.dem", {"local", "map", "lonlat", "EPSG:4326", "EPSG:26710", "EPSG:3857"},
             tolerance_of_datums_posts);
}

class MadeMaps : public ::testing::Test {
 protected:
  /// 90 x 70 posts from a corner of the first pixel on.
  std::string made(const std::string& name, const std::string& system, double x, double y,
                   double step) const {
    Raster raster = raster_of(90, 70, [](int column, int row) { return 3.0 * column + row; });
    raster.geotransform = {x, step, 0.0, y, 0.0, -step};
    raster.coordinate_system = system;
    const std::string file = (folder_.path() / name).string();
    write_raster(file, "GTiff", raster);
    return file;
  }
  static MapFrame frame(const std::string& file) { return frame_of(file, read_height_map(file).map); }

  TemporaryFolder folder_;
};

TEST_F(MadeMaps, OfUtm) {
  check(made("utm.tif", "EPSG:32719", 372500.0, 6400000.0, 20.0),
        {"local", "map", "lonlat", "EPSG:4326", "EPSG:3857", "EPSG:32719", "EPSG:32718", "EPSG:4674"});
}

TEST_F(MadeMaps, OfWebMercator) {
  check(made("mercator.tif", "EPSG:3857", -7849000.0, -3831000.0, 30.0),
        {"local", "map", "lonlat", "EPSG:4326", "EPSG:32719", "EPSG:3857"});
}

// Fails if longitude and latitude change places, in whatever order the system names them: the central
// meridian of zone 19 is 69 W, where x is 500,000 m.
TEST_F(MadeMaps, TakeLongitudeFirst) {
  const MapFrame map = frame(made("utm.tif", "EPSG:32719", 499990.0, 6400000.0, 20.0));
  for (const char* system : {"lonlat", "EPSG:4326", "EPSG:4674"}) {
    const auto coordinates = map_coordinates(map, system);
    const std::array first{glm::dvec2(0.0, 0.0)};
    const glm::dvec2 place = coordinates->from_local(first)[0];
    EXPECT_NEAR(place.x, -69.0, 1e-9) << system;
    EXPECT_NEAR(place.y, -32.5, 0.1) << system;
    const std::array there{place};
    EXPECT_NEAR(coordinates->to_local(there)[0].x, 0.0, 1e-6) << system;
  }
}

// Fails if longitudes that count from 0 to 360 are another place, in a map that counts from -180 or from 0,
// or on the antimeridian; or if results do not count from -180.
TEST_F(MadeMaps, CountLongitudesAnyWay) {
  for (const double west : {-71.0, 289.0, 179.5, -180.5}) {
    const MapFrame map = frame(made("degrees.tif", "EPSG:4326", west - 0.005, -32.0 + 0.005, 0.01));
    const auto coordinates = map_coordinates(map, "lonlat");
    for (const double turn : {-360.0, 0.0, 360.0}) {
      const std::array place{glm::dvec2(west + 0.8 + turn, -32.5)};
      const glm::dvec2 local = coordinates->to_local(place)[0];
      EXPECT_NEAR(local.x / map.spacing_x_m, 80.0, 1e-6) << west << ' ' << turn;
      EXPECT_NEAR(local.y / map.spacing_z_m, 50.0, 1e-6) << west << ' ' << turn;
      const std::array back{local};
      const double longitude = coordinates->from_local(back)[0].x;
      EXPECT_NEAR(longitude, std::remainder(west + 0.8, 360.0), 1e-9) << west;
    }
  }
  const auto utm = map_coordinates(frame(made("utm.tif", "EPSG:32719", 499990.0, 6400000.0, 20.0)), "lonlat");
  const std::array both{glm::dvec2(-68.99, -32.54), glm::dvec2(291.01, -32.54)};
  const std::vector<glm::dvec2> local = utm->to_local(both);
  EXPECT_NEAR(local[0].x, local[1].x, 1e-6);
}

// Fails if a place that rounding puts beyond the edge is off the map, or one that is beyond it is on it.
TEST_F(MadeMaps, KeepRoundingOnTheEdge) {
  const MapFrame map = frame(made("utm.tif", "EPSG:32719", 499990.0, 6400000.0, 20.0));
  const auto coordinates = map_coordinates(map, "map");
  const std::array places{glm::dvec2(500000.0 - 1e-5, 6399990.0 + 1e-5),
                          glm::dvec2(500000.0 - 1e-4, 6399990.0 + 1e-4)};
  const std::vector<glm::dvec2> local = coordinates->to_local(places);
  EXPECT_EQ(local[0], glm::dvec2(0.0));
  EXPECT_LT(local[1].x, 0.0);
  EXPECT_LT(local[1].y, 0.0);
}

// Fails if a place that a system does not have is taken for one.
TEST_F(MadeMaps, HaveNoPlaceForWhatIsNowhere) {
  const auto coordinates =
      map_coordinates(frame(made("utm.tif", "EPSG:32719", 499990.0, 6400000.0, 20.0)), "lonlat");
  const std::array places{glm::dvec2(-69.0, -132.0), glm::dvec2(1e8, 1e8)};
  for (const glm::dvec2& local : coordinates->to_local(places)) EXPECT_TRUE(std::isnan(local.x));
}

// Fails if a system that is none, or that a map cannot have, is no error of input.
TEST_F(MadeMaps, RefuseWhatIsNoSystem) {
  const MapFrame utm = frame(made("utm.tif", "EPSG:32719", 499990.0, 6400000.0, 20.0));
  const auto refuse = [](const MapFrame& map, const std::string& system, const std::string& expected) {
    try {
      map_coordinates(map, system);
      ADD_FAILURE() << system;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_THAT(error.what(), ::testing::HasSubstr(expected));
      EXPECT_NE(error.hint(), "");
    }
  };
  for (const char* system : {"EPSG:1", "atlantis", "", "EPSG:4978", "/etc/passwd", "http://127.0.0.1/a"})
    refuse(utm, system, "--crs: expected local, map, lonlat");
  MapFrame nowhere = utm;
  nowhere.georeference = {};
  refuse(nowhere, "map", "utm.tif: expected a map with a place");
  nowhere.georeference = {"", 0.0, 100.0, 1.0, -1.0};
  EXPECT_NO_THROW(map_coordinates(nowhere, "map"));
  refuse(nowhere, "lonlat", "no coordinate system");
  nowhere.georeference.coordinate_system = R"(LOCAL_CS["generated terrain",UNIT["metre",1]])";
  refuse(nowhere, "lonlat", "generated terrain");
}

}  // namespace
}  // namespace offing::test
