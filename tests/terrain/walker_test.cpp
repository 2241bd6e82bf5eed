#include "host/terrain/walk/walker.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/terrain/field/terrain_posts.h"
#include "tests/ocl/expect_error.h"

namespace offing {
namespace {

using terrain::posts_of;
using terrain::Walker;
using terrain::WalkerState;

/// 101 x 101 posts 2 m apart, their heights a function of the place in m.
HeightMap made(const std::function<double(double, double)>& height_m) {
  HeightMap map;
  map.columns = map.rows = 101;
  map.spacing_x_m = map.spacing_z_m = 2.0;
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      map.heights_m.push_back(static_cast<float>(height_m(2.0 * column, 2.0 * row)));
    }
  }
  return map;
}

double above_ground_m(const HeightMap& map, const WalkerState& state) {
  return state.eye_m.y - terrain::terrain_at(map, state.eye_m.x, state.eye_m.z)->height_m;
}

// Fails if velocity in plan depends on the slope, or feet leave gentle ground.
TEST(WalkerTest, GoesAsWantedOverGentleGround) {
  const HeightMap map = made([](double x_m, double z_m) { return 0.5 * x_m - 0.25 * z_m; });
  Walker walker(posts_of(map));
  walker.reset(50.0, 120.0, 7.0);
  walker.advance_to(17.0, {3.0, -4.0});
  const WalkerState state = walker.state();
  EXPECT_NEAR(state.eye_m.x, 80.0, 1e-9);
  EXPECT_NEAR(state.eye_m.z, 80.0, 1e-9);
  EXPECT_NEAR(state.eye_m.y, 0.5 * 80.0 - 0.25 * 80.0 + 1.7, 1e-9);
  EXPECT_NEAR(glm::distance(state.velocity_mps, {3.0, 2.5, -4.0}), 0.0, 1e-9);
  EXPECT_FALSE(state.is_falling);
}

// Fails if frames change the way: the rest of a step must show without being taken twice.
TEST(WalkerTest, FramesDoNotChangeTheWay) {
  const HeightMap map =
      made([](double x_m, double z_m) { return 30.0 * std::sin(0.07 * x_m) * std::cos(0.05 * z_m); });
  Walker one(posts_of(map)), many(posts_of(map));
  one.advance_to(9.0, {4.0, 1.0});
  for (int frame = 1; frame <= 9 * 61; ++frame) many.advance_to(frame / 61.0, {4.0, 1.0});
  EXPECT_EQ(one.state().eye_m, many.state().eye_m);
  EXPECT_EQ(one.state().velocity_mps, many.state().velocity_mps);
}

// Fails if frames between two steps show a place that jumps: 5 m/s are 5 mm in a millisecond.
TEST(WalkerTest, FramesBetweenStepsAreEven) {
  const HeightMap map = made([](double, double) { return 0.0; });
  Walker walker(posts_of(map));
  double before_m = walker.state().eye_m.x;
  for (int frame = 1; frame <= 1000; ++frame) {
    walker.advance_to(frame * 1e-3, {5.0, 0.0});
    EXPECT_NEAR(walker.state().eye_m.x - before_m, 5e-3, 1e-9);
    before_m = walker.state().eye_m.x;
  }
}

// A wall of 63 degrees from x = 120 m on. Fails if it is climbed by more than the patch at its foot, or stops
// what goes along it.
TEST(WalkerTest, SlidesAlongSteepGround) {
  const HeightMap map = made([](double x_m, double) { return std::max(0.0, 2.0 * (x_m - 120.0)); });
  Walker walker(posts_of(map));
  walker.reset(110.0, 20.0);
  walker.advance_to(20.0, {3.0, 4.0});
  EXPECT_NEAR(walker.state().eye_m.x, 120.0, 3.0 * Walker::step_s);
  EXPECT_NEAR(walker.state().eye_m.z, 100.0, 1e-6);
  EXPECT_NEAR(walker.state().eye_m.y, 1.7, 1e-9);
  walker.advance_to(30.0, {3.0, 0.0});
  EXPECT_NEAR(glm::length(walker.state().velocity_mps), 0.0, 1e-9);
}

// A cliff of 10 m within 2 m: from its edge at x = 100 m one flies. Theory: feet at 10 - g t^2 / 2, which are
// at the ground beyond the cliff after sqrt(2 * 10 / g) = 1.428 s, 5 m/s * 1.428 s = 7.1 m away. Steps of
// 1/120 s tell that within one.
TEST(WalkerTest, FallsFromACliff) {
  const HeightMap map = made([](double x_m, double) { return x_m <= 100.0 ? 10.0 : 0.0; });
  Walker walker(posts_of(map));
  walker.reset(95.0, 100.0);
  double fell_s = 0.0, landed_s = 0.0;
  for (int frame = 1; frame <= 480 && landed_s == 0.0; ++frame) {
    walker.advance_to(frame * Walker::step_s, {5.0, 0.0});
    EXPECT_GE(above_ground_m(map, walker.state()), 1.7 - 1e-9);
    if (walker.state().is_falling && fell_s == 0.0) fell_s = walker.time_s();
    if (!walker.state().is_falling && fell_s > 0.0) landed_s = walker.time_s();
  }
  EXPECT_NEAR(fell_s, 1.0, 2.0 * Walker::step_s);
  EXPECT_NEAR(landed_s - fell_s, std::sqrt(20.0 / 9.80665), 2.0 * Walker::step_s);
  EXPECT_NEAR(walker.state().eye_m.x, 107.14, 5.0 * 2.0 * Walker::step_s);
  EXPECT_NEAR(walker.state().eye_m.y, 1.7, 1e-9);
}

