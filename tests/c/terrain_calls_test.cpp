// Terrain of the C interface against the classes behind it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/utc_time.h"
#include "host/c/handles.h"
#include "host/c/offing.h"
#include "host/scene/prepare/maps/terrain_sun.h"
#include "host/terrain/analysis/horizons.h"
#include "host/terrain/analysis/line_of_sight.h"
#include "host/terrain/analysis/sky_view.h"
#include "host/terrain/analysis/viewshed.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/lakes/lake.h"
#include "tests/c/sized.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

using testing::HasSubstr;

/// Bumpy ground of 33 x 21 posts, 10 m apart along x and 8 m along z, under a wall of 40 m along column 20.
class TerrainCallsTest : public testing::Test {
 protected:
  static constexpr int columns = 33, rows = 21;

  void SetUp() override {
    map_.columns = columns;
    map_.rows = rows;
    map_.spacing_x_m = 10.0;
    map_.spacing_z_m = 8.0;
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const double height_m = column == 20 ? 40.0 : 3.0 * std::sin(0.7 * column) * std::cos(0.4 * row);
        map_.heights_m.push_back(static_cast<float>(height_m));
      }
    }
    ASSERT_EQ(offing_open_device(nullptr, &device_), OFFING_OK) << offing_last_error();
    ASSERT_EQ(offing_make_terrain(device_, map_.heights_m.data(), columns, rows, 10.0, 8.0, &terrain_),
              OFFING_OK)
        << offing_last_error();
  }
  void TearDown() override {
    offing_free_terrain(terrain_);
    offing_free_terrain(opened_);
    offing_close_device(device_);
  }

  OffingTerrainInfo info(OffingTerrain* terrain) {
    auto found = sized<OffingTerrainInfo>();
    EXPECT_EQ(offing_get_terrain_info(terrain, &found), OFFING_OK) << offing_last_error();
    return found;
  }
  terrain::HeightField field() { return {ocl::Device::open(), terrain::post_grid(map_), map_.heights_m}; }

  HeightMap map_;
  OffingDevice* device_ = nullptr;
  OffingTerrain* terrain_ = nullptr;
  OffingTerrain* opened_ = nullptr;
};

// Fails if an option does not reach the reader, a post is at another place, or what the file says is lost.
TEST_F(TerrainCallsTest, OpensAFile) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "map.asc").string();
  std::ofstream(file) << "ncols 3\nnrows 2\nxllcenter 500000\nyllcenter 5200000\ncellsize 25\n"
                         "NODATA_value -9999\n1 2 3\n4 -9999 -7\n";
  const double nodata = -7.0, void_height_m = 8.0;
  auto options = sized<OffingTerrainOptions>();
  options.vertical_scale = 2.0;
  options.offset_m = 100.0;
  options.nodata = &nodata;
  options.void_height_m = &void_height_m;
  options.spacing_z_m = 30.0;
  ASSERT_EQ(offing_open_terrain(device_, file.c_str(), &options, &opened_), OFFING_OK) << offing_last_error();
  const OffingTerrainInfo found = info(opened_);
  EXPECT_EQ(found.columns, 3);
  EXPECT_EQ(found.rows, 2);
  EXPECT_EQ(found.spacing_x_m, 25.0);
  EXPECT_EQ(found.spacing_z_m, 30.0);
  EXPECT_EQ(found.lowest_m, 8.0);
  EXPECT_EQ(found.highest_m, 108.0);
  EXPECT_EQ(found.void_posts, 2u);
  EXPECT_EQ(found.origin_x, 500000.0);
  EXPECT_EQ(found.origin_y, 5200025.0);
  EXPECT_EQ(found.step_x, 25.0);
  EXPECT_EQ(found.step_y, -25.0);
  EXPECT_STREQ(found.coordinate_system, "");
  EXPECT_THAT(found.format, HasSubstr("ASCII"));
  EXPECT_TRUE(std::isnan(found.centre_latitude_deg));
  std::array<float, 6> heights_m{};
  std::array<std::uint8_t, 6> is_void{};
  ASSERT_EQ(offing_read_terrain(opened_, heights_m.data(), is_void.data(), 6), OFFING_OK);
  EXPECT_THAT(heights_m, testing::ElementsAre(102.0f, 104.0f, 106.0f, 108.0f, 8.0f, 8.0f));
  EXPECT_THAT(is_void, testing::ElementsAre(0, 0, 0, 0, 1, 1));
}

