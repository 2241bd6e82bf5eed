// Lakes in basins of the ground: levels, wet posts, measures and outlines, against floods by brute force.
#include "host/terrain/lakes/lake.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/base/height_map.h"
#include "host/base/work.h"
#include "host/terrain/generate/fractal_terrain.h"

namespace offing::terrain {
namespace {

HeightMap map_of(int columns, int rows, double spacing_m,
                 const std::function<double(double, double)>& height_m) {
  HeightMap map;
  map.columns = columns;
  map.rows = rows;
  map.spacing_x_m = map.spacing_z_m = spacing_m;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column)
      map.heights_m.push_back(static_cast<float>(height_m(column * spacing_m, row * spacing_m)));
  }
  return map;
}

/// A bowl 40 m deep in the middle of 1 km of ground, its rim at 100 m, but for a notch in the east of 90 m.
HeightMap bowl() {
  return map_of(101, 101, 10.0, [](double x_m, double z_m) {
    const double r = std::hypot(x_m - 500.0, z_m - 500.0);
    const double rim_m = x_m > 500.0 && std::abs(z_m - 500.0) < 5.0 ? 90.0 : 100.0;
    return r < 300.0 ? std::min(60.0 + 40.0 * (r / 300.0) * (r / 300.0), rim_m) : rim_m - 0.05 * (r - 300.0);
  });
}

HeightMap made_valleys() {
  FractalParameters parameters;
  parameters.posts = 129;
  parameters.side_m = 6000.0;
  parameters.seed = 5;
  HeightMap map;
  map.columns = map.rows = parameters.posts;
  map.spacing_x_m = map.spacing_z_m = parameters.side_m / (parameters.posts - 1);
  FractalTerrain maker(parameters);
  std::vector<float> row_m(static_cast<std::size_t>(parameters.posts));
  for (int row = 0; row < parameters.posts; ++row) {
    maker.fill_row(row, row_m);
    map.heights_m.insert(map.heights_m.end(), row_m.begin(), row_m.end());
  }
  return map;
}

/// Posts below a level that are joined to one; found by asking all neighbours, and diagonal ones by many
/// ways between them.
std::vector<bool> flooded(const HeightMap& map, int column, int row, double level_m, bool* reaches_edge) {
  std::vector<bool> wet(map.heights_m.size(), false);
  std::deque<std::pair<int, int>> queue{{column, row}};
  wet[map.index(column, row)] = true;
  *reaches_edge = false;
  while (!queue.empty()) {
    const auto [x, z] = queue.front();
    queue.pop_front();
    if (x == 0 || z == 0 || x == map.columns - 1 || z == map.rows - 1) {
      *reaches_edge = true;
      continue;
    }
    for (int right = -1; right <= 1; ++right) {
      for (int down = -1; down <= 1; ++down) {
        const std::size_t to = map.index(x + right, z + down);
        if (wet[to] || map.heights_m[to] >= level_m) continue;
        // Water joins two corners of a patch where a straight way across has none but lower ground at its
        // ends.
        const auto h = [&](int a, int b) {
          return double{map.heights_m[map.index(x + a * right, z + b * down)]};
        };
        double lowest_m = right != 0 && down != 0 ? 1e9 : -1e9;
        for (int i = 0; i <= 512 && lowest_m >= level_m; ++i) {
          const double u = i / 512.0;
          lowest_m =
              std::min(lowest_m, std::max(std::lerp(h(0, 0), h(1, 0), u), std::lerp(h(0, 1), h(1, 1), u)));
        }
        if (lowest_m >= level_m) continue;
        wet[to] = true;
        queue.emplace_back(x + right, z + down);
      }
    }
  }
  return wet;
}

// Fails if the level, the measures or the depth of a lake are not those of its bowl.
TEST(LakeTest, FillsABowl) {
  const HeightMap map = bowl();
  const TerrainPosts posts = posts_of(map);
  const Lake full = fill_lake(posts, 480.0, 520.0, std::nullopt);
  EXPECT_EQ(full.spill_level_m, 90.0);
  EXPECT_EQ(full.level_m, full.spill_level_m);
  EXPECT_NEAR(full.spill_m.x, 780.0, 30.0);
  EXPECT_NEAR(full.spill_m.y, 500.0, 10.0);
  // 20 m deep: r = 300 sqrt(1/2).
  const Lake half = fill_lake(posts, 480.0, 520.0, 80.0);
  const double area_m2 = std::numbers::pi * 0.5 * 300.0 * 300.0;
  EXPECT_NEAR(half.area_m2 / area_m2, 1.0, 0.01);
  EXPECT_NEAR(half.volume_m3 / (0.5 * area_m2 * 20.0), 1.0, 0.01);
  EXPECT_NEAR(half.greatest_depth_m, 20.0, 1e-5);
  EXPECT_NEAR(depth_of_lake(half, posts, 505.0, 500.0), 20.0, 0.1);
  EXPECT_EQ(depth_of_lake(half, posts, 800.0, 500.0), 0.0);
}

