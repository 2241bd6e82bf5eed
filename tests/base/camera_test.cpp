#include "host/base/camera.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing {
namespace {

using std::numbers::pi;
// A few roundings of values near 1.
constexpr double rounding = 1e-14;

void expect_near(glm::dvec3 found, glm::dvec3 expected, double tolerance) {
  EXPECT_NEAR(glm::distance(found, expected), 0.0, tolerance)
      << found.x << ' ' << found.y << ' ' << found.z << " instead of " << expected.x << ' ' << expected.y
      << ' ' << expected.z;
}

TEST(Camera, LooksAlongItsAxes) {
  const CameraBasis ahead = basis({});
  expect_near(ahead.forward, {0.0, 0.0, -1.0}, rounding);
  expect_near(ahead.right, {1.0, 0.0, 0.0}, rounding);
  expect_near(ahead.up, {0.0, 1.0, 0.0}, rounding);
  expect_near(basis({.yaw_rad = pi / 2.0}).forward, {1.0, 0.0, 0.0}, rounding);
  expect_near(basis({.pitch_rad = pi / 2.0}).forward, {0.0, 1.0, 0.0}, rounding);
  // A head that leans to the right has its right ear down.
  expect_near(basis({.roll_rad = pi / 2.0}).right, {0.0, -1.0, 0.0}, rounding);
}

TEST(Camera, HasRightHandedUnitAxes) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> angle_rad(-pi, pi);
  for (int i = 0; i < 100; ++i) {
    const CameraBasis axes = basis({.yaw_rad = angle_rad(generator),
                                    .pitch_rad = 0.5 * angle_rad(generator),
                                    .roll_rad = angle_rad(generator)});
    EXPECT_NEAR(glm::length(axes.forward), 1.0, rounding);
    EXPECT_NEAR(glm::length(axes.right), 1.0, rounding);
    expect_near(glm::cross(axes.right, axes.up), -axes.forward, rounding);
  }
}

// A point on a pixel's ray must come back to that pixel, at the depth near / distance.
TEST(Camera, ProjectsRaysBackWithReversedDepth) {
  const Camera camera{.yaw_rad = 0.7,
                      .pitch_rad = -0.3,
                      .roll_rad = 0.2,
                      .vertical_field_of_view_rad = 1.2,
                      .width_px = 1600,
                      .height_px = 900};
  constexpr double near_m = 0.1;
  for (const double distance_m : {near_m, 1.0, 1e9}) {
    for (const glm::dvec2 clip : {glm::dvec2(-1.0, -1.0), glm::dvec2(0.25, 0.5), glm::dvec2(1.0, -0.5)}) {
      const glm::dvec3 point = distance_m * ray_direction(camera, clip);
      const glm::dvec4 projected =
          projection(camera, near_m) * view_rotation(camera) * glm::dvec4(point, 1.0);
      EXPECT_NEAR(projected.x / projected.w, clip.x, 10.0 * rounding);
      EXPECT_NEAR(projected.y / projected.w, clip.y, 10.0 * rounding);
      EXPECT_NEAR(projected.z / projected.w, near_m / distance_m, 10.0 * rounding);
    }
  }
}

// A place above a plane and its mirror image below it: one eye sees the image where its own image sees the
// place, upside down.
TEST(Camera, MirrorsInALevelPlane) {
  const Camera camera{.eye_m = {3.0, 12.0, -5.0},
                      .yaw_rad = 0.7,
                      .pitch_rad = -0.3,
                      .roll_rad = 0.2,
                      .width_px = 1600,
                      .height_px = 900};
  constexpr double plane_m = 2.0, near_m = 0.1;
  const Camera image = mirrored(camera, plane_m);
  const glm::dvec3 place_m(40.0, 9.0, -50.0), place_image_m(40.0, 2.0 * plane_m - 9.0, -50.0);
  const auto seen_at = [&](const Camera& by, const glm::dvec3& at_m) {
    const glm::dvec4 clip = projection(by, near_m) * view_rotation(by) * glm::dvec4(at_m - by.eye_m, 1.0);
    return glm::dvec3(clip) / clip.w;
  };
  const glm::dvec3 direct = seen_at(camera, place_image_m), by_image = seen_at(image, place_m);
  EXPECT_NEAR(by_image.x, direct.x, 100.0 * rounding);
  EXPECT_NEAR(by_image.y, -direct.y, 100.0 * rounding);
  EXPECT_NEAR(by_image.z, direct.z, 100.0 * rounding);
}

TEST(Camera, NamesWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect_error = [](const Camera& camera, const char* name) {
    try {
      require_valid(camera);
      ADD_FAILURE() << name << " was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_FALSE(error.hint().empty()) << error.what();
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  };
  expect_error({.eye_m = {0.0, nan, 0.0}}, "eye_m");
  expect_error({.yaw_rad = nan}, "yaw_rad");
  expect_error({.pitch_rad = 1.6}, "pitch_rad");
  expect_error({.roll_rad = nan}, "roll_rad");
  expect_error({.vertical_field_of_view_rad = pi}, "vertical_field_of_view_rad");
  expect_error({.width_px = 0}, "width_px");
  expect_error({.height_px = 0}, "height_px");
  EXPECT_THROW(projection({}, 0.0), Error);
  EXPECT_NO_THROW(require_valid({.pitch_rad = -pi / 2.0}));
}

}  // namespace
}  // namespace offing