// Fails if the array is read in another order, or what is not known of it is made up.
TEST_F(TerrainCallsTest, TakesAnArray) {
  const OffingTerrainInfo found = info(terrain_);
  EXPECT_EQ(found.columns, columns);
  EXPECT_EQ(found.spacing_z_m, 8.0);
  EXPECT_EQ(found.highest_m, 40.0);
  EXPECT_TRUE(std::isnan(found.origin_x));
  EXPECT_STREQ(found.coordinate_system_wkt, "");
  EXPECT_EQ(found.is_spacing_assumed, 0);
  std::vector<float> heights_m(map_.heights_m.size());
  ASSERT_EQ(offing_read_terrain(terrain_, heights_m.data(), nullptr, heights_m.size()), OFFING_OK);
  EXPECT_EQ(heights_m, map_.heights_m);
}

// Fails if a height or a normal is of another point, or places beyond the map get one.
TEST_F(TerrainCallsTest, SamplesPoints) {
  const std::vector<double> points_m{13.0, 17.0, 320.0, 160.0, 320.5, 20.0, 101.0, 33.0};
  std::array<double, 4> height_m{};
  std::array<double, 12> normal{}, smooth{};
  std::array<std::uint8_t, 4> is_measured{};
  const OffingTerrainSamples samples{sizeof samples, height_m.data(), normal.data(), is_measured.data()};
  ASSERT_EQ(offing_sample_terrain(terrain_, nullptr, points_m.data(), 4, &samples), OFFING_OK);
  auto query = sized<OffingTerrainQuery>();
  query.has_smooth_normals = 1;
  const OffingTerrainSamples normals{sizeof normals, nullptr, smooth.data(), nullptr};
  ASSERT_EQ(offing_sample_terrain(terrain_, &query, points_m.data(), 4, &normals), OFFING_OK);
  for (const std::size_t i : {0u, 1u, 3u}) {
    const auto due = terrain::terrain_at(map_, points_m[2 * i], points_m[2 * i + 1]);
    EXPECT_EQ(height_m[i], due->height_m);
    EXPECT_EQ(normal[3 * i], due->normal.x);
    EXPECT_EQ(normal[3 * i + 2], due->normal.z);
    EXPECT_EQ(smooth[3 * i], terrain::smooth_normal_at(map_, points_m[2 * i], points_m[2 * i + 1])->x);
    EXPECT_EQ(is_measured[i], 1);
  }
  EXPECT_TRUE(std::isnan(height_m[2]));
  EXPECT_TRUE(std::isnan(normal[7]));
  EXPECT_TRUE(std::isnan(smooth[7]));
  EXPECT_EQ(is_measured[2], 0);
}

// Fails if a ray, its limit or its answer is another one's, or the curve of the ground is left out.
TEST_F(TerrainCallsTest, CastsRays) {
  const std::vector<double> origins_m{50.0, 90.0, 50.0, 50.0, 90.0,  50.0,
                                      10.0, 20.0, 80.0, 10.0, -50.0, 80.0};
  const std::vector<double> directions{0.6, -0.8, 0.0, 0.6, -0.8, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0};
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> limits_m{infinity, 50.0, 1e9, infinity};
  std::array<double, 4> distance_m{};
  std::array<double, 12> point_m{};
  std::array<float, 12> normal{};
  std::array<std::uint8_t, 4> kind{};
  const OffingHits hits{sizeof hits, distance_m.data(), point_m.data(), normal.data(), kind.data()};
  auto query = sized<OffingTerrainQuery>();
  query.earth_radius_m = 5000.0;
  query.refraction = 0.13;
  terrain::HeightField reference = field();
  for (const OffingTerrainQuery* asked : {static_cast<OffingTerrainQuery*>(nullptr), &query}) {
    ASSERT_EQ(
        offing_cast_rays(terrain_, asked, origins_m.data(), directions.data(), limits_m.data(), 4, &hits),
        OFFING_OK)
        << offing_last_error();
    const terrain::EarthCurve curve =
        asked == nullptr ? terrain::EarthCurve{} : terrain::EarthCurve{5000.0, 0.13};
    for (std::size_t i = 0; i < 4; ++i) {
      const terrain::Ray ray{.origin_m = {origins_m[3 * i], origins_m[3 * i + 1], origins_m[3 * i + 2]},
                             .direction = {directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]},
                             .limit_m = limits_m[i]};
      const terrain::RayHit due = reference.cast(std::vector{ray}, curve).front();
      EXPECT_EQ(kind[i], due.kind);
      EXPECT_EQ(distance_m[i], due.distance_m);
      if (due.kind == TERRAIN_MISS) {
        EXPECT_TRUE(std::isnan(point_m[3 * i]));
        EXPECT_TRUE(std::isnan(normal[3 * i]));
        continue;
      }
      EXPECT_EQ(normal[3 * i], due.normal_x);
      EXPECT_EQ(normal[3 * i + 1], due.normal_y);
      // The map is as high there as the place that is told.
      if (due.kind != TERRAIN_SURFACE) continue;
      EXPECT_NEAR(terrain::terrain_at(map_, point_m[3 * i], point_m[3 * i + 2])->height_m, point_m[3 * i + 1],
                  0.02);
    }
  }
  EXPECT_EQ(kind[1], OFFING_HIT_NONE);
  EXPECT_EQ(kind[3], OFFING_HIT_INSIDE);
}

