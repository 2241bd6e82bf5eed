#include "host/io/height_maps/read_height_map.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/io/exr_image.h"
#include "tests/io/height_maps/raster_writer.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

using test::Raster;
using test::raster_of;
using test::write_raster;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A height of its own for each post of small maps, so that a swapped axis or an offset by one shows; whole
/// metres, which each format holds exactly.
double height_of(int column, int row) {
  return 100 + 7 * column + 53 * row;
}

class ReadHeightMap : public ::testing::Test {
 protected:
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

  static void expect_heights(const HeightMap& map, int columns, int rows) {
    ASSERT_EQ(map.columns, columns);
    ASSERT_EQ(map.rows, rows);
    ASSERT_EQ(map.heights_m.size(), static_cast<std::size_t>(columns * rows));
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        ASSERT_EQ(map.heights_m[map.index(column, row)], height_of(column, row)) << column << ", " << row;
      }
    }
  }

  static Raster in_metres(int columns, int rows) {
    Raster raster = raster_of(columns, rows, height_of);
    raster.geotransform = {500000.0, 20.0, 0.0, 6400000.0, 0.0, -30.0};
    raster.coordinate_system = "EPSG:32719";
    return raster;
  }

  TemporaryFolder folder_;
};

// Fails if rows, columns, the two spacings or the place are confused: the first post lies half a sample
// inside the corner that a GeoTIFF of areas states.
TEST_F(ReadHeightMap, GeoTiffOfAreas) {
  write_raster(path("area.tif"), "GTiff", in_metres(5, 3));
  const HeightMapFile file = read_height_map(path("area.tif"));
  expect_heights(file.map, 5, 3);
  EXPECT_EQ(file.map.spacing_x_m, 20.0);
  EXPECT_EQ(file.map.spacing_z_m, 30.0);
  EXPECT_EQ(file.map.georeference.origin_x, 500010.0);
  EXPECT_EQ(file.map.georeference.origin_y, 6399985.0);
  EXPECT_EQ(file.source.sample_extent, SampleExtent::area);
  EXPECT_EQ(file.source.spacing_source, SpacingSource::file);
  EXPECT_THAT(file.source.coordinate_system, ::testing::HasSubstr("UTM zone 19S"));
  EXPECT_TRUE(file.map.is_void.empty());
}

// Fails if metres of Mercator are taken for metres on the ground. Expected is the scale of the sphere that
// Web Mercator uses over the radii of WGS 84 (Snyder 1987, Map Projections, pages 24 and 41), from other
// formulae than the reader's.
TEST_F(ReadHeightMap, MetresOfMercatorAreLongerThanThoseOfTheGround) {
  struct Case {
    const char* system;
    double latitude_deg;
  };
  for (const auto& [system, latitude_deg] :
       {Case{"EPSG:3857", 0.0}, Case{"EPSG:3857", 32.0}, Case{"EPSG:3857", -60.0}, Case{"EPSG:3395", 60.0}}) {
    constexpr double radius_m = 6378137.0, eccentricity2 = 0.00669437999014, degree = 0.017453292519943295;
    const double latitude = latitude_deg * degree, sine = std::sin(latitude);
    const double w2 = 1.0 - eccentricity2 * sine * sine;
    const bool is_web = std::string_view(system) == "EPSG:3857";
    const double eccentricity = is_web ? 0.0 : std::sqrt(eccentricity2);
    const double y_m = radius_m * (std::atanh(sine) - eccentricity * std::atanh(eccentricity * sine));
    // Along the parallel; along the meridian: that of a sphere over that of the ellipsoid, or the same.
    const double scale_x = std::sqrt(w2) / std::cos(latitude);
    const double scale_z =
        is_web ? w2 * std::sqrt(w2) / ((1.0 - eccentricity2) * std::cos(latitude)) : scale_x;
    Raster raster = in_metres(5, 4);
    raster.geotransform = {1e6, 20.0, 0.0, y_m + 60.0, 0.0, -30.0};
    raster.coordinate_system = system;
    write_raster(path("mercator.tif"), "GTiff", raster);
    const HeightMapFile file = read_height_map(path("mercator.tif"));
    EXPECT_NEAR(file.map.spacing_x_m * scale_x, 20.0, 1e-6) << system << " " << latitude_deg;
    EXPECT_NEAR(file.map.spacing_z_m * scale_z, 30.0, 1e-6) << system << " " << latitude_deg;
    EXPECT_NEAR(file.source.projection_scale, scale_x, 1e-6);
    EXPECT_EQ(file.source.spacing_source, SpacingSource::mercator);
  }
}

