// Maps that are read row by row against the same maps read at once.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <gdal.h>
#include <gtest/gtest.h>

#include "host/io/height_maps/gdal_session.h"
#include "host/io/height_maps/read_height_map.h"
#include "tests/io/height_maps/raster_writer.h"
#include "tests/io/temporary_folder.h"
#include "tests/ocl/expect_error.h"

namespace offing {
namespace {

using test::Raster;

double height_of(int column, int row) {
  return 100 + 7 * column + 53 * row;
}

/// A raster of 20 m by 30 m cells whose first one is so many columns and rows from the corner.
Raster raster_at(int columns, int rows, int first_column, int first_row) {
  Raster raster = test::raster_of(
      columns, rows, [&](int column, int row) { return height_of(column + first_column, row + first_row); });
  raster.geotransform = {500'000.0 + 20.0 * first_column, 20.0, 0.0,
                         6'400'000.0 - 30.0 * first_row,  0.0,  -30.0};
  raster.coordinate_system = "EPSG:32719";
  return raster;
}

class StreamHeightMap : public ::testing::Test {
 protected:
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

  /// Rows as they come.
  HeightMapFile stream(const std::string& name, const HeightMapOptions& options = {}) const {
    HeightMapFile file;
    std::vector<float> heights_m;
    const HeightMapSource source = stream_height_map(
        path(name), options, [&](const HeightMapFile& about) { file = about; },
        [&](std::span<const float> row, std::span<const std::uint8_t> is_void) {
          EXPECT_EQ(is_void.size(), row.size());
          file.map.is_void.insert(file.map.is_void.end(), is_void.begin(), is_void.end());
          EXPECT_EQ(row.size(), static_cast<std::size_t>(file.map.columns));
          heights_m.insert(heights_m.end(), row.begin(), row.end());
        });
    file.source = source;
    file.map.heights_m = heights_m;
    return file;
  }