// Fails if a line's answer is another one's, or differs from that of `offing terrain los`.
TEST_F(TerrainCallsTest, TracesSightLines) {
  const std::vector<double> from_m{20.0, 80.0, 2.0, 20.0, 80.0, 60.0},
      to_m{300.0, 90.0, 2.0, 300.0, 90.0, 60.0};
  std::array<std::uint8_t, 2> is_visible{};
  std::array<double, 2> distance_m{}, hidden_at_m{};
  std::array<double, 6> hidden_by_m{};
  const OffingSightLines lines{sizeof lines, is_visible.data(), distance_m.data(), hidden_at_m.data(),
                               hidden_by_m.data()};
  ASSERT_EQ(offing_trace_sight_lines(terrain_, nullptr, from_m.data(), to_m.data(), 2, &lines), OFFING_OK)
      << offing_last_error();
  EXPECT_THAT(is_visible, testing::ElementsAre(0, 1));
  const terrain::LineOfSight due(terrain::posts_of(map_), {}, {"from", 20.0, 80.0, 2.0},
                                 {"to", 300.0, 90.0, 2.0});
  const terrain::RayHit hit = field().cast(std::vector{due.ray()}).front();
  EXPECT_EQ(distance_m[0], due.distance_m());
  EXPECT_EQ(hidden_at_m[0], due.hidden_at_m(hit));
  EXPECT_EQ(hidden_by_m[0], due.point_m(hidden_at_m[0]).x);
  EXPECT_TRUE(std::isnan(hidden_at_m[1]));
  EXPECT_TRUE(std::isnan(hidden_by_m[3]));
}

// Fails if the map of what is seen is another observer's.
TEST_F(TerrainCallsTest, ComputesViewsheds) {
  auto viewshed = sized<OffingViewshed>();
  viewshed.observer_x_m = 57.0;
  viewshed.observer_z_m = 83.0;
  viewshed.observer_height_m = 4.0;
  viewshed.target_height_m = 1.0;
  viewshed.earth_radius_m = 20000.0;
  std::vector<std::uint8_t> seen(map_.heights_m.size(), 7);
  ASSERT_EQ(offing_compute_viewshed(terrain_, &viewshed, seen.data(), seen.size()), OFFING_OK)
      << offing_last_error();
  const ocl::Device device = ocl::Device::open();
  const terrain::HeightField reference(device, terrain::post_grid(map_), map_.heights_m);
  ocl::Buffer<std::uint8_t> due(device, seen.size(), "seen");
  terrain::Viewshed(device).at(reference,
                               {.observer_x_m = 57.0,
                                .observer_z_m = 83.0,
                                .observer_height_m = 4.0,
                                .target_height_m = 1.0,
                                .curve = {.radius_m = 20000.0}},
                               due);
  EXPECT_EQ(seen, due.read());
  EXPECT_THAT(seen, testing::Contains(255));
  EXPECT_THAT(seen, testing::Contains(0));
}

