// Handles of objects: where they are, and what a pull of each comes to.
#include "present/editing/objects/object_handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

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

glm::dvec3 place_of(ObjectHandle handle) {
  for (const ObjectHandlePlace& place : object_handle_places(screen(), ball, sphere_handles())) {
    if (place.handle == handle) return place.place_m;
  }
  throw std::runtime_error("no such handle");
}

// Fails if a handle cannot be taken where it is drawn: one hides another, or its place is not its pixel's.
TEST(ObjectHandlesTest, EachCanBeTaken) {
  const std::vector<ObjectHandlePlace> places = object_handle_places(screen(), ball, sphere_handles());
  ASSERT_EQ(places.size(), 8u);
  for (const ObjectHandlePlace& place : places) {
    if (place.handle == ObjectHandle::z || place.handle == ObjectHandle::plane_x) continue;  // toward the eye
    EXPECT_EQ(object_handle_at(places, place.place_px + glm::dvec2(3.0, -2.0)), place.handle)
        << static_cast<int>(place.handle);
  }
  EXPECT_FALSE(object_handle_at(places, {5.0, 5.0}));
  EXPECT_EQ(object_handle_places(screen(), ball, place_handles()).size(), 7u);
}

// Fails if the help on a handle is that of another one.
TEST(ObjectHandlesTest, HelpSaysWhatEachDoes) {
  std::set<std::string> helps;
  for (const ObjectHandle handle : mesh_handles()) helps.insert(handle_help(handle));
  EXPECT_EQ(helps.size(), mesh_handles().size());
  EXPECT_EQ(handle_help(ObjectHandle::y), "drag: move along y (up)\nCtrl: in steps");
  EXPECT_EQ(handle_help(ObjectHandle::plane_y), "drag: move along x and z (level)\nCtrl: in steps");
  EXPECT_EQ(handle_help(ObjectHandle::turn_z), "drag: turn about z (south)\nCtrl: in steps of 15 degrees");
}

// The hand goes from where a handle is to where it would be after a way along its axis or in its plane: the
// ball goes that way. Fails if a handle moves what another one does, or not as far as the hand.
TEST(ObjectHandlesTest, TheBallFollowsTheHand) {
  const glm::dvec3 way_m(60.0, -45.0, 80.0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 along_m(0.0), in_plane_m = way_m;
    along_m[axis] = way_m[axis];
    in_plane_m[axis] = 0.0;
    const auto arrow = static_cast<ObjectHandle>(axis);
    const auto square = static_cast<ObjectHandle>(static_cast<int>(ObjectHandle::plane_x) + axis);
    for (const auto& [handle, wanted_m] : {std::pair(arrow, along_m), {square, in_plane_m}}) {
      // Squares move in the plane of the ball's middle.
      const glm::dvec3 hand_m = handle == arrow ? place_of(handle) : ball.centre_m;
      const auto pull = object_pull(screen(), handle, ball, clip_of(hand_m), clip_of(hand_m + wanted_m), {});
      ASSERT_TRUE(pull) << static_cast<int>(handle);
      EXPECT_LE(glm::distance(pull->way_m, wanted_m), 1e-6) << static_cast<int>(handle);
      EXPECT_EQ(pull->ratio, 1.0);
    }
  }
  const glm::dvec3 beside_m = 70.0 * basis(screen().camera).right - 20.0 * basis(screen().camera).up;
  const auto free = object_pull(screen(), ObjectHandle::free, ball, clip_of(ball.centre_m),
                                clip_of(ball.centre_m + beside_m), {});
  ASSERT_TRUE(free);
  EXPECT_LE(glm::distance(free->way_m, beside_m), 1e-6);
}

// A hand that goes a quarter around a ring turns by a quarter about its axis, and about no other. Fails if
// the sense is that of another one, or the ring cannot be taken where it is drawn.
TEST(ObjectHandlesTest, RingsTurn) {
  const std::vector<ObjectHandlePlace> places = object_handle_places(screen(), ball, mesh_handles());
  for (int axis = 0; axis < 3; ++axis) {
    const auto ring = static_cast<ObjectHandle>(static_cast<int>(ObjectHandle::turn_x) + axis);
    const auto first = std::ranges::find(places, ring, &ObjectHandlePlace::handle);
    ASSERT_NE(first, places.end());
    const std::ptrdiff_t count = std::ranges::count(places, ring, &ObjectHandlePlace::handle);
    ASSERT_EQ(count % 4, 0);
    EXPECT_EQ(object_handle_at({first, first + count}, first->place_px), ring);
    const glm::dvec3 from_m = first->place_m, to_m = (first + count / 4)->place_m;
    const auto pull = object_pull(screen(), ring, ball, clip_of(from_m), clip_of(to_m), {});
    ASSERT_TRUE(pull) << axis;
    glm::dvec3 wanted(0.0);
    wanted[axis] = 0.5 * std::numbers::pi;
    EXPECT_LE(glm::distance(pull->turn_rad, wanted), 1e-9) << axis;
    const auto snapped = object_pull(screen(), ring, ball, clip_of(from_m), clip_of((first + 5)->place_m),
                                     {.turn_rad = std::numbers::pi / 6.0});
    ASSERT_TRUE(snapped);
    EXPECT_NEAR(snapped->turn_rad[axis], std::numbers::pi / 6.0, 1e-9) << "of 37.5 degrees";
  }
}