  TemporaryFolder folder_;
};

// Fails if heights, size, place or range differ from those of the whole map, whose 700 rows are more than two
// bands.
TEST_F(StreamHeightMap, IsTheMap) {
  test::write_raster(path("map.tif"), "GTiff", raster_at(40, 700, 0, 0));
  const HeightMapFile streamed = stream("map.tif"), whole = read_height_map(path("map.tif"));
  EXPECT_EQ(streamed.map.heights_m, whole.map.heights_m);
  EXPECT_EQ(streamed.map.spacing_x_m, 20.0);
  EXPECT_EQ(streamed.map.spacing_z_m, 30.0);
  EXPECT_EQ(streamed.map.georeference.origin_y, whole.map.georeference.origin_y);
  EXPECT_EQ(streamed.source.centre_latitude_deg, whole.source.centre_latitude_deg);
  EXPECT_EQ(streamed.source.lowest_m, whole.source.lowest_m);
  EXPECT_EQ(streamed.source.highest_m, whole.source.highest_m);
}

// Fails if ASCII grids of a folder are read as GDAL takes them, with 0 m for what is missing or "nan", or if
// one may not have decimals where another has none.
TEST_F(StreamHeightMap, ChecksTheAsciiGridsOfAFolder) {
  std::filesystem::create_directory(path("grids"));
  HeightMapOptions options;
  options.horizontal_unit = HorizontalUnit::metre;
  std::string integers;
  for (int i = 0; i < 300'000; ++i) integers += i % 300 == 299 ? "12\n" : "12 ";
  const auto write = [&](const char* name, int left, const std::string& last) {
    std::ofstream(path("grids") / name)
        << "ncols 300\nnrows 1000\nxllcenter " << left << "\nyllcenter 45000\ncellsize 10\n"
        << integers.substr(0, integers.size() - 3) << last << "\n";
  };
  write("a.asc", 7000, "12");
  write("b.asc", 10'000, "1.5");
  EXPECT_EQ(stream("grids", options).map.heights_m.back(), 1.5f);
  EXPECT_EQ(stream("grids", options).map.columns, 600);
  write("b.asc", 10'000, "");
  test::expect_error(ErrorKind::bad_input, "b.asc:1005: expected 300000 heights, found 299999",
                     [&] { stream("grids", options); });
  write("b.asc", 10'000, "nan");
  test::expect_error(ErrorKind::bad_input, "row 999, column 599: expected a finite height, found nan",
                     [&] { stream("grids", options); });
}

// Fails if GDAL keeps more of the map than 16 MiB, which is more than some hundred of its rows: it is 17.6
// MB.
TEST_F(StreamHeightMap, KeepsFewRowsInMemory) {
  test::write_raster(path("map.tif"), "GTiff", raster_at(2100, 2100, 0, 0));
  const GIntBig usual_bytes = GDALGetCacheMax64();
  GIntBig most_bytes = 0;
  stream_height_map(
      path("map.tif"), {}, [](const HeightMapFile&) {},
      [&](std::span<const float>, std::span<const std::uint8_t>) {
        most_bytes = std::max(most_bytes, GDALGetCacheUsed64());
      });
  EXPECT_GT(most_bytes, 0);
  EXPECT_LE(most_bytes, GIntBig{16} << 20);
  EXPECT_EQ(GDALGetCacheMax64(), usual_bytes);
}

// Fails if the size that GDAL's cache had is not restored when two readings end in the order in which they
// began.
TEST_F(StreamHeightMap, RestoresTheCacheAfterTheLastReading) {
  test::write_raster(path("map.tif"), "GTiff", raster_at(40, 700, 0, 0));
  const height_maps::GdalSession session;
  const height_maps::Dataset map(GDALOpen(path("map.tif").c_str(), GA_ReadOnly));
  const GIntBig usual_bytes = GDALGetCacheMax64();
  std::optional<height_maps::CacheBound> first(map.get()), second(map.get());
  const GIntBig bound_bytes = GDALGetCacheMax64();
  EXPECT_LT(bound_bytes, usual_bytes);
  first.reset();
  EXPECT_EQ(GDALGetCacheMax64(), bound_bytes);
  second.reset();
  EXPECT_EQ(GDALGetCacheMax64(), usual_bytes);
}

// Four files of one map, in a folder.
TEST_F(StreamHeightMap, JoinsTheFilesOfAFolder) {
  std::filesystem::create_directory(path("tiles"));
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 2; ++column) {
      test::write_raster(path("tiles/" + std::to_string(10 * row + column) + ".tif"), "GTiff",
                         raster_at(30, 50, 30 * column, 50 * row));
    }
  }
  const HeightMapFile file = stream("tiles");
  ASSERT_EQ(file.map.columns, 60);
  ASSERT_EQ(file.map.rows, 100);
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 60; ++column) {
      ASSERT_EQ(file.map.heights_m[file.map.index(column, row)], height_of(column, row));
    }
  }
}

// Voids across the border of two bands (rows 256 and on) are filled without a step, between the lowest and
// the highest of what is around; those before the first height are level.
TEST_F(StreamHeightMap, FillsVoidsInBands) {
  constexpr double nodata = -9999.0;
  Raster raster = test::raster_of(64, 600, [&](int column, int row) {
    const bool is_hole = row >= 230 && row < 280 && column > 20 && column < 40;
    return is_hole ? nodata : 1000.0 + column + 0.1 * row;
  });
  raster.nodata = nodata;
  test::write_raster(path("holes.tif"), "GTiff", raster);
  HeightMapOptions options;
  options.spacing_x_m = options.spacing_z_m = 10.0;
  const HeightMapFile file = stream("holes.tif", options);
  EXPECT_EQ(file.source.void_posts, 50u * 19u);
  EXPECT_EQ(file.map.is_void, read_height_map(path("holes.tif"), options).map.is_void);
  EXPECT_EQ(file.source.lowest_m, 1000.0f);
  double steepest_m = 0.0;
  for (int row = 1; row < 600; ++row) {
    for (int column = 0; column < 64; ++column) {
      const float height_m = file.map.heights_m[file.map.index(column, row)];
      EXPECT_GE(height_m, 1000.0f);
      EXPECT_LE(height_m, 1123.0f);
      steepest_m = std::max(steepest_m, std::abs(static_cast<double>(height_m) -
                                                 file.map.heights_m[file.map.index(column, row - 1)]));
    }
  }
  // The hole is 19 wide and its rims differ by 20 m: a step of more than half of that would be a seam.
  EXPECT_LT(steepest_m, 10.0);
  options.void_height_m = 7.0;
  EXPECT_EQ(stream("holes.tif", options).map.heights_m[file.map.index(30, 250)], 7.0f);
}

TEST_F(StreamHeightMap, RefusesWhatItCannot) {
  Raster south_up = raster_at(5, 4, 0, 0);
  (*south_up.geotransform)[5] = 30.0;
  test::write_raster(path("south.tif"), "GTiff", south_up);
  test::expect_error(ErrorKind::bad_input, "south-up", [&] { stream("south.tif"); });
  HeightMapOptions options;
  options.reproject_to = "utm";
  test::expect_error(ErrorKind::bad_input, "utm", [&] { stream("south.tif", options); });
  std::filesystem::create_directory(path("empty"));
  test::expect_error(ErrorKind::bad_input, "found none", [&] { stream("empty"); });
  Raster voids = raster_at(5, 4, 0, 0);
  voids.nodata = 3.0;
  for (double& height_m : voids.bands[0]) height_m = 3.0;
  test::write_raster(path("voids.tif"), "GTiff", voids);
  test::expect_error(ErrorKind::bad_input, "nothing but voids", [&] { stream("voids.tif"); });
}

}  // namespace
}  // namespace offing