// Fails if a lake is not that of the library, arrays of another size are taken, or faults are not told.
TEST_F(TerrainCallsTest, FillsLakes) {
  // The lowest post within the map.
  std::size_t lowest = 0;
  for (int row = 1; row + 1 < rows; ++row) {
    for (int column = 1; column + 1 < 20; ++column) {
      const std::size_t post = map_.index(column, row);
      if (lowest == 0 || map_.heights_m[post] < map_.heights_m[lowest]) lowest = post;
    }
  }
  const double x_m = 10.0 * static_cast<double>(lowest % columns),
               z_m = 8.0 * static_cast<double>(lowest / columns);
  auto lake = sized<OffingLake>();
  ASSERT_EQ(offing_fill_lake(terrain_, x_m, z_m, nullptr, &lake, nullptr, 0, nullptr, 0), OFFING_OK)
      << offing_last_error();
  const terrain::Lake expected = terrain::fill_lake(terrain::posts_of(map_), x_m, z_m, std::nullopt);
  EXPECT_EQ(lake.level_m, expected.level_m);
  EXPECT_EQ(lake.volume_m3, expected.volume_m3);
  ASSERT_GT(lake.outline_count, 4u);
  std::vector<float> depth_m(map_.heights_m.size());
  std::vector<double> outline_m(2 * lake.outline_count);
  const double level_m = lake.level_m - 0.5;
  EXPECT_NE(offing_fill_lake(terrain_, x_m, z_m, nullptr, nullptr, depth_m.data(), 3, nullptr, 0), OFFING_OK);
  ASSERT_EQ(offing_fill_lake(terrain_, x_m, z_m, nullptr, nullptr, depth_m.data(), depth_m.size(),
                             outline_m.data(), lake.outline_count),
            OFFING_OK)
      << offing_last_error();
  EXPECT_EQ(outline_m[0], terrain::outline_of(expected, terrain::posts_of(map_))[0][0].x);
  EXPECT_FLOAT_EQ(*std::max_element(depth_m.begin(), depth_m.end()),
                  static_cast<float>(expected.greatest_depth_m));
  ASSERT_EQ(offing_fill_lake(terrain_, x_m, z_m, &level_m, &lake, nullptr, 0, nullptr, 0), OFFING_OK);
  EXPECT_EQ(lake.level_m, level_m);
  const double too_high_m = 1e3;
  EXPECT_EQ(offing_fill_lake(terrain_, x_m, z_m, &too_high_m, &lake, nullptr, 0, nullptr, 0),
            OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("spill level"));
}

// Fails if a lake is flooded again to fill the arrays that its first answer gave the size of. Before: it was.
TEST_F(TerrainCallsTest, FloodsALakeOnce) {
  int looks = 0;
  const auto height_m = terrain_->posts.height_m;
  terrain_->posts.height_m = [&](int column, int row) {
    ++looks;
    return height_m(column, row);
  };
  auto lake = sized<OffingLake>();
  const auto fill = [&](double x_m, double* outline_m, std::uint64_t count) {
    looks = 0;
    EXPECT_EQ(offing_fill_lake(terrain_, x_m, 64.0, nullptr, &lake, nullptr, 0, outline_m, count), OFFING_OK)
        << offing_last_error();
    return looks;
  };
  EXPECT_GT(fill(110.0, nullptr, 0), 0);
  std::vector<double> outline_m(2 * lake.outline_count);
  EXPECT_EQ(fill(110.0, outline_m.data(), lake.outline_count), 0);
  EXPECT_GT(fill(111.0, nullptr, 0), 0);
}