TEST(ObjectHandlesTest, TheRimResizes) {
  const glm::dvec3 rim_m = place_of(ObjectHandle::radius);
  const auto pull = object_pull(screen(), ObjectHandle::radius, ball, clip_of(rim_m),
                                clip_of(ball.centre_m + 1.6 * (rim_m - ball.centre_m)), {});
  ASSERT_TRUE(pull);
  EXPECT_NEAR(pull->ratio, 1.6, 1e-9);
  EXPECT_EQ(pull->way_m, glm::dvec3(0.0));
}

// A square's handle is where its side crosses the middle of the picture: from within the square, from
// outside, and for a flat look at a far side. Fails if it is elsewhere, or the side does not follow the hand.
TEST(ObjectHandlesTest, SidesOfSquaresAreSeenAndResize) {
  struct View {
    glm::dvec3 eye_m;
    double yaw_rad;
    Sphere square;
  };
  for (const View& view : {View{{30.0, 8.0, -20.0}, 0.4, {{0.0, 0.0, 0.0}, 60.0}},
                           {{30.0, 8.0, -20.0}, 2.9, {{0.0, 0.0, 0.0}, 60.0}},
                           {{-5.0, 8.0, 300.0}, 0.05, {{0.0, 0.0, 0.0}, 60.0}},
                           {{900.0, 5.0, 100.0}, -1.5, {{500.0, 1500.0, 0.0}, 9000.0}}}) {
    Screen look = screen();
    look.camera.eye_m = view.eye_m;
    look.camera.yaw_rad = view.yaw_rad;
    look.camera.pitch_rad = 0.0;
    const auto places = object_handle_places(look, view.square, square_handles());
    const auto side = std::ranges::find(places, ObjectHandle::side, &ObjectHandlePlace::handle);
    ASSERT_NE(side, places.end());
    EXPECT_NEAR(side->place_px.x, 400.0, 1e-6);
    EXPECT_GT(side->place_px.y, 0.0);
    EXPECT_LT(side->place_px.y, 400.0);
    EXPECT_EQ(object_handle_at(places, side->place_px), ObjectHandle::side);
    const glm::dvec3 middle_m = view.square.centre_m, way_m = side->place_m - middle_m;
    EXPECT_NEAR(std::max(std::abs(way_m.x), std::abs(way_m.z)), view.square.radius_m, 1e-6);
    const auto clip_at = [&](const glm::dvec3& place_m) {
      const glm::dvec2 px = *pixel_of(look, place_m);
      return glm::dvec2(2.0 * px.x / 800.0 - 1.0, 1.0 - 2.0 * px.y / 400.0);
    };
    const auto pull = object_pull(look, ObjectHandle::side, view.square, clip_at(side->place_m),
                                  clip_at(middle_m + 1.5 * way_m), {});
    ASSERT_TRUE(pull);
    EXPECT_NEAR(pull->ratio, 1.5, 1e-6);
    EXPECT_EQ(pull->way_m, glm::dvec3(0.0));
  }
  // The eye looks past it.
  Screen past = screen();
  past.camera.yaw_rad = 1.0;
  const auto places = object_handle_places(past, {{0.0, 0.0, -4000.0}, 60.0}, square_handles());
  EXPECT_TRUE(std::ranges::all_of(places, [](const auto& place) { return std::isfinite(place.place_px.x); }));
}

// With a step the middle comes to rest at multiples along what moves, and only there; the radius too.
TEST(ObjectHandlesTest, SnapsToSteps) {
  const auto along = object_pull(screen(), ObjectHandle::x, ball, clip_of(ball.centre_m),
                                 clip_of(ball.centre_m + glm::dvec3(61.0, 0.0, 0.0)), {.way_m = 50.0});
  ASSERT_TRUE(along);
  EXPECT_NEAR(ball.centre_m.x + along->way_m.x, 100.0, 1e-9);
  EXPECT_EQ(along->way_m.y, 0.0);
  EXPECT_EQ(along->way_m.z, 0.0);
  const glm::dvec3 rim_m = place_of(ObjectHandle::radius);
  const auto larger = object_pull(screen(), ObjectHandle::radius, ball, clip_of(rim_m),
                                  clip_of(ball.centre_m + 1.25 * (rim_m - ball.centre_m)), {.way_m = 50.0});
  ASSERT_TRUE(larger);
  EXPECT_NEAR(larger->ratio * ball.radius_m, 200.0, 1e-9);
  const auto smallest = object_pull(screen(), ObjectHandle::radius, ball, clip_of(rim_m),
                                    clip_of(ball.centre_m), {.way_m = 50.0});
  ASSERT_TRUE(smallest);
  EXPECT_NEAR(smallest->ratio * ball.radius_m, 50.0, 1e-9);
}

}  // namespace
}  // namespace offing::present
