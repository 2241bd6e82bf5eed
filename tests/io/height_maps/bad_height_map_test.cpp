#include <cmath>
#include <fstream>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/io/height_maps/read_height_map.h"
#include "tests/io/height_maps/raster_writer.h"
#include "tests/io/temporary_folder.h"
#include "tests/ocl/log_capture.h"

namespace offing {
namespace {

using test::Raster;
using test::raster_of;
using test::write_raster;
using ::testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Each test fails if a bad file is taken for a map, or its error does not say which file and what is wrong
/// on one line, with the fix beside it.
class BadHeightMap : public ::testing::Test {
 protected:
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

  static Raster in_metres(int columns, int rows) {
    Raster raster = raster_of(columns, rows, [](int column, int row) { return column + 10.0 * row; });
    raster.geotransform = {500000.0, 20.0, 0.0, 6400000.0, 0.0, -20.0};
    raster.coordinate_system = "EPSG:32719";
    return raster;
  }

  static void expect_error(const std::filesystem::path& path, ErrorKind kind, const std::string& part,
                           const HeightMapOptions& options = {}) {
    try {
      read_height_map(path, options);
      ADD_FAILURE() << path << ": expected an Error that says " << part;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), kind) << error.what();
      EXPECT_THAT(error.what(), HasSubstr(path.string()));
      EXPECT_THAT(error.what(), HasSubstr(part));
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      EXPECT_NE(error.hint(), "");
    }
  }

  TemporaryFolder folder_;
};

TEST_F(BadHeightMap, NoFileAndAFolder) {
  expect_error(path("none.tif"), ErrorKind::bad_input, "no such file");
  expect_error(folder_.path(), ErrorKind::bad_input, "found a folder");
}

TEST_F(BadHeightMap, ForeignContent) {
  std::ofstream(path("text.tif")) << "these are no heights";
  expect_error(path("text.tif"), ErrorKind::bad_input, "cannot be opened");
}

TEST_F(BadHeightMap, CutShort) {
  write_raster(path("cut.tif"), "GTiff", in_metres(300, 200));
  std::filesystem::resize_file(path("cut.tif"), std::filesystem::file_size(path("cut.tif")) / 2);
  expect_error(path("cut.tif"), ErrorKind::bad_input, "can be read");
}

TEST_F(BadHeightMap, NothingButVoids) {
  Raster raster = in_metres(5, 4);
  raster.nodata = -9999.0;
  raster.bands[0].assign(20, -9999.0);
  write_raster(path("voids.tif"), "GTiff", raster);
  expect_error(path("voids.tif"), ErrorKind::bad_input, "nothing but voids");
}

TEST_F(BadHeightMap, ASingleRow) {
  write_raster(path("row.tif"), "GTiff", in_metres(9, 1));
  expect_error(path("row.tif"), ErrorKind::bad_input, "9x1 posts, expected at least 2x2");
}

TEST_F(BadHeightMap, HeightsThatAreNotFinite) {
  for (const double bad : {nan, HUGE_VAL, -HUGE_VAL}) {
    Raster raster = in_metres(5, 4);
    raster.bands[0][7] = bad;
    write_raster(path("bad.tif"), "GTiff", raster);
    expect_error(path("bad.tif"), ErrorKind::bad_input, "row 1, column 2: expected a finite height");
  }
}

// Fails if a store or a frame gets heights that rays are not made for.
TEST_F(BadHeightMap, HeightsThatAreTooFar) {
  Raster raster = in_metres(5, 4);
  raster.bands[0][7] = -1.5e6;
  write_raster(path("deep.tif"), "GTiff", raster);
  expect_error(path("deep.tif"), ErrorKind::bad_input, "row 1, column 2: expected a height within 1e+06 m");
  raster.bands[0][7] = 0.0;
  write_raster(path("good.tif"), "GTiff", raster);
  HeightMapOptions options;
  options.void_height_m = 1e39;
  expect_error(path("good.tif"), ErrorKind::bad_input, "height of voids within 1e+06 m, found 1e+39",
               options);
}

TEST_F(BadHeightMap, NoSpacing) {
  write_raster(path("good.tif"), "GTiff", in_metres(5, 4));
  HeightMapOptions options;
  options.spacing_x_m = options.spacing_z_m = 0.0;
  expect_error(path("good.tif"), ErrorKind::bad_input, "spacing of posts within 0.001 ... 100000 m, found 0",
               options);
  std::ofstream(path("flat.vrt"))
      << "<VRTDataset rasterXSize=\"4\" rasterYSize=\"4\"><GeoTransform>0,0,0,0,0,-1"
         "</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\"/></VRTDataset>";
  expect_error(path("flat.vrt"), ErrorKind::bad_input, "a spacing of posts other than 0, found 0 by");
}