// Fails if factors, horizons or hours are not those of the library, zeros are not the usual settings, or a
// terrain without a place in the world gets a sun.
TEST_F(TerrainCallsTest, ComputesSkyAndSun) {
  const std::size_t posts = map_.heights_m.size();
  auto sky = sized<OffingSkyView>();
  sky.azimuths = 12;
  std::vector<float> factors(posts), rises(12 * posts), one(posts);
  ASSERT_EQ(offing_compute_sky_view(terrain_, &sky, factors.data(), rises.data(), posts), OFFING_OK)
      << offing_last_error();
  const ocl::Device device = ocl::Device::open();
  const terrain::HeightField reference(device, terrain::post_grid(map_), map_.heights_m);
  terrain::Horizons horizons(device, reference, 12);
  horizons.at({0, rows});
  horizons.read(3, one);
  EXPECT_TRUE(std::equal(one.begin(), one.end(), rises.begin() + static_cast<std::ptrdiff_t>(3 * posts)));
  terrain::SkyView(device, horizons).read({0, rows}, one);
  EXPECT_EQ(factors, one);
  EXPECT_EQ(offing_compute_sky_view(terrain_, nullptr, factors.data(), nullptr, posts), OFFING_OK);

  auto when = sized<OffingSunHours>();
  when.from_s = unix_seconds({.year = 2026, .month = 6, .day = 21, .hour = 0});
  when.to_s = when.from_s + 86400;
  std::vector<float> hours(posts), energy(posts), other(posts);
  EXPECT_EQ(offing_compute_sun_hours(terrain_, &when, hours.data(), energy.data(), posts), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("terrain"));
  when.has_place = 1;
  when.latitude_rad = 0.8;
  ASSERT_EQ(offing_compute_sun_hours(terrain_, &when, hours.data(), energy.data(), posts), OFFING_OK)
      << offing_last_error();
  scene::TerrainSun sun(device, reference, map_, frame_of("map", map_), sky::GeoPosition{0.8, 0.0},
                        {.from_s = when.from_s, .to_s = when.to_s});
  sun.read({0, rows}, one, other);
  EXPECT_EQ(hours, one);
  EXPECT_EQ(energy, other);
  EXPECT_THAT(hours, testing::Contains(testing::Gt(15.0f)));
  when.step_s = -5;
  EXPECT_EQ(offing_compute_sun_hours(terrain_, &when, hours.data(), energy.data(), posts), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("step_s"));
  EXPECT_EQ(offing_compute_sun_hours(terrain_, &when, hours.data(), energy.data(), posts - 1),
            OFFING_BAD_INPUT);
}

// Fails if the angles of a viewshed do nothing, or zeros are no whole turn: north-east of the observer are
// the columns and rows that grow east and north.
TEST_F(TerrainCallsTest, LimitsViewsheds) {
  auto viewshed = sized<OffingViewshed>();
  viewshed.observer_x_m = 57.0;
  viewshed.observer_z_m = 83.0;
  viewshed.observer_height_m = 4.0;
  std::vector<std::uint8_t> all(map_.heights_m.size()), seen(map_.heights_m.size());
  ASSERT_EQ(offing_compute_viewshed(terrain_, &viewshed, all.data(), all.size()), OFFING_OK);
  viewshed.azimuth_to_rad = 0.5 * std::numbers::pi;
  ASSERT_EQ(offing_compute_viewshed(terrain_, &viewshed, seen.data(), seen.size()), OFFING_OK)
      << offing_last_error();
  for (int row = 0; row < map_.rows; ++row) {
    for (int column = 0; column < map_.columns; ++column) {
      const bool is_north_east = column * map_.spacing_x_m >= 57.0 && row * map_.spacing_z_m <= 83.0;
      EXPECT_EQ(seen[map_.index(column, row)], is_north_east ? all[map_.index(column, row)] : 0);
    }
  }
  viewshed.lowest_rad = 0.3;
  viewshed.highest_rad = 0.2;
  EXPECT_EQ(offing_compute_viewshed(terrain_, &viewshed, seen.data(), seen.size()), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("highest"));
}

