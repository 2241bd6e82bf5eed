// Rasters that lead elsewhere: to servers, to any bytes of the machine, out of their folder.
#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gdal.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/io/height_maps/files_of_raster.h"
#include "host/io/height_maps/map_features.h"
#include "host/io/height_maps/read_colour_map.h"
#include "host/io/height_maps/read_height_map.h"
#include "tests/io/height_maps/raster_writer.h"
#include "tests/io/local_server.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr FileTrust untrusted{.trust = Trust::untrusted};

class HostileRaster : public ::testing::Test {
 protected:
  HostileRaster() {
    fs::create_directory(path("own"));
    for (const char* name : {"own/map.tif", "secret.tif"}) {
      test::Raster raster = test::raster_of(8, 6, [](int column, int row) { return column + 10.0 * row; });
      raster.geotransform = {500000.0, 20.0, 0.0, 6400000.0, 0.0, -20.0};
      raster.coordinate_system = "EPSG:32719";
      test::write_raster(path(name), "GTiff", raster);
    }
  }

  fs::path path(const std::string& name) const { return folder_.path() / name; }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  /// A VRT of 8 x 6 posts with one band of this kind and content.
  static std::string vrt(const std::string& content, const std::string& band = "") {
    return fmt::format(
        R"(<VRTDataset rasterXSize="8" rasterYSize="6"><GeoTransform>0,20,0,0,0,-20</GeoTransform>)"
        R"(<VRTRasterBand dataType="Float32" band="1" {}>{}</VRTRasterBand></VRTDataset>)",
        band, content);
  }
  static std::string source(const std::string& name, const std::string& attribute = "") {
    return fmt::format(
        R"(<SimpleSource><SourceFilename {}>{}</SourceFilename><SourceBand>1</SourceBand></SimpleSource>)",
        attribute, name);
  }

  /// What reading it says; "" if it is read.
  static std::string outcome(const fs::path& file, const FileTrust& trust = {}) {
    try {
      HeightMapOptions options;
      options.trust = trust;
      options.horizontal_unit = HorizontalUnit::metre;
      read_height_map(file, options);
      return "";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
      EXPECT_NE(error.hint(), "") << error.what();
      return error.what();
    }
  }

  TemporaryFolder folder_;
  test::LocalServer server_;
};

// Fails if a tile of a small file may take gigabytes of memory: all bands of a pixel lie together.
TEST_F(HostileRaster, OfManyBandsIsRefused) {
  const auto tiff_of = [](std::uint16_t bands) {
    const std::vector<std::array<std::uint16_t, 2>> tags{{256, 6},   {257, 5},     {258, 8}, {259, 1},
                                                         {262, 1},   {277, bands}, {284, 1}, {322, 256},
                                                         {323, 256}, {324, 0},     {325, 0}, {339, 1}};
    std::string text("II*\0\10\0\0\0", 8);
    const auto add = [&text](std::uint32_t value, int bytes) {
      for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 255);
    };
    add(static_cast<std::uint32_t>(tags.size()), 2);
    for (const auto& [tag, value] : tags) {
      add(tag, 2);
      add(3, 2);  // the type: 16 bits
      add(1, 4);
      add(value, 4);
    }
    add(0, 4);
    return text;
  };
  EXPECT_THAT(outcome(write("bands.tif", tiff_of(65532))),
              HasSubstr("expected blocks of at most 1 GB, found 256 x 256 pixels of 65532 bands: 4.0 GB"));
  EXPECT_THAT(outcome(write("few.tif", tiff_of(3))), testing::Not(HasSubstr("blocks")));
}

// Fails if GDAL is asked for an address, or opens a description of a server whatever its file is called.
TEST_F(HostileRaster, ReachesNoServer) {
  const std::string url = server_.url();
  EXPECT_THAT(outcome("/vsicurl/" + url + "/map.tif"), HasSubstr("found an address"));
  EXPECT_THAT(outcome(url + "/map.tif"), HasSubstr("found an address"));
  EXPECT_THAT(outcome("/vsizip/" + path("a.zip").string()), HasSubstr("found an address"));
  const std::string wms = fmt::format(
      "<GDAL_WMS><Service "
      "name=\"TMS\"><ServerUrl>{}/${{z}}/${{x}}/${{y}}.png</ServerUrl></Service><DataWindow>"
      "<UpperLeftX>-10</UpperLeftX><UpperLeftY>10</UpperLeftY><LowerRightX>10</LowerRightX><LowerRightY>-10"
      "</LowerRightY><SizeX>256</SizeX><SizeY>256</SizeY></DataWindow><BandsCount>1</BandsCount></GDAL_WMS>",
      url);
  const std::string wcs = fmt::format(
      "<WCS_GDAL><ServiceURL>{}/?</ServiceURL><CoverageName>a</CoverageName>"
      "</WCS_GDAL>",
      url);
  EXPECT_THAT(outcome(write("wms.tif", wms)), HasSubstr("cannot be opened"));
  EXPECT_THAT(outcome(write("wcs.tif", wcs)), HasSubstr("cannot be opened"));
  EXPECT_THAT(outcome(write("curl.vrt", vrt(source("/vsicurl/" + url + "/a.tif")))), HasSubstr("sources"));
  EXPECT_THAT(outcome(write("attribute.vrt",
                            vrt(fmt::format(R"(<SimpleSource SourceFilename="/vsicurl/{}/a.tif"/>)", url)))),
              HasSubstr("sources"));
  write("wms.xml", wms);
  EXPECT_THAT(outcome(write("wms.vrt", vrt(source("wms.xml", R"(relativeToVRT="1")")))),
              HasSubstr("cannot be opened"));
  for (const char* name : {"own/map.tif.msk", "own/map.tif.OVR", "own/Map.TIF.mSk"}) {
    write(name, wms);
    EXPECT_THAT(outcome(path("own/map.tif")), HasSubstr("expected a GeoTIFF")) << name;
    fs::remove(path(name));
  }
  for (const char* name : {"wms.tif", "curl.vrt", "attribute.vrt", "wms.vrt"}) {
    EXPECT_THAT(height_maps::files_of_raster(path(name), Trust::trusted), ::testing::IsEmpty()) << name;
  }
  EXPECT_THAT(height_maps::files_of_raster(path("own/map.tif"), Trust::trusted),
              ::testing::ElementsAre(path("own/map.tif")));
  EXPECT_EQ(server_.callers(), 0);
}