// One spacing along x for 50 degrees of latitude would be wrong by a third.
TEST_F(BadHeightMap, DegreesThatOneSpacingDoesNotSuit) {
  Raster raster = in_metres(50, 50);
  raster.geotransform = {0.0, 1.0, 0.0, 70.0, 0.0, -1.0};
  raster.coordinate_system = "EPSG:4326";
  write_raster(path("wide.tif"), "GTiff", raster);
  expect_error(path("wide.tif"), ErrorKind::bad_input, "spacing along x changes by");
}

TEST_F(BadHeightMap, MercatorThatOneSpacingDoesNotSuit) {
  Raster raster = in_metres(50, 50);
  raster.geotransform = {0.0, 1e5, 0.0, 9e6, 0.0, -1e5};
  raster.coordinate_system = "EPSG:3857";
  write_raster(path("wide.tif"), "GTiff", raster);
  expect_error(path("wide.tif"), ErrorKind::bad_input, "in Mercator from");
}

// Fails if what is no number among whole ones is read as 0.
TEST_F(BadHeightMap, NotANumberAmongIntegers) {
  for (const char* bad : {"nan", "inf"}) {
    std::ofstream(path("grid.asc")) << "ncols 2\nnrows 2\nxllcenter 7000\nyllcenter 45000\ncellsize 10\n1 2\n"
                                    << bad << " 4\n";
    expect_error(path("grid.asc"), ErrorKind::bad_input, "finite");
  }
}

// Fails if what is missing or no number is read as 0 m, or its line is not said; or if a way of writing
// numbers that GDAL reads is refused.
TEST_F(BadHeightMap, AnAsciiGridWithoutAllItsHeights) {
  const std::string header = "ncols 2\nnrows 2\nxllcenter 7000\nyllcenter 45000\ncellsize 10\n";
  const auto write = [&](const std::string& content) {
    std::ofstream(path("grid.asc")) << header << content;
    return path("grid.asc");
  };
  expect_error(write("1 2\n3\n"), ErrorKind::bad_input, "grid.asc:7: expected 4 heights, found 3");
  expect_error(write("1.5 2\n3 \n"), ErrorKind::bad_input, "grid.asc:7: expected 4 heights, found 3");
  expect_error(write("1 2\n3 x\n"), ErrorKind::bad_input,
               "grid.asc:7: expected 4 heights, found \"x\" after 3");
  expect_error(write("1 2\n\n4m 3\n"), ErrorKind::bad_input, "grid.asc:8: expected 4 heights, found \"4m\"");
  EXPECT_EQ(read_height_map(write("1 2\n3 4")).map.heights_m.back(), 4.0f);
  EXPECT_EQ(read_height_map(write("+1e0 2.5 -3\r\n4.\r\n")).map.heights_m.back(), 4.0f);
}