// Fails if counts are not sums of what each observer alone sees, values of one observer are another's, or the
// best two are not those of all choices.
TEST_F(TerrainCallsTest, CountsViewsheds) {
  constexpr std::size_t observer_count = 3;
  const std::array<double, 2 * observer_count> points_m{57.0, 83.0, 20.0, 10.0, 300.0, 90.0};
  const std::array<double, observer_count> heights_m{4.0, 1.0, 12.0}, radii_m{0.0, 60.0, 150.0};
  const std::array<double, 2 * observer_count> azimuths_rad{0.0, 0.0, 1.0, 4.0, 0.0, 2.0};
  auto shared = sized<OffingViewshed>();
  shared.target_height_m = 0.5;
  shared.earth_radius_m = 20000.0;
  auto observers = sized<OffingObservers>();
  observers.count = observer_count;
  observers.points_m = points_m.data();
  observers.observer_height_m = heights_m.data();
  observers.radius_m = radii_m.data();
  observers.azimuth_rad = azimuths_rad.data();

  const std::size_t posts = map_.heights_m.size();
  std::vector<std::vector<std::uint8_t>> each(observer_count, std::vector<std::uint8_t>(posts));
  for (std::size_t i = 0; i < observer_count; ++i) {
    OffingViewshed alone = shared;
    alone.observer_x_m = points_m[2 * i];
    alone.observer_z_m = points_m[2 * i + 1];
    alone.observer_height_m = heights_m[i];
    alone.radius_m = radii_m[i];
    alone.azimuth_from_rad = azimuths_rad[2 * i];
    alone.azimuth_to_rad = azimuths_rad[2 * i + 1];
    ASSERT_EQ(offing_compute_viewshed(terrain_, &alone, each[i].data(), posts), OFFING_OK)
        << offing_last_error();
  }

  std::vector<std::uint16_t> seen_by(posts);
  std::vector<std::uint8_t> is_reached(posts);
  std::array<std::uint64_t, observer_count> seen_posts{}, reached_posts{}, only_posts{};
  std::array<std::size_t, 2> best{};
  std::array<std::uint64_t, 2> best_posts{};
  int is_exhaustive = 0;
  const OffingSightCounts counts{
      sizeof counts,     seen_by.data(), is_reached.data(), seen_posts.data(), reached_posts.data(),
      only_posts.data(), best.size(),    best.data(),       best_posts.data(), &is_exhaustive};
  ASSERT_EQ(offing_count_viewsheds(terrain_, &shared, &observers, &counts, posts, nullptr), OFFING_OK)
      << offing_last_error();
  std::array<std::uint64_t, observer_count> due_posts{}, due_only{};
  for (std::size_t post = 0; post < posts; ++post) {
    std::uint16_t due = 0;
    for (const auto& seen : each) due = static_cast<std::uint16_t>(due + (seen[post] == 255 ? 1 : 0));
    EXPECT_EQ(seen_by[post], due);
    EXPECT_EQ(is_reached[post], 1);  // the first looks everywhere
    for (std::size_t i = 0; i < observer_count; ++i) {
      due_posts[i] += each[i][post] == 255 ? 1 : 0;
      due_only[i] += each[i][post] == 255 && due == 1 ? 1 : 0;
    }
  }
  EXPECT_EQ(seen_posts, due_posts);
  EXPECT_EQ(only_posts, due_only);
  EXPECT_EQ(reached_posts[0], posts);
  EXPECT_LT(reached_posts[1], posts / 2);
  EXPECT_EQ(is_exhaustive, 1);
  const auto together = [&](std::size_t a, std::size_t b) {
    std::uint64_t sum = 0;
    for (std::size_t post = 0; post < posts; ++post)
      sum += each[a][post] == 255 || each[b][post] == 255 ? 1 : 0;
    return sum;
  };
  EXPECT_EQ(best_posts[1], together(best[0], best[1]));
  EXPECT_EQ(best_posts[1], std::max({together(0, 1), together(0, 2), together(1, 2)}));
  EXPECT_EQ(best_posts[0], seen_posts[best[0]]);
}

// Fails if a bad observer is not named, more are chosen than there are, or a callback cannot stop the call.
TEST_F(TerrainCallsTest, RefusesBadObservers) {
  const std::array<double, 4> points_m{57.0, 83.0, 20.0, -10.0};
  auto shared = sized<OffingViewshed>();
  auto observers = sized<OffingObservers>();
  observers.count = 2;
  auto counts = sized<OffingSightCounts>();
  const std::size_t posts = map_.heights_m.size();
  const auto call = [&](const OffingProgress* progress) {
    return offing_count_viewsheds(terrain_, &shared, &observers, &counts, posts, progress);
  };
  EXPECT_EQ(call(nullptr), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("points_m"));
  observers.points_m = points_m.data();
  EXPECT_EQ(call(nullptr), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("observers[1]: viewshed: observer_z_m"));
  observers.count = 1;
  counts.best_count = 2;
  EXPECT_EQ(call(nullptr), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("best_count"));
  counts.best_count = 0;
  OffingProgress progress{sizeof progress, [](void*, double share) { return share > 0.5 ? 1 : 0; }, nullptr};
  EXPECT_EQ(call(&progress), OFFING_CANCELLED);
  EXPECT_EQ(call(nullptr), OFFING_OK) << offing_last_error();
}

