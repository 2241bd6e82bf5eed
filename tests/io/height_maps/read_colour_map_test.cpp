#include "host/io/height_maps/read_colour_map.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gdal.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/io/height_maps/raster_writer.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

using test::Raster;
using test::write_raster;

/// A colour of its own for each pixel of small pictures.
double colour_of(int band, int column, int row) {
  return 10 + 20 * column + 3 * row + 70 * band;
}

Raster picture(int columns, int rows, int bands) {
  Raster raster;
  raster.columns = columns;
  raster.rows = rows;
  raster.type = "Byte";
  for (int band = 0; band < bands; ++band) {
    raster.bands.push_back(test::raster_of(columns, rows, [&](int column, int row) {
                             return colour_of(band, column, row);
                           }).bands[0]);
  }
  return raster;
}

/// 11 x 21 posts, 20 m apart from east to west and 30 m from north to south.
HeightMap map_in_metres() {
  HeightMap map;
  map.columns = 11;
  map.rows = 21;
  map.spacing_x_m = 20.0;
  map.spacing_z_m = 30.0;
  map.heights_m.assign(11 * 21, 0.0f);
  map.georeference = {.coordinate_system = "EPSG:32719",
                      .origin_x = 500'000.0,
                      .origin_y = 6'400'000.0,
                      .step_x = 20.0,
                      .step_y = -30.0};
  return map;
}

class ReadColourMap : public ::testing::Test {
 protected:
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

  static void expect_colours(const ColourMap& colours, int columns, int rows) {
    ASSERT_EQ(colours.columns, columns);
    ASSERT_EQ(colours.rows, rows);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        for (int band = 0; band < 3; ++band) {
          const auto place = static_cast<std::size_t>(4 * (row * columns + column) + band);
          ASSERT_EQ(colours.rgba[place], colour_of(band, column, row)) << column << ", " << row;
        }
        ASSERT_EQ(colours.rgba[static_cast<std::size_t>(4 * (row * columns + column) + 3)], 255);
      }
    }
  }

  TemporaryFolder folder_;
};

// Fails if the edges of a picture without a place are not those of the map, which are its outer posts.
TEST_F(ReadColourMap, StretchesWhatHasNoPlace) {
  write_raster(path("picture.png"), "PNG", picture(4, 3, 3));
  const ColourMap colours = read_colour_map(path("picture.png"), map_in_metres());
  expect_colours(colours, 4, 3);
  EXPECT_EQ(colours.left, 0.0);
  EXPECT_EQ(colours.top, 0.0);
  EXPECT_EQ(colours.right, 10.0);
  EXPECT_EQ(colours.bottom, 20.0);
  HeightMap nowhere = map_in_metres();
  nowhere.georeference = {};
  Raster placed = picture(4, 3, 3);
  placed.geotransform = {7.0, 1.0, 0.0, 9.0, 0.0, -1.0};
  write_raster(path("placed.tif"), "GTiff", placed);
  EXPECT_EQ(read_colour_map(path("placed.tif"), nowhere).right, 10.0);
}