// Down a slope of 60 degrees under friction tan 45: g (sin 60 - cos 60) = 3.59 m/s^2 along it. After 2 s from
// rest 7.18 m down the slope, half of it in plan. Steps of semi-implicit contact are right to a step's speed:
// 3.59 * 2 / 120 = 0.06 m. Ends on level ground.
TEST(WalkerTest, SlidesDownWhatDoesNotHold) {
  const double slope = std::tan(std::numbers::pi / 3.0);
  const HeightMap map = made([&](double x_m, double) { return std::max(0.0, slope * (x_m - 60.0)); });
  Walker walker(posts_of(map));
  walker.reset(100.0, 100.0);
  EXPECT_TRUE(walker.state().is_falling);
  walker.advance_to(2.0, {50.0, 50.0});
  EXPECT_NEAR(walker.state().eye_m.x, 100.0 - 0.5 * 7.18, 0.06);
  EXPECT_NEAR(walker.state().eye_m.z, 100.0, 1e-9);
  EXPECT_NEAR(above_ground_m(map, walker.state()), 1.7, 1e-6);
  walker.advance_to(12.0, {0.0, 0.0});
  EXPECT_FALSE(walker.state().is_falling);
  EXPECT_LE(walker.state().eye_m.x, 60.0);
  EXPECT_NEAR(walker.state().eye_m.y, 1.7, 1e-9);
}

// Fails if he slides for ever between two steep sides.
TEST(WalkerTest, ComesToRestBetweenSteepSides) {
  const HeightMap map = made([](double x_m, double) { return 3.0 * std::abs(x_m - 100.0); });
  Walker walker(posts_of(map));
  walker.reset(110.0, 100.0);
  walker.advance_to(30.0, {0.0, 0.0});
  EXPECT_FALSE(walker.state().is_falling);
  EXPECT_NEAR(walker.state().eye_m.x, 100.0, 0.5);
}

TEST(WalkerTest, StopsAtTheEdge) {
  const HeightMap map = made([](double, double) { return 4.0; });
  Walker walker(posts_of(map));
  walker.advance_to(100.0, {50.0, -3.0});
  EXPECT_EQ(walker.state().eye_m, glm::dvec3(200.0, 4.0 + 1.7, 0.0));
  EXPECT_EQ(walker.state().velocity_mps, glm::dvec3(0.0));
}

// Fails if the last posts are not on the map where their place, a product, does not divide back: 20.6 m.
TEST(WalkerTest, StopsAtEdgesThatAreRounded) {
  for (const auto& [columns, spacing_m] :
       {std::pair(1024, 20.6), std::pair(3601, 0.7), std::pair(1024, 0.1)}) {
    HeightMap map;
    map.columns = columns;
    map.rows = 2;
    map.spacing_x_m = map.spacing_z_m = spacing_m;
    map.heights_m.assign(2 * static_cast<std::size_t>(columns), 4.0f);
    const double edge_m = spacing_m * (columns - 1);
    ASSERT_TRUE(terrain::terrain_at(map, edge_m, spacing_m));
    EXPECT_FALSE(terrain::terrain_at(map, edge_m * (1.0 + 1e-12), spacing_m));
    Walker walker(posts_of(map));
    walker.reset(edge_m - 1e-3, 0.5 * spacing_m);
    walker.advance_to(1.0, {50.0, 50.0});
    EXPECT_EQ(walker.state().eye_m, glm::dvec3(edge_m, 4.0 + 1.7, spacing_m));
  }
}

TEST(WalkerTest, RefusesWhatIsOutOfRange) {
  const HeightMap map = made([](double, double) { return 4.0; });
  Walker walker(posts_of(map));
  test::expect_error(ErrorKind::bad_input, "within the map", [&] { walker.reset(-1.0, 3.0); });
  test::expect_error(ErrorKind::bad_input, "within the map", [&] { walker.reset(1.0, std::nan("")); });
  test::expect_error(ErrorKind::bad_input, "wanted velocity", [&] { walker.advance_to(1.0, {2000.0, 0.0}); });
  test::expect_error(ErrorKind::bad_input, "time_s", [&] { walker.advance_to(INFINITY, {1.0, 0.0}); });
  test::expect_error(ErrorKind::bad_input, "eye_height_m",
                     [&] { Walker(posts_of(map), {.eye_height_m = -1.0}); });
  test::expect_error(ErrorKind::bad_input, "slope_limit_rad",
                     [&] { Walker(posts_of(map), {.slope_limit_rad = 1.6}); });
  test::expect_error(ErrorKind::bad_input, "gravity_mps2",
                     [&] { Walker(posts_of(map), {.gravity_mps2 = 0.0}); });
}

}  // namespace
}  // namespace offing