// Fails if points are elsewhere than the file says, an attribute is another's, or texts become numbers.
TEST_F(TerrainCallsTest, ReadsPointFiles) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "wells.geojson").string();
  std::ofstream(file) << R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"depth_m": 7.5, "rank": 3, "name": "spring"},
     "geometry": {"type": "Point", "coordinates": [-70.5, -32.25, 12]}},
    {"type": "Feature", "properties": {"depth_m": null, "rank": 4, "name": "hut"},
     "geometry": {"type": "Point", "coordinates": [-70.25, -32.5]}}]})";
  OffingPointFile* points = nullptr;
  ASSERT_EQ(offing_open_point_file(file.c_str(), nullptr, &points), OFFING_OK) << offing_last_error();
  auto info = sized<OffingPointFileInfo>();
  ASSERT_EQ(offing_get_point_file_info(points, &info), OFFING_OK);
  EXPECT_EQ(info.count, 2u);
  EXPECT_EQ(info.attribute_count, 3u);
  EXPECT_STREQ(info.coordinate_system, "lonlat");
  EXPECT_STREQ(info.layer, "wells");
  EXPECT_STREQ(offing_point_attribute_name(points, 2), "name");
  EXPECT_STREQ(offing_point_attribute_name(points, 3), "");
  std::array<double, 4> places{};
  std::array<double, 2> z{}, values{};
  ASSERT_EQ(offing_read_point_file(points, places.data(), z.data(), 2), OFFING_OK) << offing_last_error();
  EXPECT_THAT(places, testing::ElementsAre(-70.5, -32.25, -70.25, -32.5));
  EXPECT_THAT(z, testing::ElementsAre(12.0, testing::IsNan()));
  ASSERT_EQ(offing_read_point_attribute(points, "depth_m", values.data(), 2), OFFING_OK);
  EXPECT_THAT(values, testing::ElementsAre(7.5, testing::IsNan()));
  ASSERT_EQ(offing_read_point_attribute(points, "rank", values.data(), 2), OFFING_OK);
  EXPECT_THAT(values, testing::ElementsAre(3.0, 4.0));
  ASSERT_EQ(offing_read_point_attribute(points, "name", values.data(), 2), OFFING_OK);
  EXPECT_THAT(values, testing::Each(testing::IsNan()));
  EXPECT_EQ(offing_read_point_attribute(points, "width", values.data(), 2), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("wells.geojson"));
  EXPECT_EQ(offing_read_point_file(points, places.data(), nullptr, 3), OFFING_BAD_INPUT);
  offing_free_point_file(points);
  EXPECT_EQ(offing_open_point_file("nowhere.gpkg", nullptr, &points), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("nowhere.gpkg"));
}

// Fails if places are elsewhere than the file says, or a terrain that lies nowhere has a place in the world.
TEST_F(TerrainCallsTest, ConvertsPlaces) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "grid.asc").string();
  std::ofstream(file) << "ncols 3\nnrows 2\nxllcenter -70.5\nyllcenter -32.5\ncellsize 0.01\n1 2 3\n4 5 6\n";
  std::ofstream((folder.path() / "grid.prj").string())
      << "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],"
         "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]]";
  OffingTerrain* terrain = nullptr;
  ASSERT_EQ(offing_open_terrain(device_, file.c_str(), nullptr, &terrain), OFFING_OK) << offing_last_error();
  auto info = sized<OffingTerrainInfo>();
  ASSERT_EQ(offing_get_terrain_info(terrain, &info), OFFING_OK);
  std::array<double, 4> places{-70.48, -32.5, 289.5, -32.49}, again{};
  std::array<double, 4> places_m{};
  ASSERT_EQ(offing_places_to_terrain(terrain, "lonlat", places.data(), places_m.data(), 2), OFFING_OK)
      << offing_last_error();
  EXPECT_NEAR(places_m[0], 2.0 * info.spacing_x_m, 1e-6);
  EXPECT_NEAR(places_m[1], info.spacing_z_m, 1e-6);
  EXPECT_NEAR(places_m[2], 0.0, 1e-6);
  EXPECT_NEAR(places_m[3], 0.0, 1e-6);
  ASSERT_EQ(offing_places_from_terrain(terrain, "EPSG:4326", places_m.data(), again.data(), 2), OFFING_OK);
  EXPECT_NEAR(again[0], -70.48, 1e-9);
  EXPECT_NEAR(again[2], -70.5, 1e-9);
  EXPECT_EQ(offing_places_to_terrain(terrain, "atlantis", places.data(), places_m.data(), 2),
            OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("system: expected local, map, lonlat"));
  EXPECT_THAT(offing_last_hint(), HasSubstr("give \"lonlat\" as system"));
  offing_free_terrain(terrain);
  EXPECT_EQ(offing_places_to_terrain(terrain_, "lonlat", places.data(), places_m.data(), 2),
            OFFING_BAD_INPUT);
  EXPECT_EQ(offing_places_to_terrain(terrain_, "local", places.data(), places_m.data(), 2), OFFING_OK);
  EXPECT_EQ(places_m, places);
}

