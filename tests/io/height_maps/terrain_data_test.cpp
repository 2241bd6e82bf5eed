#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "host/io/height_maps/read_height_map.h"

namespace offing {
namespace {

/// What the description of a data file says.
struct Expected {
  std::string name;
  HeightMapOptions options;
  int columns, rows;
  double spacing_x_m, spacing_z_m;
  float lowest_m, highest_m, rounding_m;  // of the range: half a unit of its last digit where it is rounded
  std::size_t void_posts;
};

HeightMapOptions with_spacing(double spacing_m) {
  HeightMapOptions options;
  options.spacing_x_m = options.spacing_z_m = spacing_m;
  return options;
}

/// Real files, each in a test of its own. Fails if size, spacing, range or the number of voids differs from
/// the file's description. Spacing: descriptions of degrees give three digits, hence 0.1 m.
void check(const Expected& expected) {
  const char* const folder = std::getenv("OFFING_TEST_DATA");
  if (folder == nullptr) GTEST_SKIP() << "OFFING_TEST_DATA is not set: no real height maps";
  const HeightMapFile file =
      read_height_map(std::filesystem::path(folder) / "terrain" / expected.name, expected.options);
  EXPECT_EQ(file.map.columns, expected.columns);
  EXPECT_EQ(file.map.rows, expected.rows);
  EXPECT_NEAR(file.map.spacing_x_m, expected.spacing_x_m, 0.1);
  EXPECT_NEAR(file.map.spacing_z_m, expected.spacing_z_m, 0.1);
  EXPECT_NEAR(file.source.lowest_m, expected.lowest_m, expected.rounding_m);
  EXPECT_NEAR(file.source.highest_m, expected.highest_m, expected.rounding_m);
  EXPECT_EQ(file.source.void_posts, expected.void_posts);
  for (const float height_m : file.map.heights_m) {
    ASSERT_GE(height_m, expected.lowest_m - expected.rounding_m);
    ASSERT_LE(height_m, expected.highest_m + expected.rounding_m);
  }
}

// The quadrangle is not aligned with UTM: wedges along its sides hold -32767, 4,151 of them by gdal_translate
// and a count. Its description leaves them out.
TEST(TerrainData, UsgsDem) {
  check({"SainteHelens.dem", {}, 327, 468, 30.0, 30.0, 682.0f, 2543.0f, 0.0f, 4151});
}

// 3 seconds at 32.5 S on WGS 84: 78.314 m and 92.413 m.
TEST(TerrainData, GeoTiffOfDegrees) {
  check({"S33W071.tif", {}, 1201, 1201, 78.3, 92.4, 250.0f, 6929.0f, 0.0f, 0});
}

// 3 seconds at 42.5 N on WGS 84: 68.499 m and 92.569 m. Untrusted too: the map lies in its archive.
TEST(TerrainData, HgtOfThreeSeconds) {
  HeightMapOptions options;
  options.trust.trust = Trust::untrusted;
  check({"N42E001.hgt.zip", options, 1201, 1201, 68.5, 92.6, 349.0f, 3100.0f, 0.0f, 7652});
}

TEST(TerrainData, HgtOfOneSecond) {
  check({"N48W125.hgt.zip", {}, 3601, 3601, 20.6, 30.9, -13.0f, 1095.0f, 0.0f, 6483876});
}

TEST(TerrainData, SixteenBitPng) {
  HeightMapOptions options = with_spacing(75.0);
  options.vertical_scale = 0.1;
  check({"andes_1025_75m_u16dm.png", options, 1025, 1025, 75.0, 75.0, 364.0f, 5204.0f, 0.5f, 0});
}

TEST(TerrainData, WithoutHeader) {
  HeightMapOptions options = with_spacing(75.0);
  options.vertical_scale = 0.1;
  options.raw_columns = options.raw_rows = 1025;
  check({"andes_1025_75m.r16", options, 1025, 1025, 75.0, 75.0, 364.0f, 5204.0f, 0.5f, 0});
}

TEST(TerrainData, PackedIntoColours) {
  HeightMapOptions options = with_spacing(75.0);
  options.encoding = HeightEncoding::mapbox;
  check({"andes_256_terrainrgb.png", options, 256, 256, 75.0, 75.0, 1131.2f, 3601.0f, 0.05f, 0});
  options.encoding = HeightEncoding::terrarium;
  check({"andes_256_terrarium.png", options, 256, 256, 75.0, 75.0, 1131.2f, 3601.0f, 0.05f, 0});
}

}  // namespace
}  // namespace offing
