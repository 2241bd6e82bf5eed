// Hulls seen from below and above: against closed forms, and what an open boat keeps out.
#include "host/bodies/hull_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "host/bodies/hull.h"
#include "host/bodies/pressed_hull.h"
#include "tests/bodies/example_bodies.h"

namespace offing::bodies {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

std::size_t middle() {
  return static_cast<std::size_t>(HullMap::rows / 2) * HullMap::columns + HullMap::columns / 2;
}

/// Of the columns' own boxes below a level.
double volume_below_m3(const HullMap& map, double level_m) {
  double sum_m3 = 0.0;
  for (const float bottom_m : map.bottom_m) {
    if (bottom_m == infinity) continue;
    sum_m3 += std::max(0.0, level_m - static_cast<double>(bottom_m)) * map.cell_x_m * map.cell_z_m;
  }
  return sum_m3;
}

// Fails if columns beside a box are its own, or one of its columns is not: a box fills its map but for the
// columns around.
TEST(HullMapTest, OfABoxIsExact) {
  const HullMap map = map_of_hull(test::box({4.0, 2.0, 3.0}));
  EXPECT_EQ(map.bottom_m[middle()], -1.0f);
  EXPECT_EQ(map.top_m[middle()], 1.0f);
  EXPECT_EQ(map.rim_m[middle()], 1.0f);
  EXPECT_EQ(map.bottom_m.front(), infinity);
  EXPECT_EQ(map.rim_m.front(), -infinity);
  EXPECT_NEAR(volume_below_m3(map, 0.5), 4.0 * 3.0 * 1.5, 1e-9);
  EXPECT_FALSE(is_open(map));
}

// Fails if an icosphere's underside is elsewhere: 4/3 pi r^3 / 2 below its middle, of which a map of this
// fineness loses the rim, half a column wide, and the faces their sagitta; measured 0.4 %, gate 1 %.
TEST(HullMapTest, OfABall) {
  const double half_m3 = 2.0 / 3.0 * 3.14159265 * 8.0;
  EXPECT_NEAR(volume_below_m3(map_of_hull(test::ball(2.0, 5)), 0.0) / half_m3, 1.0, 0.01);
}

// Fails if a boat's rim is not where water would run in first: amidships, where the sheer is lowest.
TEST(HullMapTest, AnOpenBoatKeepsWaterOutUpToItsLowestRim) {
  const HullMap map = map_of_hull(test::boat(6.0));
  EXPECT_TRUE(is_open(map));
  EXPECT_FALSE(is_open(map_of_hull(test::ship(24.0))));
  // Its sheer is 0.09 of its length amidships, its inner floor 0.03 below the water plane at the lowest.
  EXPECT_NEAR(map.rim_m[middle()], 0.54, 0.02);
  EXPECT_NEAR(map.top_m[middle()], -0.18, 0.02);
  EXPECT_NEAR(map.bottom_m[middle()], -0.36, 0.02);
}

// Fails if water presses on the inside of an open boat: covered, it encloses what the outer skin does.
TEST(PressedHullTest, CoversAnOpenBoat) {
  const TriangleMesh boat = test::boat(6.0);
  const HullMap map = map_of_hull(boat);
  const TriangleMesh covered = pressed_hull(boat, map, boat.faces.size());
  require_hull(covered, "boat");
  double filled_m3 = 0.0;
  for (std::size_t i = 0; i < map.rim_m.size(); ++i) {
    if (map.rim_m[i] == -infinity) continue;
    filled_m3 += (static_cast<double>(map.rim_m[i]) - static_cast<double>(map.bottom_m[i])) * map.cell_x_m *
                 map.cell_z_m;
  }
  // The wall's cover slopes where columns of the map do not: measured 1 %, gate 4 %.
  EXPECT_NEAR(enclosed_by(covered).volume_m3 / filled_m3, 1.0, 0.04);
  EXPECT_GT(enclosed_by(covered).volume_m3, 2.0 * enclosed_by(boat).volume_m3);
}

// Fails if a fine mesh is not made coarser, or is another hull then.
TEST(PressedHullTest, MakesFineMeshesCoarser) {
  const TriangleMesh ship = test::ship(24.0, 120);
  const TriangleMesh coarse = pressed_hull(ship, map_of_hull(ship), 1000);
  EXPECT_LE(coarse.faces.size(), 1000u);
  EXPECT_GT(coarse.faces.size(), 300u);
  require_hull(coarse, "ship");
  EXPECT_NEAR(enclosed_by(coarse).volume_m3 / enclosed_by(ship).volume_m3, 1.0, 1e-9);
  const TriangleMesh box = test::box({1.0, 1.0, 1.0});
  EXPECT_EQ(pressed_hull(box, map_of_hull(box), 1000).positions_m, box.positions_m);
}

}  // namespace
}  // namespace offing::bodies
