// Shares of the sky's light that posts get, against closed forms and against horizons found by brute force.
#include "host/terrain/shading/open_sky.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/io/temporary_folder.h"
#include "tests/ocl/log_capture.h"
#include "tests/ocl/scoped_environment.h"
#include "tests/terrain/example_maps.h"

namespace offing {
namespace {

using std::numbers::pi;

test::HeightMap made(const terrain::PostGrid& grid, const std::function<double(int, int)>& height_m) {
  test::HeightMap map{"made", grid, {}};
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      map.heights_m.push_back(static_cast<float>(height_m(column, row)));
    }
  }
  return map;
}

/// Shares of the light, [rows][columns] of posts.
std::vector<double> shares_of(const test::HeightMap& map) {
  const ocl::Device device = ocl::Device::open();
  const terrain::HeightField field(device, map.grid, map.heights_m);
  std::vector<double> shares;
  for (const std::uint8_t share : terrain::OpenSky(device, field).shares().read()) {
    shares.push_back(share / 255.0);
  }
  return shares;
}

/// Files of shares in a folder.
std::vector<std::filesystem::path> kept_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> kept;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() == ".sky") kept.push_back(file.path());
  }
  return kept;
}

ino_t inode_of(const std::filesystem::path& file) {
  struct stat found {};
  EXPECT_EQ(stat(file.c_str(), &found), 0);
  return found.st_ino;
}

// Shares of a large map are kept for the next program. Fails if they are not, if they are made again, if
// those of another map or spacing are taken for them, if a damaged file is taken or not replaced, or if an
// empty OFFING_CACHE_DIR keeps any.
TEST(OpenSkyTest, SharesAreKept) {
  TemporaryFolder folder;
  const test::ScopedEnvironment cache("OFFING_CACHE_DIR", folder.path().string());
  const auto hills = [](double spacing_m, double height_m) {
    return made(
        {.columns = 301, .rows = 257, .spacing_x_m = spacing_m, .spacing_z_m = spacing_m},
        [&](int column, int row) { return height_m * std::sin(0.2 * column) * std::cos(0.15 * row); });
  };
  const std::vector<double> shares = shares_of(hills(10.0, 40.0));
  ASSERT_EQ(kept_in(folder.path()).size(), 1u);
  const std::filesystem::path file = kept_in(folder.path()).front();
  const ino_t inode = inode_of(file);
  const auto long_ago = std::filesystem::file_time_type::clock::now() - std::chrono::hours(50);
  std::filesystem::last_write_time(file, long_ago);
  EXPECT_EQ(shares_of(hills(10.0, 40.0)), shares);
  // A read marks the file as used; a write replaces it by another one.
  EXPECT_GT(std::filesystem::last_write_time(file), long_ago);
  EXPECT_EQ(inode_of(file), inode);
  EXPECT_NE(shares_of(hills(10.0, 50.0)), shares);
  EXPECT_NE(shares_of(hills(20.0, 40.0)), shares);
  EXPECT_EQ(kept_in(folder.path()).size(), 3u);
  {
    std::fstream damaged(file, std::ios::binary | std::ios::in | std::ios::out);
    damaged.seekp(1000);
    damaged.write("damage", 6);
  }
  const test::LogCapture log;
  EXPECT_EQ(shares_of(hills(10.0, 40.0)), shares);
  EXPECT_THAT(log.text(), testing::HasSubstr("is damaged: rebuilding it"));
  EXPECT_EQ(shares_of(hills(10.0, 40.0)), shares);
  EXPECT_EQ(log.lines(), 1u) << log.text();
  const test::ScopedEnvironment off("OFFING_CACHE_DIR", "");
  EXPECT_EQ(shares_of(hills(10.0, 60.0)).size(), shares.size());
  EXPECT_EQ(kept_in(folder.path()).size(), 3u);
}

// Nothing stands in front of flat ground, nor of a slope, whose own plane is no obstacle. Fails if the ground
// hides the sky from itself.
TEST(OpenSkyTest, FlatGroundAndSlopesSeeAllOfTheirSky) {
  const terrain::PostGrid grid{.columns = 67, .rows = 41, .spacing_x_m = 3.0, .spacing_z_m = 5.0};
  for (const double share : shares_of(made(grid, [](int, int) { return 7.0; }))) EXPECT_EQ(share, 1.0);
  for (const double share :
       shares_of(made(grid, [](int column, int row) { return 2.0 * column - 3.0 * row; }))) {
    EXPECT_NEAR(share, 1.0, 1.01 / 255.0);
  }
}

// The floor of an endless valley whose sides rise at an angle a gets cos a of the light (the sky between two
// planes), on any direction of the valley. Eight directions are right to 2 ((1 - cos a) / (1 + cos a))^4,
// 0.002 at 45 degrees and 0.02 at 60; the byte to
// 0.002 and the horizons' 0.01 of rise to as much. Fails if a horizon is missed or the light is not
// weighed by the cosine.
TEST(OpenSkyTest, TheFloorOfAValleySeesTheCosineOfItsSides) {
  for (const double angle_rad : {pi / 12.0, pi / 6.0, pi / 4.0, pi / 3.0}) {
    const terrain::PostGrid grid{.columns = 129, .rows = 65, .spacing_x_m = 10.0, .spacing_z_m = 10.0};
    const std::vector<double> shares = shares_of(
        made(grid, [&](int column, int) { return 10.0 * std::abs(column - 64) * std::tan(angle_rad); }));
    const double cosine = std::cos(angle_rad);
    const double gate = 2.0 * std::pow((1.0 - cosine) / (1.0 + cosine), 4.0) + 0.012;
    for (int row = 4; row < 61; ++row) {
      ASSERT_NEAR(shares[static_cast<std::size_t>(129 * row + 64)], cosine, gate) << angle_rad << ", " << row;
    }
  }
}