// Fails if a GeoTIFF of points is moved by half a sample: its tie point is the post itself. The writer states
// corners in both cases, so the file's tie point is looked for among its bytes.
TEST_F(ReadHeightMap, GeoTiffOfPoints) {
  Raster raster = in_metres(5, 3);
  raster.is_point = true;
  write_raster(path("point.tif"), "GTiff", raster);
  const HeightMapFile file = read_height_map(path("point.tif"));
  EXPECT_EQ(file.source.sample_extent, SampleExtent::point);
  EXPECT_EQ(file.map.georeference.origin_x, 500010.0);
  EXPECT_EQ(file.map.georeference.origin_y, 6399985.0);
  std::ifstream stream(path("point.tif"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  const double tie_point[2] = {500010.0, 6399985.0};
  std::string wanted(sizeof(tie_point), '\0');
  std::memcpy(wanted.data(), tie_point, sizeof(tie_point));
  EXPECT_NE(bytes.find(wanted), std::string::npos);
}

// Fails if a raster whose rows go north is left upside down.
TEST_F(ReadHeightMap, SouthUpRastersAreTurnedOver) {
  Raster raster = raster_of(4, 3, [](int column, int row) { return height_of(column, 2 - row); });
  raster.geotransform = {1000.0, 10.0, 0.0, 2000.0, 0.0, 10.0};
  raster.coordinate_system = "EPSG:32719";
  write_raster(path("south_up.tif"), "GTiff", raster);
  const HeightMapFile file = read_height_map(path("south_up.tif"));
  expect_heights(file.map, 4, 3);
  EXPECT_EQ(file.map.georeference.origin_y, 2025.0);
  EXPECT_EQ(file.map.georeference.step_y, -10.0);
}

// Fails if scale, offset or the unit of heights is dropped: 100 ft are 30.48 m, twice that and 5 m more
// are 65.96.
TEST_F(ReadHeightMap, FeetBecomeMetresBeforeScaleAndOffset) {
  Raster raster = in_metres(4, 3);
  raster.unit = "ft";
  write_raster(path("feet.tif"), "GTiff", raster);
  HeightMapOptions options;
  options.vertical_scale = 2.0;
  options.offset_m = 5.0;
  EXPECT_FLOAT_EQ(read_height_map(path("feet.tif"), options).map.heights_m[0], 65.96f);
}

// Fails if SRTM's big-endian order, its void or its half-sample frame is misread. The name carries the place,
// and the spacing follows from WGS 84: at 45.5 N 1/1200 degree is 92.6180 m along the meridian and 65.1317 m
// along the parallel. Gate 0.001 m: a sphere, or the latitude of an edge, is off by 0.04 m or more.
TEST_F(ReadHeightMap, Hgt) {
  constexpr int side = 1201;
  std::string bytes;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const int height = row == 7 && column == 9 ? -32768 : (row * 3 + column * 5) % 4000 - 100;
      bytes.push_back(static_cast<char>((height >> 8) & 0xff));
      bytes.push_back(static_cast<char>(height & 0xff));
    }
  }
  std::ofstream(path("N45E006.hgt"), std::ios::binary) << bytes;
  const HeightMapFile file = read_height_map(path("N45E006.hgt"));
  ASSERT_EQ(file.map.columns, side);
  EXPECT_EQ(file.source.void_posts, 1u);
  EXPECT_EQ(file.map.is_void[file.map.index(9, 7)], 1);
  EXPECT_EQ(file.map.heights_m[file.map.index(11, 4)], -33.0f);
  EXPECT_EQ(file.source.spacing_source, SpacingSource::latitude);
  EXPECT_NEAR(file.map.georeference.origin_x, 6.0, 1e-9);
  EXPECT_NEAR(file.map.georeference.origin_y, 46.0, 1e-9);
  EXPECT_NEAR(file.map.spacing_z_m, 92.6180, 0.001);
  EXPECT_NEAR(file.map.spacing_x_m, 65.1317, 0.001);
}

