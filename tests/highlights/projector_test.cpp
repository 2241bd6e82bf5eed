#include "host/highlights/projectors/projector.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/highlights/example_surfaces.h"

namespace offing::highlights {
namespace {

HighlightPoint tilted_point() {
  test::RandomVectors random(7);
  const glm::dmat3 axes = random.rotation();
  HighlightPoint point;
  point.position_m = {3.0, -2.0, 5.0};
  point.e_max = axes[0];
  point.normal = axes[2];
  point.k_max_per_m = 4.0;
  point.k_min_per_m = -0.5;
  return point;
}

// Fails if a texture were mirrored (H4: right x up = normal), turned, or not where the point is (H7).
TEST(ProjectorTest, AxesAreRightHandedAndTheBoxIsMinusOneToOne) {
  const HighlightPoint point = tilted_point();
  const Projector projector = projector_at(point, {.threshold = 0.8, .cap_radius_m = 10.0});
  EXPECT_LE(glm::distance(glm::cross(projector.right, projector.up), projector.normal), 1e-15);
  EXPECT_EQ(projector.normal, point.normal);
  const glm::dmat4 matrix = projection_of(projector);
  const auto q = [&](const glm::dvec3& p) { return glm::dvec3(matrix * glm::dvec4(p, 1.0)); };
  EXPECT_LE(glm::length(q(point.position_m)), 1e-14);
  const glm::dvec3 corner =
      point.position_m + 0.5 * projector.width_m * projector.right - 0.5 * projector.height_m * projector.up;
  EXPECT_LE(glm::distance(q(corner), glm::dvec3(1.0, -1.0, 0.0)), 1e-13);
  EXPECT_GT(q(point.position_m + projector.normal).z, 0.0);
  EXPECT_EQ(texture_place({-1.0, 1.0, 0.0}), glm::dvec2(0.0, 0.0));
  EXPECT_EQ(texture_place({1.0, -1.0, 0.0}), glm::dvec2(1.0, 1.0));
}

// H5 by hand: threshold 0.8 leaves sqrt(1 - 0.64) = 0.6. Fails if half and full widths are mixed up, if
// hollows are not as wide as humps, or if flat places are not capped.
TEST(ProjectorTest, WidthsAreThoseOfTheCurvatureUpToTheCap) {
  const Projector projector = projector_at(tilted_point(), {.threshold = 0.8, .cap_radius_m = 10.0});
  EXPECT_NEAR(projector.width_m, 2.0 / 4.0 * 0.6, 1e-15);
  EXPECT_NEAR(projector.height_m, 2.0 / 0.5 * 0.6, 1e-15);
  EXPECT_NEAR(width_m(0.0, {.threshold = 0.8, .cap_radius_m = 0.7}), 1.4, 1e-15);
  EXPECT_NEAR(width_m(1e-9, {.threshold = 0.8, .cap_radius_m = 0.7}), 1.4, 1e-15);
}

// Euler: k_max along e_max, k_min across, their mean at 45 degrees.
TEST(ProjectorTest, CurvatureTurnsAsEulerSays) {
  const HighlightPoint point = tilted_point();
  const glm::dvec3 e_min = glm::cross(point.normal, point.e_max);
  EXPECT_NEAR(curvature_along(point, point.e_max), 4.0, 1e-14);
  EXPECT_NEAR(curvature_along(point, e_min), -0.5, 1e-14);
  EXPECT_NEAR(curvature_along(point, glm::normalize(point.e_max + e_min)), 1.75, 1e-14);
}

TEST(ProjectorTest, SizesOutOfRangeAreErrors) {
  for (const HighlightSize& size : {HighlightSize{.threshold = 1.0, .cap_radius_m = 1.0},
                                    HighlightSize{.threshold = -0.1, .cap_radius_m = 1.0},
                                    HighlightSize{.threshold = 0.5, .cap_radius_m = 0.0},
                                    HighlightSize{.threshold = 0.5, .cap_radius_m = std::nan("")}}) {
    EXPECT_THROW(projector_at(tilted_point(), size), Error);
  }
}

}  // namespace
}  // namespace offing::highlights