// Fails if a bad argument is taken, or refused without a word that helps.
TEST_F(TerrainCallsTest, RefusesBadArguments) {
  OffingTerrain* terrain = nullptr;
  EXPECT_EQ(offing_open_terrain(device_, "no/such.tif", nullptr, &terrain), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("no/such.tif"));
  EXPECT_STRNE(offing_last_hint(), "");
  auto options = sized<OffingTerrainOptions>();
  options.encoding = static_cast<OffingHeightEncoding>(3);
  EXPECT_EQ(offing_open_terrain(device_, "no/such.tif", &options, &terrain), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("encoding"));
  EXPECT_EQ(offing_make_terrain(device_, map_.heights_m.data(), 1, 5, 10.0, 10.0, &terrain),
            OFFING_BAD_INPUT);
  EXPECT_EQ(offing_make_terrain(device_, map_.heights_m.data(), -3, -5, 1.0, 1.0, &terrain),
            OFFING_BAD_INPUT);
  EXPECT_EQ(offing_make_terrain(device_, map_.heights_m.data(), 5, 5, 0.0, 10.0, &terrain), OFFING_BAD_INPUT);
  EXPECT_EQ(offing_make_terrain(nullptr, map_.heights_m.data(), 5, 5, 10.0, 10.0, &terrain),
            OFFING_BAD_INPUT);
  map_.heights_m[7] = std::nanf("");
  EXPECT_EQ(offing_make_terrain(device_, map_.heights_m.data(), 5, 5, 1.0, 1.0, &terrain), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("row 1, column 2"));
  EXPECT_EQ(terrain, nullptr);

  float height_m = 0.0f;
  EXPECT_EQ(offing_read_terrain(terrain_, &height_m, nullptr, 1), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("693"));
  const std::vector<double> place_m{10.0, 50.0, 10.0}, long_way{1.0, 1.0, 0.0}, beyond_m{900.0, 10.0, 2.0};
  const auto hits = sized<OffingHits>();
  EXPECT_EQ(offing_cast_rays(terrain_, nullptr, place_m.data(), long_way.data(), nullptr, 1, &hits),
            OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("rays[0]"));
  EXPECT_THAT(offing_last_hint(), HasSubstr("length"));
  EXPECT_EQ(offing_cast_rays(terrain_, nullptr, nullptr, nullptr, nullptr, 0, nullptr), OFFING_OK);
  const auto lines = sized<OffingSightLines>();
  EXPECT_EQ(offing_trace_sight_lines(terrain_, nullptr, place_m.data(), beyond_m.data(), 1, &lines),
            OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("to_m[0]"));
  auto query = sized<OffingTerrainQuery>();
  query.earth_radius_m = -1.0;
  EXPECT_EQ(offing_trace_sight_lines(terrain_, &query, place_m.data(), place_m.data(), 1, &lines),
            OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("radius_m"));
  auto viewshed = sized<OffingViewshed>();
  viewshed.observer_x_m = 900.0;
  std::vector<std::uint8_t> seen(map_.heights_m.size());
  EXPECT_EQ(offing_compute_viewshed(terrain_, &viewshed, seen.data(), seen.size()), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("observer_x_m"));
}

// Fails if a call gets into a terrain that another one is using.
TEST_F(TerrainCallsTest, IsForOneThreadAtATime) {
  const std::array<double, 2> point_m{1.0, 1.0};
  const auto samples = sized<OffingTerrainSamples>();
  {
    const c::Use use(terrain_, "terrain");
    EXPECT_EQ(offing_sample_terrain(terrain_, nullptr, point_m.data(), 1, &samples), OFFING_BUSY);
    EXPECT_THAT(offing_last_hint(), HasSubstr("each thread"));
  }
  EXPECT_EQ(offing_sample_terrain(terrain_, nullptr, point_m.data(), 1, &samples), OFFING_OK);
}

}  // namespace
}  // namespace offing
