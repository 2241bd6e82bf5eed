#include "present/editing/highlight_handles.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/highlights/projectors/controlled_projector.h"

namespace offing::present {
namespace {

using highlights::HighlightControls;
using highlights::Projector;

using std::numbers::pi;

Screen screen() {
  Screen screen{.camera = {}, .size_px = {800.0, 400.0}};
  screen.camera.eye_m = {1.0, 2.0, 5.0};
  screen.camera.yaw_rad = 0.1;
  screen.camera.pitch_rad = -0.05;
  screen.camera.width_px = 400;  // drawn at half the window's pixels
  screen.camera.height_px = 200;
  return screen;
}

/// Before the camera, turned a little away from it.
Projector box() {
  Projector box{.width_m = 0.8, .height_m = 0.5};
  box.centre_m = {1.2, 1.9, 1.0};
  box.normal = glm::normalize(glm::dvec3(0.2, 0.1, 1.0));
  box.right = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), box.normal));
  box.up = glm::cross(box.normal, box.right);
  return box;
}

glm::dvec2 clip_of(const Screen& screen, glm::dvec2 px) {
  return {2.0 * px.x / screen.size_px.x - 1.0, 1.0 - 2.0 * px.y / screen.size_px.y};
}

// Pixels of handles lead back to where the handles are in the box's plane. Fails if the picture's rows are
// upside down, or its size is taken for the window's.
TEST(HighlightHandlesTest, PixelsLeadBackToTheBox) {
  const std::vector<HandlePlace> places = handle_places(screen(), box());
  ASSERT_EQ(places.size(), 5u);
  for (const HandlePlace& place : places) {
    const auto found = place_on_plane(screen(), box(), clip_of(screen(), place.place_px));
    ASSERT_TRUE(found);
    const glm::dvec2 half = 0.5 * glm::dvec2(box().width_m, box().height_m);
    if (place.handle == Handle::move) {
      EXPECT_LE(glm::length(*found), 1e-9);
    }
    if (place.handle == Handle::scale) {
      EXPECT_LE(glm::distance(*found, half), 1e-9);
    }
    if (place.handle == Handle::width) {
      EXPECT_LE(glm::distance(*found, {half.x, 0.0}), 1e-9);
    }
    if (place.handle == Handle::height) {
      EXPECT_LE(glm::distance(*found, {0.0, half.y}), 1e-9);
    }
    if (place.handle == Handle::rotate) {
      EXPECT_GT(found->y, half.y);
    }
    EXPECT_EQ(handle_at(places, place.place_px + glm::dvec2(3.0, -2.0)), place.handle);
  }
  EXPECT_FALSE(handle_at(places, {5.0, 5.0}));
}

// What is behind the eye, or seen from the side or from behind, cannot be taken hold of.
TEST(HighlightHandlesTest, NothingIsBehind) {
  Projector behind = box();
  behind.centre_m = {1.0, 2.0, 9.0};
  EXPECT_TRUE(handle_places(screen(), behind).empty());
  Projector away = box();
  away.normal = -away.normal;
  EXPECT_FALSE(place_on_plane(screen(), away, {0.0, 0.0}));
  Projector side = box();
  side.normal = {1.0, 0.0, 0.0};
  side.centre_m = {1.0, 2.0, 1.0};
  EXPECT_FALSE(place_on_plane(screen(), side, {0.2, 0.0}));
}

// A corner pulled from its place to another puts the corner there; the sides' handles change one width each.
TEST(HighlightHandlesTest, SizesFollowTheHand) {
  const HighlightControls controls{.rotation_rad = 0.4, .scale = 1.5, .anisotropy = 0.2, .squareness = 0.3};
  const Projector before = highlights::reshaped(box(), controls);
  const auto after = [&](Handle handle, glm::dvec2 from, glm::dvec2 to) {
    return highlights::reshaped(box(), pulled(controls, handle, from, to));
  };
  const glm::dvec2 half = 0.5 * glm::dvec2(before.width_m, before.height_m);
  const Projector larger = after(Handle::scale, half, 1.7 * half);
  EXPECT_NEAR(larger.width_m, 1.7 * before.width_m, 1e-12);
  EXPECT_NEAR(larger.height_m, 1.7 * before.height_m, 1e-12);
  const Projector wider = after(Handle::width, {half.x, 0.0}, {1.3 * half.x, 0.02});
  EXPECT_NEAR(wider.width_m, 1.3 * before.width_m, 1e-12);
  EXPECT_NEAR(wider.height_m, before.height_m, 1e-12);
  const Projector lower = after(Handle::height, {0.0, half.y}, {0.05, 0.6 * half.y});
  EXPECT_NEAR(lower.width_m, before.width_m, 1e-12);
  EXPECT_NEAR(lower.height_m, 0.6 * before.height_m, 1e-12);
}

// The hand turns the way the highlight turns, the shorter way round, also past the line at half a turn; and
// values stay in their ranges.
TEST(HighlightHandlesTest, TurnsFollowTheHand) {
  const auto turned = [](double from_rad, double to_rad) {
    return pulled({.rotation_rad = 0.5}, Handle::rotate, {std::cos(from_rad), std::sin(from_rad)},
                  2.0 * glm::dvec2(std::cos(to_rad), std::sin(to_rad)))
        .rotation_rad;
  };
  EXPECT_NEAR(turned(0.5 * pi, 0.5 * pi + 0.3), 0.8, 1e-12);
  EXPECT_NEAR(turned(0.9 * pi, -0.9 * pi), 0.5 + 0.2 * pi, 1e-12);
  const HighlightControls extreme = pulled({.scale = 900.0}, Handle::scale, {1.0, 1.0}, {9.0, 9.0});
  EXPECT_EQ(extreme.scale, 1e3);
  EXPECT_LE(pulled({.anisotropy = 0.9}, Handle::width, {0.1, 0.0}, {9.0, 0.0}).anisotropy, 1.0);
  EXPECT_TRUE(std::isfinite(pulled({}, Handle::width, {0.0, 0.0}, {0.0, 0.0}).anisotropy));
}

// On a flat surface, offset axes are those before the rotation: a push along the box's own right of a turned
// highlight goes along that right.
TEST(HighlightHandlesTest, PushesGoAlongTheTurnedBox) {
  const HighlightControls controls{.offset = {0.5, -0.25}, .rotation_rad = 0.7};
  const HighlightControls pushed_on = pushed(controls, box(), {0.12, -0.05});
  const glm::dvec2 half = 0.5 * glm::dvec2(box().width_m, box().height_m);
  const glm::dvec2 way_m = (pushed_on.offset - controls.offset) * half;
  const Projector turned = highlights::reshaped(box(), controls);
  const glm::dvec3 moved_m = way_m.x * box().right + way_m.y * box().up;
  EXPECT_NEAR(glm::dot(moved_m, turned.right), 0.12, 1e-12);
  EXPECT_NEAR(glm::dot(moved_m, turned.up), -0.05, 1e-12);
}

}  // namespace
}  // namespace offing::present