// Fails if the grid's centre registration or its nodata value is lost.
TEST_F(ReadHeightMap, AsciiGrid) {
  std::ofstream(path("grid.asc")) << "ncols 3\nnrows 2\nxllcenter 1000\nyllcenter 5000\ncellsize 25\n"
                                     "NODATA_value -9999\n100 107 114\n153 -9999 167\n";
  const HeightMapFile file = read_height_map(path("grid.asc"));
  EXPECT_EQ(file.map.spacing_x_m, 25.0);
  EXPECT_EQ(file.map.georeference.origin_x, 1000.0);
  EXPECT_EQ(file.map.georeference.origin_y, 5025.0);
  EXPECT_EQ(file.source.void_posts, 1u);
  EXPECT_EQ(file.map.is_void[4], 1);
  EXPECT_EQ(file.map.heights_m[5], 167.0f);
}

// Fails if samples of 16 bits are cut to 8, or the spacing that the caller states is not used.
TEST_F(ReadHeightMap, SixteenBitPng) {
  Raster raster = raster_of(6, 4, [](int column, int row) { return 10 * height_of(column, row); });
  raster.type = "UInt16";
  write_raster(path("heights.png"), "PNG", raster);
  HeightMapOptions options;
  options.vertical_scale = 0.1;
  options.spacing_x_m = options.spacing_z_m = 75.0;
  const HeightMapFile file = read_height_map(path("heights.png"), options);
  ASSERT_EQ(file.map.columns, 6);
  for (std::size_t i = 0; i < file.map.heights_m.size(); ++i) {
    EXPECT_FLOAT_EQ(file.map.heights_m[i],
                    static_cast<float>(height_of(static_cast<int>(i % 6), static_cast<int>(i / 6))));
  }
  EXPECT_EQ(file.map.spacing_z_m, 75.0);
  EXPECT_EQ(file.source.spacing_source, SpacingSource::options);
  EXPECT_EQ(read_height_map(path("heights.png")).source.spacing_source, SpacingSource::assumed);
  options.spacing_x_m = options.spacing_z_m = 1e-30;
  EXPECT_THROW(read_height_map(path("heights.png"), options), Error);
}

// Fails if a packing's base, step or byte order is wrong, or black is taken for a height. By the published
// formulas (1, 134, 160) is -10000 + 0.1 * 100000 = 0 m in Mapbox's, (130, 0, 128) is 512.5 m in Terrarium's.
TEST_F(ReadHeightMap, HeightsPackedIntoColours) {
  Raster raster = raster_of(2, 2, [](int, int) { return 0.0; });
  raster.type = "Byte";
  raster.bands = {{1, 130, 0, 1}, {134, 0, 0, 134}, {160, 128, 0, 161}};
  write_raster(path("packed.png"), "PNG", raster);
  HeightMapOptions options;
  options.encoding = HeightEncoding::mapbox;
  const HeightMapFile mapbox = read_height_map(path("packed.png"), options);
  EXPECT_FLOAT_EQ(mapbox.map.heights_m[0], 0.0f);
  EXPECT_NEAR(mapbox.map.heights_m[3], 0.1f, 1e-6f);
  EXPECT_EQ(mapbox.source.void_posts, 1u);
  EXPECT_EQ(mapbox.map.is_void[2], 1);
  options.encoding = HeightEncoding::terrarium;
  EXPECT_EQ(read_height_map(path("packed.png"), options).map.heights_m[1], 512.5f);
}

// Fails if another channel than that of heights is read.
TEST_F(ReadHeightMap, Exr) {
  std::vector<float> heights, others(12, 3.0f);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) heights.push_back(static_cast<float>(height_of(column, row)));
  }
  write_exr(path("heights.exr"), {4, 3, {{"A", others}, {"Y", heights}}, {}}, PixelType::float_32,
            ExrCompression::zip);
  expect_heights(read_height_map(path("heights.exr")).map, 4, 3);
  HeightMapOptions options;
  options.exr_channel = "A";
  EXPECT_EQ(read_height_map(path("heights.exr"), options).map.heights_m[5], 3.0f);
}

