// A thousand walks of 2 km: the feet are on the ground.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/io/height_maps/read_height_map.h"
#include "host/terrain/field/terrain_posts.h"
#include "host/terrain/generate/fractal_terrain.h"
#include "host/terrain/walk/walker.h"

namespace offing {
namespace {

using terrain::posts_of;
using terrain::Walker;
using terrain::WalkerState;

constexpr int walks = 1000;
constexpr double length_m = 2000.0, frame_s = 1.0 / 50.0;

double ulp(double value) {
  return std::nextafter(std::abs(value), std::numeric_limits<double>::infinity()) - std::abs(value);
}

/// Walks that turn every few seconds, at 6 ... 12 m/s, each until it has led 2 km, or 20 minutes.
void walk_over(const std::string& name, const HeightMap& map) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  Walker walker(posts_of(map));
  const double eye_height_m = walker.parameters().eye_height_m;
  const double slope_limit = std::cos(walker.parameters().slope_limit_rad);
  double worst_m = 0.0, lowest_m = 0.0, walked_m = 0.0, fallen_s = 0.0;
  int whole = 0;
  for (int walk = 0; walk < walks; ++walk) {
    walker.reset(any(random) * map.spacing_x_m * (map.columns - 1),
                 any(random) * map.spacing_z_m * (map.rows - 1));
    glm::dvec2 wanted_mps(0.0);
    double way_m = 0.0, time_s = 0.0, turn_s = 0.0;
    for (glm::dvec3 before_m = walker.state().eye_m; way_m < length_m && time_s < 1200.0;) {
      if (time_s >= turn_s) {
        const double heading = 2.0 * std::numbers::pi * any(random), speed_mps = 6.0 + 6.0 * any(random);
        wanted_mps = speed_mps * glm::dvec2(std::cos(heading), std::sin(heading));
        turn_s = time_s + 5.0 + 20.0 * any(random);
      }
      walker.advance_to(time_s += frame_s, wanted_mps);
      const WalkerState& state = walker.state();
      const auto terrain = terrain::terrain_at(map, state.eye_m.x, state.eye_m.z);
      ASSERT_TRUE(terrain) << name << ": beyond the edge";
      const double expected_m = terrain->height_m + eye_height_m, above_m = state.eye_m.y - expected_m;
      lowest_m = std::min(lowest_m, above_m);
      if (state.is_falling) fallen_s += frame_s;
      if (!state.is_falling && terrain->normal.y >= slope_limit) {
        worst_m = std::max(worst_m, std::abs(above_m));
        ASSERT_LE(std::abs(above_m), std::max(1e-3, 4.0 * ulp(expected_m))) << name;
      }
      way_m += glm::distance(state.eye_m, before_m);
      before_m = state.eye_m;
    }
    walked_m += way_m;
    whole += way_m >= length_m ? 1 : 0;
  }
  std::printf("%s: %.0f km, %d walks of 2 km, %.0f s of falls, off the ground by at most %.2g m\n",
              name.c_str(), 1e-3 * walked_m, whole, fallen_s, worst_m);
  EXPECT_GE(lowest_m, -1e-9) << name << ": below ground";
  // Others are held in pits that do not let them out within 20 minutes.
  EXPECT_GE(whole, walks * 9 / 10) << name;
}

// Fails if feet leave ground that holds them by more than a millimetre, go below any, or go nowhere.
TEST(RandomWalksTest, OverMadeTerrain) {
  for (const double relief_m : {400.0, 1500.0}) {
    const terrain::FractalParameters parameters{
        .posts = 513, .side_m = 5120.0, .relief_m = relief_m, .longest_m = 2500.0, .seed = 3};
    terrain::FractalTerrain terrain(parameters);
    HeightMap map;
    map.columns = map.rows = parameters.posts;
    map.spacing_x_m = map.spacing_z_m = parameters.side_m / (parameters.posts - 1);
    const auto posts = static_cast<std::size_t>(parameters.posts);
    map.heights_m.resize(posts * posts);
    for (int row = 0; row < map.rows; ++row) {
      terrain.fill_row(row, std::span(map.heights_m).subspan(map.index(0, row), posts));
    }
    walk_over("relief of " + std::to_string(static_cast<int>(relief_m)) + " m", map);
  }
}

// The same on measured ground.
TEST(RandomWalksTest, OverRealTerrain) {
  const char* folder = std::getenv("OFFING_TEST_DATA");
  if (folder == nullptr) GTEST_SKIP() << "OFFING_TEST_DATA is not set";
  for (const char* name : {"S33W071.tif", "N48W125.hgt.zip", "N42E001.hgt.zip", "SainteHelens.dem"}) {
    walk_over(name, read_height_map(std::filesystem::path(folder) / "terrain" / name).map);
  }
}

}  // namespace
}  // namespace offing