// Fails if a name of a coordinate system, a mask or overviews make GDAL call a server.
TEST_F(HostileRaster, ReachesNoServerBesideIts) {
  const std::string url = server_.url();
  HeightMap map = read_height_map(path("secret.tif")).map;
  test::Raster picture = test::raster_of(8, 6, [](int column, int row) { return column + 10.0 * row; });
  picture.type = "Byte";
  picture.geotransform = {500000.0, 20.0, 0.0, 6400000.0, 0.0, -20.0};
  picture.coordinate_system = "EPSG:32719";
  test::write_raster(path("picture.tif"), "GTiff", picture);
  const std::string system = map.georeference.coordinate_system;
  map.georeference.coordinate_system = url + "/system";
  EXPECT_EQ(read_colour_map(path("picture.tif"), map).columns, 8);
  map.georeference.coordinate_system = "EPSG:32718";
  const GDALDatasetH file = GDALOpen(path("picture.tif").c_str(), GA_Update);
  GDALSetMetadataItem(file, "OVERVIEW_FILE", ("/vsicurl/" + url + "/a.tif").c_str(), "OVERVIEWS");
  GDALClose(file);
  EXPECT_THROW(read_colour_map(path("picture.tif"), map), Error);
  EXPECT_EQ(server_.callers(), 0);
}

// Fails if a VRT shows the bytes of any file of the machine, or runs anything.
TEST_F(HostileRaster, VrtsOnlyJoinRasters) {
  const std::string secret = path("secret.tif").string();
  const std::vector<std::pair<std::string, std::string>> bands{
      {R"(subClass="VRTRawRasterBand")",
       fmt::format("<SourceFilename relativeToVRT=\"0\">{}</SourceFilename>", secret)},
      {R"(subclass="VRTDerivedRasterBand")",
       "<PixelFunctionLanguage>Python</PixelFunctionLanguage><PixelFunctionType>m.f</PixelFunctionType>"},
      {R"(subClass="VRTWarpedRasterBand")", ""},
      {"", "<KernelFilteredSource/>"},
      {"", R"(<Metadata domain="OVERVIEWS"><MDI key="OVERVIEW_FILE">a.vrt</MDI></Metadata>)"},
      {"", source("&lt;VRTDataset/&gt;")},
      {"", source("/etc/passwd")},
      {"", source("none.tif")}};
  for (const auto& [band, content] : bands) {
    EXPECT_THAT(outcome(write("a.vrt", vrt(content, band))), HasSubstr("expected")) << band << content;
  }
  EXPECT_EQ(outcome(write("sound.vrt", vrt(source(secret)))), "");
}

// Fails if VRTs that lead back to themselves are followed without end, or too many in one another are read,
// though some of them were checked before.
TEST_F(HostileRaster, NestedVrtsEnd) {
  const auto near = [](const std::string& name) { return source(name, R"(relativeToVRT="1")"); };
  write("self.vrt", vrt(near("self.vrt")));
  EXPECT_THAT(outcome(path("self.vrt")), HasSubstr("nested VRTs"));
  write("back.vrt", vrt(near("forth.vrt")));
  write("forth.vrt", vrt(near("secret.tif") + near("back.vrt")));
  EXPECT_THAT(outcome(path("forth.vrt")), HasSubstr("nested VRTs"));
  write("0.vrt", vrt(near("secret.tif")));
  for (int i = 1; i <= 8; ++i) write(fmt::format("{}.vrt", i), vrt(near(fmt::format("{}.vrt", i - 1))));
  EXPECT_EQ(outcome(path("7.vrt")), "");
  EXPECT_THAT(outcome(path("8.vrt")), HasSubstr("at most 8 nested VRTs"));
  // First by itself, then below another.
  write("above.vrt", vrt(near("6.vrt")));
  EXPECT_EQ(outcome(write("twice.vrt", vrt(near("6.vrt") + near("5.vrt")))), "");
  EXPECT_THAT(outcome(write("late.vrt", vrt(near("6.vrt") + near("above.vrt")))),
              HasSubstr("at most 8 nested VRTs"));
}