// Fails if what GDAL reads as 0 or 1 m in a source of a VRT is taken for a height: no option of ours reaches
// it.
TEST_F(BadHeightMap, AVrtOfAnAsciiGrid) {
  std::ofstream(path("grid.vrt"))
      << "<VRTDataset rasterXSize='2' "
         "rasterYSize='2'><GeoTransform>0,10,0,0,0,-10</GeoTransform><VRTRasterBand "
         "dataType='Float32' band='1'><SimpleSource><SourceFilename "
         "relativeToVRT='1'>grid.asc</SourceFilename>"
         "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>";
  const auto outcome = [&](const std::string& content) -> std::string {
    std::ofstream(path("grid.asc")) << "ncols 2\nnrows 2\nxllcenter 7000\nyllcenter 45000\ncellsize 10\n"
                                    << content;
    HeightMapOptions options;
    options.horizontal_unit = HorizontalUnit::metre;
    try {
      read_height_map(path("grid.vrt"), options);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  };
  EXPECT_EQ(outcome("1 2\n3 4\n"), "");
  EXPECT_EQ(outcome("1.5 2\n3 4\n"), "");
  EXPECT_THAT(outcome("1 2\n3\n"), HasSubstr("grid.asc:7: expected 4 heights, found 3"));
  EXPECT_THAT(outcome("1 2\n3 nan\n"), HasSubstr("grid.asc:7: expected whole heights"));
}

// Fails if a georeference that no map can have is taken.
TEST_F(BadHeightMap, AGeoreferenceThatCannotBe) {
  Raster raster = in_metres(5, 4);
  raster.geotransform = {500000.0, 1e-13, 0.0, 6400000.0, 0.0, -1e-13};
  write_raster(path("dense.tif"), "GTiff", raster);
  expect_error(path("dense.tif"), ErrorKind::bad_input, "spacing of posts within 0.001");
  raster.geotransform = {7.0, 0.01, 0.0, 95.0, 0.0, -0.01};
  raster.coordinate_system = "EPSG:4326";
  write_raster(path("pole.tif"), "GTiff", raster);
  expect_error(path("pole.tif"), ErrorKind::bad_input, "latitudes within 90 degrees, found 94.965 to 94.995");
  HeightMapOptions options;
  options.spacing_x_m = options.spacing_z_m = 30.0;
  const HeightMapFile file = read_height_map(path("pole.tif"), options);
  EXPECT_EQ(file.map.spacing_x_m, 30.0);
  EXPECT_FALSE(file.source.centre_latitude_deg);
}

// Fails if samples that often mark voids are taken for heights without a warning, or with one though the file
// or the caller has said what they are.
TEST_F(BadHeightMap, SamplesThatOftenMarkVoids) {
  const auto warning = [&](const Raster& raster, const HeightMapOptions& options = {}) {
    write_raster(path("map.tif"), "GTiff", raster);
    const test::LogCapture log;
    read_height_map(path("map.tif"), options);
    return log.text();
  };
  Raster raster = in_metres(5, 4);
  EXPECT_EQ(warning(raster), "");
  raster.bands[0][7] = raster.bands[0][9] = -9999.0;
  EXPECT_THAT(warning(raster), HasSubstr("2 posts of -9999 m"));
  EXPECT_THAT(warning(raster), HasSubstr("--nodata -9999"));
  HeightMapOptions options;
  options.nodata = -9999.0;
  EXPECT_EQ(warning(raster, options), "");
  raster.nodata = -1.0;
  EXPECT_EQ(warning(raster), "");
  raster.nodata.reset();
  raster.bands[0][7] = raster.bands[0][9] = -32768.0;
  EXPECT_THAT(warning(raster), HasSubstr("--nodata -32768"));
  raster.type = "Int16";  // as SRTM has it
  EXPECT_EQ(warning(raster), "");
}

TEST_F(BadHeightMap, MetresOrDegrees) {
  std::ofstream(path("grid.asc"))
      << "ncols 2\nnrows 2\nxllcenter 7\nyllcenter 45\ncellsize 0.001\n1 2\n3 4\n";
  expect_error(path("grid.asc"), ErrorKind::bad_input, "metres or degrees?");
  HeightMapOptions options;
  options.horizontal_unit = HorizontalUnit::degree;
  EXPECT_EQ(read_height_map(path("grid.asc"), options).source.spacing_source, SpacingSource::latitude);
}

// A header for 100,000 x 100,000 floats, 40 GB, over no data: refused before memory is taken, by its size or
// for want of data. The file is a TIFF without any strip that holds bytes.
TEST_F(BadHeightMap, AHeaderWithoutData) {
  Raster raster = in_metres(2, 2);
  raster.creation_options = {"SPARSE_OK=TRUE"};
  raster.bands[0].assign(4, 0.0);
  write_raster(path("sparse.tif"), "GTiff", raster);
  expect_error(path("sparse.tif"), ErrorKind::bad_input, "expected heights, found none");
  std::ofstream(path("huge.vrt")) << "<VRTDataset rasterXSize=\"100000\" rasterYSize=\"100000\">"
                                     "<VRTRasterBand dataType=\"Float32\" band=\"1\"/></VRTDataset>";
  try {
    read_height_map(path("huge.vrt"));
    ADD_FAILURE() << "expected an Error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::AnyOf(HasSubstr("GB of memory"), HasSubstr("found none")));
  }
}

TEST_F(BadHeightMap, ColoursWithoutAnEncodingAndPlainHeightsWithOne) {
  Raster raster = raster_of(3, 3, [](int, int) { return 90.0; });
  raster.type = "Byte";
  raster.bands.resize(3, raster.bands[0]);
  write_raster(path("rgb.png"), "PNG", raster);
  expect_error(path("rgb.png"), ErrorKind::bad_input, "found a colour picture");
  write_raster(path("plain.tif"), "GTiff", in_metres(3, 3));
  HeightMapOptions options;
  options.encoding = HeightEncoding::mapbox;
  expect_error(path("plain.tif"), ErrorKind::bad_input, "expected red, green and blue", options);
}

TEST_F(BadHeightMap, FilesWithoutHeaderOfAnotherSize) {
  std::ofstream(path("a.r16"), std::ios::binary) << std::string(2 * 25, '\1');
  expect_error(path("a.r16"), ErrorKind::bad_input, "expected its size in posts");
  HeightMapOptions options;
  options.raw_columns = 6;
  options.raw_rows = 5;
  expect_error(path("a.r16"), ErrorKind::bad_input, "take 60 bytes, found 50", options);
}

TEST_F(BadHeightMap, NothingToReprojectFrom) {
  Raster raster = raster_of(3, 3, [](int, int) { return 90.0; });
  raster.type = "UInt16";
  write_raster(path("plain.png"), "PNG", raster);
  HeightMapOptions options;
  options.reproject_to = "utm";
  expect_error(path("plain.png"), ErrorKind::bad_input, "expected a file with a coordinate system", options);
  write_raster(path("good.tif"), "GTiff", in_metres(3, 3));
  options.reproject_to = "EPSG:4326";
  expect_error(path("good.tif"), ErrorKind::bad_input, "expected a coordinate system in metres", options);
}

}  // namespace
}  // namespace offing