// Fails if byte order, sign or type of samples without a header is mistaken. 0x8001 is 32769 unsigned, -32767
// signed and 0x0180 = 384 the other way round.
TEST_F(ReadHeightMap, FilesWithoutHeader) {
  std::ofstream(path("a.r16"), std::ios::binary)
      << std::string("\x01\x80\x02\x00\x03\x00\x04\x00\x05\x00\x06\x00", 12);
  HeightMapOptions options;
  options.raw_columns = 3;
  options.raw_rows = 2;
  const HeightMap unsigned_map = read_height_map(path("a.r16"), options).map;
  EXPECT_EQ(unsigned_map.heights_m[0], 32769.0f);
  EXPECT_EQ(unsigned_map.heights_m[unsigned_map.index(1, 1)], 5.0f);
  options.raw_type = RawType::signed_16;
  EXPECT_EQ(read_height_map(path("a.r16"), options).map.heights_m[0], -32767.0f);
  options.raw_type = RawType::unsigned_16;
  options.raw_byte_order = ByteOrder::big_endian;
  EXPECT_EQ(read_height_map(path("a.r16"), options).map.heights_m[0], 384.0f);
  // 1.5f is 0x3fc00000.
  std::string floats;
  for (int i = 0; i < 4; ++i) floats += std::string("\x00\x00\xc0\x3f", 4);
  std::ofstream(path("a.r32"), std::ios::binary) << floats;
  options = {};
  options.raw_columns = options.raw_rows = 2;
  EXPECT_EQ(read_height_map(path("a.r32"), options).map.heights_m[3], 1.5f);
}

// Fails if a nodata value stated by the caller, NaN as the file's own, or a constant for voids is ignored.
TEST_F(ReadHeightMap, VoidsOfTheFileAndOfTheCaller) {
  Raster raster = in_metres(4, 3);
  raster.nodata = nan;
  raster.bands[0][5] = nan;
  raster.bands[0][6] = -500.0;
  write_raster(path("voids.tif"), "GTiff", raster);
  HeightMapOptions options;
  EXPECT_EQ(read_height_map(path("voids.tif")).source.void_posts, 1u);
  options.nodata = -500.0;
  options.void_height_m = 12.0;
  const HeightMapFile file = read_height_map(path("voids.tif"), options);
  EXPECT_EQ(file.source.void_posts, 2u);
  EXPECT_EQ(file.source.void_area_m2, 2 * 20.0 * 30.0);
  EXPECT_EQ(file.map.heights_m[5], 12.0f);
  EXPECT_EQ(file.map.heights_m[6], 12.0f);
  EXPECT_EQ(file.source.lowest_m, 100.0f);
}

// Fails if resampling moves the ground: the height is a plane in degrees, of which the result is asked at the
// centre, where a shift by half a sample would show as 5 m; and if the result is not square and in metres.
TEST_F(ReadHeightMap, DegreesAreResampledToMetres) {
  constexpr double step_deg = 1.0 / 1200.0;
  Raster raster =
      raster_of(101, 101, [](int column, int row) { return 1000.0 + 10.0 * column + 10.0 * row; });
  raster.geotransform = {-70.5, step_deg, 0.0, -32.5, 0.0, -step_deg};
  raster.coordinate_system = "EPSG:4326";
  write_raster(path("degrees.tif"), "GTiff", raster);
  HeightMapOptions options;
  options.reproject_to = "utm";
  const HeightMapFile file = read_height_map(path("degrees.tif"), options);
  EXPECT_EQ(file.source.spacing_source, SpacingSource::reprojected);
  EXPECT_THAT(file.source.coordinate_system, ::testing::HasSubstr("UTM zone 19S"));
  EXPECT_DOUBLE_EQ(file.map.spacing_x_m, file.map.spacing_z_m);
  // Between 77.9 m (east) and 92.4 m (north): the diagonal keeps its number of samples.
  EXPECT_GT(file.map.spacing_x_m, 77.0);
  EXPECT_LT(file.map.spacing_x_m, 93.0);
  ASSERT_TRUE(file.source.centre_latitude_deg);
  const double column = (*file.source.centre_longitude_deg + 70.5) / step_deg - 0.5;
  const double row = (-32.5 - *file.source.centre_latitude_deg) / step_deg - 0.5;
  const HeightMap& map = file.map;
  // The centre lies at a post, or half way between two or four.
  const int c = (map.columns - 1) / 2, r = (map.rows - 1) / 2, c1 = map.columns / 2, r1 = map.rows / 2;
  const double centre_m = 0.25 * (map.heights_m[map.index(c, r)] + map.heights_m[map.index(c1, r)] +
                                  map.heights_m[map.index(c, r1)] + map.heights_m[map.index(c1, r1)]);
  // Bound: gdalwarp's approximate transformer may miss by 0.125 of a sample along each axis, 1.25 m each.
  EXPECT_NEAR(centre_m, 1000.0 + 10.0 * column + 10.0 * row, 2.5);
}

}  // namespace
}  // namespace offing