// Fails if listing what an untrusted raster reads opens what it may not lead to.
TEST_F(HostileRaster, ListsNoFilesOutsideOfTheFolder) {
  write("own/a.vrt", vrt(source("../secret.tif", R"(relativeToVRT="1")")));
  EXPECT_EQ(height_maps::files_of_raster(path("own/a.vrt"), Trust::trusted).size(), 2u);
  EXPECT_EQ(height_maps::files_of_raster(path("own/a.vrt"), Trust::untrusted).size(), 0u);
}

// Each of seven VRTs names the next one six times: 6^7 ways, which took 19 s. Fails if each is followed.
TEST_F(HostileRaster, ChecksEachSourceOnce) {
  write("0.vrt", vrt(source("secret.tif", R"(relativeToVRT="1")")));
  for (int i = 1; i <= 7; ++i) {
    std::string content;
    for (int k = 0; k < 6; ++k)
      content += source(fmt::format("{}{}.vrt", k % 2 == 0 ? "" : "own/../", i - 1), R"(relativeToVRT="1")");
    write(fmt::format("{}.vrt", i), vrt(content));
  }
  const auto begin = std::chrono::steady_clock::now();
  height_maps::files_of_raster(path("7.vrt"), Trust::trusted);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
}

// Fails if a scene may name a VRT, whatever it is called.
TEST_F(HostileRaster, NoSceneNamesAVrt) {
  const fs::path file = write("a.tif", vrt(source(path("secret.tif").string())));
  EXPECT_EQ(outcome(file), "");
  EXPECT_THAT(outcome(file, {.is_named_by_scene = true}), HasSubstr("found a VRT"));
  const HeightMap map = read_height_map(path("secret.tif")).map;
  EXPECT_THROW(read_colour_map(file, map, {.is_named_by_scene = true}), Error);
}

// Fails if an untrusted raster leads out of its folder, by a name or by a link; or if it may not lead to
// what lies in it.
TEST_F(HostileRaster, UntrustedOnesStayInTheirFolder) {
  const auto own = [&](const std::string& name) {
    return outcome(write("own/a.vrt", vrt(source(name, R"(relativeToVRT="1")"))), untrusted);
  };
  EXPECT_EQ(own("map.tif"), "");
  EXPECT_THAT(own("../secret.tif"), HasSubstr("found one outside"));
  EXPECT_THAT(own(path("secret.tif").string()), HasSubstr("found"));
  fs::create_symlink(path("secret.tif"), path("own/link.tif"));
  EXPECT_THAT(own("link.tif"), HasSubstr("found one outside"));
  EXPECT_EQ(outcome(path("own/map.tif"), untrusted), "");
  fs::create_symlink(path("secret.tif"), path("own/map.tif.msk"));
  EXPECT_THAT(outcome(path("own/map.tif"), untrusted), HasSubstr("found one outside"));
  fs::remove(path("own/map.tif.msk"));
  write("own/hdf5.nc", "\x89HDF\r\n\x1a\n");
  EXPECT_THAT(outcome(path("own/hdf5.nc"), untrusted), HasSubstr("HDF5"));
  EXPECT_THAT(outcome(path("own/hdf5.nc"), {.is_named_by_scene = true}), HasSubstr("HDF5"));
  write("own/block.nc", std::string(2048, ' ') + "\x89HDF\r\n\x1a\n");
  EXPECT_THAT(outcome(path("own/block.nc"), untrusted), HasSubstr("HDF5"));
}

// Overviews beside a raster are opened by any driver that is registered. Fails if those of features are once
// features were written and read: SQLite would then read what strangers wrote.
TEST(FeatureDrivers, AreNotThereForRasters) {
  if (GDALGetDriverByName("GPKG") != nullptr) GTEST_SKIP() << "another test has registered all: run it alone";
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return folder.path() / name; };
  {
    const auto writer = create_features(
        path("points.gpkg"),
        {.shape = FeatureShape::points, .layer = "points", .coordinate_system = "EPSG:32719", .columns = {}});
    writer->add(std::vector{glm::dvec3(1.0, 2.0, 0.0)}, {});
    writer->commit();
  }
  EXPECT_EQ(read_features(path("points.gpkg"), FeatureShape::points, "").count(), 1u);
  std::ofstream(path("map.asc")) << "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n3 4\n";
  fs::copy_file(path("points.gpkg"), path("map.asc.ovr"));
  try {
    read_height_map(path("map.asc"), {});
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
  }
  for (const char* name : {"GPKG", "GeoJSON"}) EXPECT_EQ(GDALGetDriverByName(name), nullptr) << name;
}

}  // namespace
}  // namespace offing
