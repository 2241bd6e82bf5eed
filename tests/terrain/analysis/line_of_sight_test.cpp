#include "host/terrain/analysis/line_of_sight.h"

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/terrain/field/height_field.h"
#include "tests/ocl/expect_error.h"

namespace offing::terrain {
namespace {

/// Level ground of 41 x 21 posts, 10 m apart, with a wall of 10 m along one column.
HeightMap walled(int wall_column) {
  HeightMap map;
  map.columns = 41;
  map.rows = 21;
  map.spacing_x_m = map.spacing_z_m = 10.0;
  for (int i = 0; i < 41 * 21; ++i) map.heights_m.push_back(i % 41 == wall_column ? 10.0f : 0.0f);
  return map;
}

RayHit hit_of(const HeightMap& map, const LineOfSight& sight, const EarthCurve& curve = {}) {
  HeightField field(ocl::Device::open(), post_grid(map), map.heights_m);
  return field.cast(std::vector{sight.ray()}, curve).front();
}

// A wall's slope begins a post before it and rises 1 in 1: a line 2 m above the ground hits it 2 m on. Fails
// if the line is not from the eye, or what hides it is measured from another place.
TEST(LineOfSightTest, StopsAtWalls) {
  const HeightMap map = walled(20);
  const LineOfSight sight(posts_of(map), {}, {"from", 100.0, 100.0, 2.0}, {"to", 300.0, 100.0, 2.0});
  const RayHit hit = hit_of(map, sight);
  ASSERT_EQ(hit.kind, TERRAIN_SURFACE);
  EXPECT_EQ(sight.distance_m(), 200.0);
  EXPECT_NEAR(sight.hidden_at_m(hit), 92.0, 0.01);
  EXPECT_LT(glm::distance(sight.point_m(sight.hidden_at_m(hit)), glm::dvec3(192.0, 2.0, 100.0)), 0.01);
  const LineOfSight over(posts_of(map), {}, {"from", 100.0, 100.0, 11.0}, {"to", 300.0, 100.0, 11.0});
  EXPECT_EQ(hit_of(map, over).kind, TERRAIN_MISS);
}

// Fails if the ground on which an end lies hides it.
TEST(LineOfSightTest, EndsMayLieOnTheGround) {
  const HeightMap map = walled(40);
  for (const double from_height_m : {0.0, 3.0}) {
    const LineOfSight sight(posts_of(map), {}, {"from", 13.0, 17.0, from_height_m},
                            {"to", 377.0, 191.0, 3.0 - from_height_m});
    EXPECT_EQ(hit_of(map, sight).kind, TERRAIN_MISS) << from_height_m;
  }
}

// On a planet of 4 km radius level ground falls away by d^2 / 2R: an eye 1 m up sees ground as far as
// sqrt(2R 1 m) = 89 m, and at 200 m what is (200 - 89)^2 / 2R = 1.53 m above it. Fails if the curve bends the
// line upward, or not from the eye on.
TEST(LineOfSightTest, GroundFallsAway) {
  const HeightMap map = walled(40);
  const EarthCurve curve{.radius_m = 4000.0};
  const auto sees = [&](double target_m) {
    const LineOfSight sight(posts_of(map), curve, {"from", 100.0, 100.0, 1.0},
                            {"to", 300.0, 100.0, target_m});
    return hit_of(map, sight, curve).kind == TERRAIN_MISS;
  };
  EXPECT_FALSE(sees(1.4));
  EXPECT_TRUE(sees(1.7));
}

// Fails if an end that cannot be is taken, or its error does not name it.
TEST(LineOfSightTest, NamesBadEnds) {
  const HeightMap map = walled(20);
  const TerrainPosts posts = posts_of(map);
  const SightEnd good{"one", 5.0, 5.0, 2.0};
  const auto sight = [&](const SightEnd& from, const SightEnd& to) {
    return [&posts, from, to] { LineOfSight(posts, {}, from, to); };
  };
  test::expect_error(ErrorKind::bad_input, "two: expected a place within",
                     sight(good, {"two", 401.0, 5.0, 2.0}));
  test::expect_error(ErrorKind::bad_input, "two: expected a height above ground",
                     sight({"two", 9.0, 9.0, -1.0}, good));
  test::expect_error(ErrorKind::bad_input, "two: expected a height above ground",
                     sight(good, {"two", 50.0, 5.0, std::nan("")}));
  test::expect_error(ErrorKind::bad_input, "two: expected a place away", sight(good, {"two", 5.0, 5.0, 2.0}));
}

}  // namespace
}  // namespace offing::terrain
