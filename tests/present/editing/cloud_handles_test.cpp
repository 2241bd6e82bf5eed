// Handles of balls and clouds: where they are, and what a pull of each comes to.
#include "present/editing/cloud_handles.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace offing::present {
namespace {

Screen screen() {
  Screen screen{.camera = {}, .size_px = {800.0, 400.0}};
  screen.camera.eye_m = {300.0, 900.0, 3000.0};
  screen.camera.yaw_rad = -0.15;
  screen.camera.pitch_rad = 0.12;
  screen.camera.width_px = 400;
  screen.camera.height_px = 200;
  return screen;
}

constexpr Sphere ball{{20.0, 1200.0, -100.0}, 150.0};

glm::dvec2 clip_of(const glm::dvec3& place_m) {
  const glm::dvec2 px = *pixel_of(screen(), place_m);
  return {2.0 * px.x / 800.0 - 1.0, 1.0 - 2.0 * px.y / 400.0};
}

glm::dvec3 place_of(CloudHandle handle) {
  for (const CloudHandlePlace& place : cloud_handle_places(screen(), ball)) {
    if (place.handle == handle) return place.place_m;
  }
  throw std::runtime_error("no such handle");
}

// Fails if a handle cannot be taken where it is drawn: one hides another, or its place is not its pixel's.
TEST(CloudHandlesTest, EachCanBeTaken) {
  const std::vector<CloudHandlePlace> places = cloud_handle_places(screen(), ball);
  ASSERT_EQ(places.size(), 8u);
  for (const CloudHandlePlace& place : places) {
    if (place.handle == CloudHandle::z || place.handle == CloudHandle::plane_x) continue;  // toward the eye
    EXPECT_EQ(cloud_handle_at(places, place.place_px + glm::dvec2(3.0, -2.0)), place.handle)
        << static_cast<int>(place.handle);
  }
  EXPECT_FALSE(cloud_handle_at(places, {5.0, 5.0}));
  EXPECT_EQ(cloud_handle_places(screen(), {ball.centre_m, 0.0}).size(), 7u) << "particles have no rim";
}

// The hand goes from where a handle is to where it would be after a way along its axis or in its plane: the
// ball goes that way. Fails if a handle moves what another one does, or not as far as the hand.
TEST(CloudHandlesTest, TheBallFollowsTheHand) {
  const glm::dvec3 way_m(60.0, -45.0, 80.0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 along_m(0.0), in_plane_m = way_m;
    along_m[axis] = way_m[axis];
    in_plane_m[axis] = 0.0;
    const auto arrow = static_cast<CloudHandle>(axis);
    const auto square = static_cast<CloudHandle>(static_cast<int>(CloudHandle::plane_x) + axis);
    for (const auto& [handle, wanted_m] : {std::pair(arrow, along_m), {square, in_plane_m}}) {
      // Squares move in the plane of the ball's middle.
      const glm::dvec3 hand_m = handle == arrow ? place_of(handle) : ball.centre_m;
      const auto pull = cloud_pull(screen(), handle, ball, clip_of(hand_m), clip_of(hand_m + wanted_m), 0.0);
      ASSERT_TRUE(pull) << static_cast<int>(handle);
      EXPECT_LE(glm::distance(pull->way_m, wanted_m), 1e-6) << static_cast<int>(handle);
      EXPECT_EQ(pull->ratio, 1.0);
    }
  }
  const glm::dvec3 beside_m = 70.0 * basis(screen().camera).right - 20.0 * basis(screen().camera).up;
  const auto free = cloud_pull(screen(), CloudHandle::free, ball, clip_of(ball.centre_m),
                               clip_of(ball.centre_m + beside_m), 0.0);
  ASSERT_TRUE(free);
  EXPECT_LE(glm::distance(free->way_m, beside_m), 1e-6);
}

TEST(CloudHandlesTest, TheRimResizes) {
  const glm::dvec3 rim_m = place_of(CloudHandle::radius);
  const auto pull = cloud_pull(screen(), CloudHandle::radius, ball, clip_of(rim_m),
                               clip_of(ball.centre_m + 1.6 * (rim_m - ball.centre_m)), 0.0);
  ASSERT_TRUE(pull);
  EXPECT_NEAR(pull->ratio, 1.6, 1e-9);
  EXPECT_EQ(pull->way_m, glm::dvec3(0.0));
}

// With a step the middle comes to rest at multiples along what moves, and only there; the radius too.
TEST(CloudHandlesTest, SnapsToSteps) {
  const auto along = cloud_pull(screen(), CloudHandle::x, ball, clip_of(ball.centre_m),
                                clip_of(ball.centre_m + glm::dvec3(61.0, 0.0, 0.0)), 50.0);
  ASSERT_TRUE(along);
  EXPECT_NEAR(ball.centre_m.x + along->way_m.x, 100.0, 1e-9);
  EXPECT_EQ(along->way_m.y, 0.0);
  EXPECT_EQ(along->way_m.z, 0.0);
  const glm::dvec3 rim_m = place_of(CloudHandle::radius);
  const auto larger = cloud_pull(screen(), CloudHandle::radius, ball, clip_of(rim_m),
                                 clip_of(ball.centre_m + 1.25 * (rim_m - ball.centre_m)), 50.0);
  ASSERT_TRUE(larger);
  EXPECT_NEAR(larger->ratio * ball.radius_m, 200.0, 1e-9);
  const auto smallest =
      cloud_pull(screen(), CloudHandle::radius, ball, clip_of(rim_m), clip_of(ball.centre_m), 50.0);
  ASSERT_TRUE(smallest);
  EXPECT_NEAR(smallest->ratio * ball.radius_m, 50.0, 1e-9);
}

}  // namespace
}  // namespace offing::present