// Fails if an outline is not where the ground is at the level, does not close, or runs the wrong way.
TEST(LakeTest, HasItsShoreAtTheLevel) {
  HeightMap map = bowl();
  map.heights_m[map.index(55, 50)] = 95.0f;  // an island
  const TerrainPosts posts = posts_of(map);
  const Lake lake = fill_lake(posts, 480.0, 520.0, 85.0);
  const auto rings = outline_of(lake, posts);
  ASSERT_EQ(rings.size(), 2u);
  std::vector<double> areas_m2;
  for (const auto& ring : rings) {
    EXPECT_EQ(ring.front(), ring.back());
    double twice_m2 = 0.0;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
      EXPECT_NEAR(terrain_at(posts, ring[i].x, ring[i].y)->height_m, 85.0, 1e-3);
      // North is up: -z.
      twice_m2 += ring[i + 1].x * ring[i].y - ring[i].x * ring[i + 1].y;
    }
    areas_m2.push_back(0.5 * twice_m2);
  }
  EXPECT_GT(areas_m2[0], 0.0);
  EXPECT_LT(areas_m2[1], 0.0);
  EXPECT_NEAR((areas_m2[0] + areas_m2[1]) / lake.area_m2, 1.0, 2e-3);
}

// Fails if a lake in made valleys has other posts than a flood by brute force, or its spill level is not the
// highest at which that flood stays on the map.
TEST(LakeTest, IsWhatAFloodFinds) {
  const HeightMap map = made_valleys();
  const TerrainPosts posts = posts_of(map);
  int compared = 0;
  for (int row = 6; row < map.rows - 6; row += 9) {
    for (int column = 6; column < map.columns - 6; column += 9) {
      Lake lake;
      try {
        lake = fill_lake(posts, column * map.spacing_x_m, row * map.spacing_z_m, std::nullopt);
      } catch (const Error&) {
        continue;  // from where water runs off the map
      }
      bool reaches_edge = false;
      const std::vector<bool> wet = flooded(map, column, row, lake.level_m, &reaches_edge);
      EXPECT_FALSE(reaches_edge) << column << ' ' << row;
      for (int z = 0; z < map.rows; ++z) {
        for (int x = 0; x < map.columns; ++x)
          EXPECT_EQ(lake.is_wet_at(x, z), wet[map.index(x, z)]) << x << ' ' << z;
      }
      flooded(map, column, row, lake.level_m + 0.2, &reaches_edge);
      EXPECT_TRUE(reaches_edge) << column << ' ' << row;
      ++compared;
    }
  }
  EXPECT_GT(compared, 5);
}

std::string fault_of(double x_m, double z_m, std::optional<double> level_m) {
  const HeightMap map = bowl();
  try {
    fill_lake(posts_of(map), x_m, z_m, level_m, "tarn");
  } catch (const Error& error) {
    return error.what() + std::string(" | ") + error.hint();
  }
  return {};
}

// Fails if a place or a level at which there can be no lake is taken, or refused without the figures that
// help.
TEST(LakeTest, RefusesWhatHoldsNoWater) {
  using testing::HasSubstr;
  EXPECT_THAT(fault_of(-1.0, 500.0, std::nullopt),
              HasSubstr("tarn: expected a place on the map, found (-1, 500)"));
  EXPECT_THAT(fault_of(480.0, 520.0, 95.0), HasSubstr("up to its spill level, 9"));
  EXPECT_THAT(fault_of(480.0, 520.0, 55.0), HasSubstr("a level above the ground at (480, 520), which is 60"));
  EXPECT_THAT(fault_of(900.0, 100.0, std::nullopt), HasSubstr("from where water runs off the map"));
  EXPECT_THAT(fault_of(900.0, 100.0, 300.0), HasSubstr("from where water runs off the map"));
}

// Fails if a basin of more posts is flooded than there may be: vast ones would take all memory. Before: they
// did.
TEST(LakeTest, RefusesVastBasins) {
  const HeightMap map = bowl();
  const auto fill = [&](std::size_t most_posts) {
    return fill_lake(posts_of(map), 480.0, 520.0, std::nullopt, "pan", {}, most_posts);
  };
  EXPECT_GT(fill(4000).area_m2, 0.0);
  try {
    fill(1000);
    ADD_FAILURE() << "filled";
  } catch (const Error& error) {
    EXPECT_EQ(error.what(),
              std::string("pan: expected a basin of at most 1000 posts of the map, found more"));
  }
}

// Fails if a flood goes on after it was asked to stop.
TEST(LakeTest, Stops) {
  const HeightMap map = bowl();
  CancelToken cancel;
  cancel.cancel();
  try {
    fill_lake(posts_of(map), 480.0, 520.0, std::nullopt, "lake", Work(cancel));
    ADD_FAILURE() << "filled";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cancelled);
  }
}

// Fails if lakes that share water are not told from neighbours.
TEST(LakeTest, KnowsSharedWater) {
  HeightMap map = map_of(41, 21, 10.0, [](double, double) { return 0.0; });
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const double west = std::hypot(column - 10.0, row - 10.0), east = std::hypot(column - 30.0, row - 10.0);
      map.heights_m[map.index(column, row)] = static_cast<float>(50.0 + 2.0 * std::min({west, east, 9.0}));
    }
  }
  const TerrainPosts posts = posts_of(map);
  const Lake west = fill_lake(posts, 100.0, 100.0, 60.0), east = fill_lake(posts, 300.0, 100.0, 60.0);
  EXPECT_FALSE(overlap(west, east));
  EXPECT_TRUE(overlap(west, fill_lake(posts, 120.0, 100.0, 55.0)));
}

}  // namespace
}  // namespace offing::terrain
