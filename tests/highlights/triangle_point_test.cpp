#include "host/highlights/search/triangle_point.h"

#include <gtest/gtest.h>

namespace offing::highlights {
namespace {

void expect_weights(const glm::dvec3& found, const glm::dvec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-15) << "corner " << i;
}

// By hand: above the inside, beyond an edge, beyond a corner.
TEST(TrianglePoint, IsNearest) {
  const glm::dvec3 a(0.0), b(2.0, 0.0, 0.0), c(0.0, 2.0, 0.0);
  expect_weights(nearest_weights({0.5, 0.5, 3.0}, a, b, c), {0.5, 0.25, 0.25});
  expect_weights(nearest_weights({1.0, -2.0, 1.0}, a, b, c), {0.5, 0.5, 0.0});
  expect_weights(nearest_weights({3.0, -1.0, 0.0}, a, b, c), {0.0, 1.0, 0.0});
  EXPECT_NEAR(squared_distance({0.5, 0.5, 3.0}, a, b, c), 9.0, 1e-12);
  EXPECT_NEAR(squared_distance({1.0, -2.0, 1.0}, a, b, c), 5.0, 1e-12);
  EXPECT_NEAR(squared_distance({3.0, -1.0, 0.0}, a, b, c), 2.0, 1e-12);
}

// A triangle without area is its longest edge, and one without edges its corner: fails if a share is no
// number.
TEST(TrianglePoint, IsOnEdgesWhereThereIsNoArea) {
  const glm::dvec3 a(0.0), b(1.0, 0.0, 0.0), c(4.0, 0.0, 0.0);
  EXPECT_NEAR(squared_distance({3.0, 2.0, 0.0}, a, b, c), 4.0, 1e-12);
  EXPECT_NEAR(squared_distance({-1.0, 0.0, 0.0}, a, a, a), 1.0, 1e-12);
}

}  // namespace
}  // namespace offing::highlights