// The middle of a round pit as deep as its radius sees the sky above its rim: cos^2 of the rim's elevation,
// half of the light, from any direction alike. The rim is up to 1 of 40 cells farther, 0.02 of its slope and
// 0.02 of the light. Fails if directions are left out or doubled.
TEST(OpenSkyTest, TheMiddleOfAPitSeesTheSkyAboveItsRim) {
  const terrain::PostGrid grid{.columns = 101, .rows = 101, .spacing_x_m = 10.0, .spacing_z_m = 10.0};
  const std::vector<double> shares = shares_of(made(
      grid, [&](int column, int row) { return std::hypot(column - 50, row - 50) < 40.0 ? 0.0 : 400.0; }));
  EXPECT_NEAR(shares[101 * 50 + 50], 0.5, 0.02);
}

/// The same by steps of a tenth of a cell over bilinear ground in 256 directions.
double share_by_steps(const test::HeightMap& map, int column, int row) {
  const auto& grid = map.grid;
  const auto height_m = [&](double x, double z) {
    const int left = std::min(static_cast<int>(x), grid.columns - 2),
              top = std::min(static_cast<int>(z), grid.rows - 2);
    const double u = x - left, v = z - top;
    return (1.0 - v) * ((1.0 - u) * map.at(left, top) + u * map.at(left + 1, top)) +
           v * ((1.0 - u) * map.at(left, top + 1) + u * map.at(left + 1, top + 1));
  };
  const double slope_x = (map.at(column + 1, row) - map.at(column - 1, row)) / (2.0 * grid.spacing_x_m);
  const double slope_z = (map.at(column, row + 1) - map.at(column, row - 1)) / (2.0 * grid.spacing_z_m);
  double sum = 0.0, whole = 0.0;
  constexpr int directions = 256;
  for (int i = 0; i < directions; ++i) {
    const double azimuth_rad = 2.0 * pi * (i + 0.5) / directions;
    const double east = std::cos(azimuth_rad), south = std::sin(azimuth_rad);
    const double slope = slope_x * east + slope_z * south;
    double horizon = std::max(0.0, slope);
    const double step_m = 0.1 * std::min(grid.spacing_x_m, grid.spacing_z_m);
    for (double way_m = step_m;; way_m += step_m) {
      const double x = column + way_m * east / grid.spacing_x_m, z = row + way_m * south / grid.spacing_z_m;
      if (x < 0.0 || z < 0.0 || x > grid.columns - 1 || z > grid.rows - 1) break;
      horizon = std::max(horizon, (height_m(x, z) - map.at(column, row)) / way_m);
    }
    // From the horizon to the zenith in a hundred steps.
    for (double* const total : {&sum, &whole}) {
      const double from_rad = std::atan(total == &sum ? horizon : std::max(0.0, slope));
      const double part_rad = (0.5 * pi - from_rad) / 100.0;
      for (int part = 0; part < 100; ++part) {
        const double angle_rad = from_rad + (part + 0.5) * part_rad;
        *total += part_rad * std::cos(angle_rad) * (std::sin(angle_rad) - slope * std::cos(angle_rad));
      }
    }
  }
  return sum / whole;
}

// On hills: the mean over posts is that of the brute force to 0.005, each post to what fewer directions miss
// of smooth hills: 0.02. Fails if nodes are passed over whose ground is on the horizon.
TEST(OpenSkyTest, FindsTheHorizonsOfHills) {
  const test::HeightMap map =
      test::valleys({.columns = 180, .rows = 150, .spacing_x_m = 8.0, .spacing_z_m = 10.0});
  const std::vector<double> shares = shares_of(map);
  double difference = 0.0;
  int count = 0;
  for (int row = 7; row < 150 - 7; row += 13) {
    for (int column = 5; column < 180 - 5; column += 11) {
      const double expected = share_by_steps(map, column, row);
      const double found = shares[static_cast<std::size_t>(180 * row + column)];
      EXPECT_NEAR(found, expected, 0.02) << column << ", " << row;
      difference += found - expected;
      ++count;
    }
  }
  EXPECT_NEAR(difference / count, 0.0, 0.005);
}

// Maps of more than 1.1 million posts get a share at every second: the floor of a trench at the right place
// tells that both sides agree where that is.
TEST(OpenSkyTest, LargeMapsHaveASharePerSecondPost) {
  const terrain::PostGrid grid{.columns = 2100, .rows = 601, .spacing_x_m = 10.0, .spacing_z_m = 10.0};
  const test::HeightMap map =
      made(grid, [](int column, int) { return 10.0 * std::min(std::abs(column - 1024), 32); });
  const ocl::Device device = ocl::Device::open();
  const terrain::HeightField field(device, map.grid, map.heights_m);
  const terrain::OpenSky sky(device, field);
  TerrainLook look{};
  sky.describe(look);
  EXPECT_EQ(look.open_sky_stride, 2);
  EXPECT_EQ(look.open_sky_columns, 1051);
  EXPECT_EQ(look.open_sky_rows, 301);
  const std::vector<std::uint8_t> shares = sky.shares().read();
  EXPECT_NEAR(shares[1051 * 200 + 512] / 255.0, std::cos(pi / 4.0), 0.006);
  EXPECT_NEAR(shares[1051 * 200 + 508], shares[1051 * 200 + 516], 1.0);
}

}  // namespace
}  // namespace offing