// Fails if pixels are shifted by half of one, if north and south or the two spacings are confused: 5 m pixels
// from 40 m east and 60 m south of the first post.
TEST_F(ReadColourMap, PlacesByGeoreference) {
  Raster placed = picture(4, 3, 3);
  placed.geotransform = {500'040.0, 5.0, 0.0, 6'399'940.0, 0.0, -6.0};
  placed.coordinate_system = "EPSG:32719";
  write_raster(path("placed.tif"), "GTiff", placed);
  const ColourMap colours = read_colour_map(path("placed.tif"), map_in_metres());
  expect_colours(colours, 4, 3);
  EXPECT_DOUBLE_EQ(colours.left, 2.0);
  EXPECT_DOUBLE_EQ(colours.right, 3.0);
  EXPECT_DOUBLE_EQ(colours.top, 2.0);
  EXPECT_DOUBLE_EQ(colours.bottom, 2.6);

  // The same from south to north.
  Raster turned = placed;
  turned.geotransform = {500'040.0, 5.0, 0.0, 6'399'922.0, 0.0, 6.0};
  for (int band = 0; band < 3; ++band) {
    turned.bands[static_cast<std::size_t>(band)] =
        test::raster_of(4, 3, [&](int column, int row) { return colour_of(band, column, 2 - row); }).bands[0];
  }
  write_raster(path("turned.tif"), "GTiff", turned);
  const ColourMap from_south = read_colour_map(path("turned.tif"), map_in_metres());
  expect_colours(from_south, 4, 3);
  EXPECT_DOUBLE_EQ(from_south.top, 2.0);
  EXPECT_DOUBLE_EQ(from_south.bottom, 2.6);
}

// A picture in the next zone of UTM, in the middle of the map: (500100, 6399700) of EPSG:32719 is
// (1063921.98, 6383779.39) of EPSG:32718 (PROJ 9.1, on its own way). Fails if it is taken as the map's.
// Resampling keeps its middle within a pixel of 2 m: gate 0.2 posts.
TEST_F(ReadColourMap, BringsOtherSystemsToTheMaps) {
  Raster placed = picture(64, 64, 3);
  placed.geotransform = {1'063'857.98, 2.0, 0.0, 6'383'843.39, 0.0, -2.0};
  placed.coordinate_system = "EPSG:32718";
  write_raster(path("zone.tif"), "GTiff", placed);
  const ColourMap colours = read_colour_map(path("zone.tif"), map_in_metres());
  EXPECT_NEAR(0.5 * (colours.left + colours.right), 5.0, 0.2);
  EXPECT_NEAR(0.5 * (colours.top + colours.bottom), 10.0, 0.2);
  // Turned by the convergence of the meridians, its corners are not covered.
  EXPECT_EQ(colours.rgba[3], 0);
}

// Fails if grey, wide, transparent or palette pictures are refused or misread.
TEST_F(ReadColourMap, ReadsOtherSamples) {
  write_raster(path("grey.png"), "PNG", picture(4, 3, 1));
  const ColourMap grey = read_colour_map(path("grey.png"), map_in_metres());
  for (std::size_t channel = 0; channel < 3; ++channel) EXPECT_EQ(grey.rgba[4 + channel], colour_of(0, 1, 0));

  Raster wide = picture(4, 3, 3);
  wide.type = "UInt16";
  for (auto& band : wide.bands) {
    for (double& value : band) value *= 257.0;
  }
  write_raster(path("wide.tif"), "GTiff", wide);
  expect_colours(read_colour_map(path("wide.tif"), map_in_metres()), 4, 3);

  Raster transparent = picture(4, 3, 4);
  transparent.bands[3].assign(12, 0.0);
  transparent.bands[3][5] = 255.0;
  write_raster(path("transparent.png"), "PNG", transparent);
  const ColourMap holes = read_colour_map(path("transparent.png"), map_in_metres());
  EXPECT_EQ(holes.rgba[4 * 4 + 3], 0);
  EXPECT_EQ(holes.rgba[4 * 5 + 3], 255);
}

TEST_F(ReadColourMap, RefusesWithAHint) {
  std::ofstream(path("text.png")) << "no picture";
  Raster heights = test::raster_of(4, 3, [](int column, int) { return 0.5 * column; });
  write_raster(path("heights.tif"), "GTiff", heights);
  Raster elsewhere = picture(4, 3, 3);
  elsewhere.geotransform = {600'000.0, 5.0, 0.0, 6'399'940.0, 0.0, -6.0};
  elsewhere.coordinate_system = "EPSG:32719";
  write_raster(path("elsewhere.tif"), "GTiff", elsewhere);
  Raster rotated = elsewhere;
  rotated.geotransform = {500'000.0, 5.0, 1.0, 6'399'940.0, 1.0, -6.0};
  write_raster(path("rotated.tif"), "GTiff", rotated);
  for (const char* const name :
       {"none.png", "text.png", "heights.tif", "elsewhere.tif", "rotated.tif", "."}) {
    try {
      read_colour_map(path(name), map_in_metres());
      ADD_FAILURE() << name << " was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input) << name;
      EXPECT_THAT(error.what(), ::testing::HasSubstr("expected")) << name;
      EXPECT_FALSE(std::string(error.hint()).empty()) << name;
    }
  }
}

// Fails if what GDAL would open, but is no file, is opened.
TEST_F(ReadColourMap, ReadsFilesAlone) {
  for (const char* const name : {".", "/dev/null"}) {
    try {
      read_colour_map(std::filesystem::path(name), map_in_metres());
      ADD_FAILURE() << name << " was read";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("expected a picture, found a ")) << name;
    }
  }
}

// Fails if GDAL may keep 5 % of the memory of the machine while a picture is read, or afterwards less.
TEST_F(ReadColourMap, KeepsFewRowsInMemory) {
  write_raster(path("picture.tif"), "GTiff", picture(2500, 2500, 3));
  const GIntBig usual_bytes = GDALGetCacheMax64();
  std::atomic<bool> is_read = false;
  GIntBig least_bytes = usual_bytes;
  std::thread watch([&] {
    while (!is_read) least_bytes = std::min(least_bytes, GDALGetCacheMax64());
  });
  read_colour_map(path("picture.tif"), map_in_metres());
  is_read = true;
  watch.join();
  EXPECT_EQ(least_bytes, GIntBig{16} << 20);
  EXPECT_EQ(GDALGetCacheMax64(), usual_bytes);
}

}  // namespace
}  // namespace offing
