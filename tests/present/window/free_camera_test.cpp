#include "present/window/free_camera.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace offing::present {
namespace {

Camera start() {
  return {.eye_m = {1.0, 5.0, -2.0}, .yaw_rad = 0.4, .pitch_rad = -0.1, .width_px = 640, .height_px = 360};
}

double calm(double, double) {
  return 0.0;
}

// Fails if keys move along other axes than the picture's, or by another speed.
TEST(FreeCameraTest, FliesWhereItLooks) {
  FreeCamera camera(start());
  const CameraBasis axes = basis(start());
  camera.advance({.move = {0.0, 0.0, 1.0}}, 0.5, calm);
  glm::dvec3 moved = camera.camera().eye_m - start().eye_m;
  EXPECT_NEAR(glm::distance(moved, 0.5 * camera.speed_mps() * axes.forward), 0.0, 1e-12);
  camera.reset();
  camera.advance({.move = {-1.0, 0.0, 0.0}, .is_fast = true}, 0.5, calm);
  moved = camera.camera().eye_m - start().eye_m;
  EXPECT_NEAR(glm::distance(moved, -5.0 * 0.5 * camera.speed_mps() * axes.right), 0.0, 1e-12);
}

// Fails if the picture does not follow the mouse, or the head turns over.
TEST(FreeCameraTest, TurnsWithTheMouse) {
  FreeCamera camera(start());
  const double view_rad = start().vertical_field_of_view_rad;
  camera.advance({.turn = {0.1, -0.05}}, 0.0, calm);
  EXPECT_NEAR(camera.camera().yaw_rad, 0.4 + 0.1 * view_rad, 1e-12);
  EXPECT_NEAR(camera.camera().pitch_rad, -0.1 + 0.05 * view_rad, 1e-12);
  camera.camera().height_px = 36;
  camera.advance({.turn = {0.0, 0.05}}, 0.0, calm);
  EXPECT_NEAR(camera.camera().pitch_rad, -0.1, 1e-12) << "coarse pictures turn alike";
  camera.advance({.turn = {0.0, 1e6}}, 0.0, calm);
  EXPECT_EQ(camera.camera().pitch_rad, -0.5 * std::numbers::pi);
}

// Fails if the eye dives: it flies over crests, and down into troughs.
TEST(FreeCameraTest, StaysAboveTheWater) {
  FreeCamera camera(start());
  camera.advance({.move = {0.0, -1.0, 0.0}}, 1000.0, calm);
  EXPECT_NEAR(camera.camera().eye_m.y, 0.2, 1e-12);
  camera.advance({.move = {1.0, 0.0, 0.0}}, 0.1, [](double x_m, double) { return x_m > 1.5 ? 7.0 : 0.0; });
  EXPECT_NEAR(camera.camera().eye_m.y, 7.2, 1e-12) << "below a crest";
  camera.advance({.move = {0.0, -1.0, 0.0}}, 1000.0, [](double, double) { return -3.0; });
  EXPECT_GT(camera.camera().eye_m.y, 0.0);
  EXPECT_NO_THROW(require_valid(camera.camera()));
}

// Fails if a ball is not whole and in the middle of the picture, or the eye gets under the ground.
TEST(FreeCameraTest, LooksAtAll) {
  FreeCamera camera(start());
  const glm::dvec3 middle_m(300.0, 40.0, -90.0);
  for (const double ground_m : {0.0, 55.0}) {
    camera.look_at(middle_m, 12.0, [&](double, double) { return ground_m; });
    const Camera& now = camera.camera();
    const glm::dvec3 way_m = middle_m - now.eye_m;
    EXPECT_NEAR(glm::dot(glm::normalize(way_m), basis(now).forward), 1.0, 1e-12);
    EXPECT_LT(12.0, glm::length(way_m) * std::sin(0.5 * now.vertical_field_of_view_rad));
    EXPECT_LT(glm::length(way_m), 100.0);
    EXPECT_GT(now.eye_m.y, ground_m);
  }
}

// Fails if a boat is seen along the water, or not in the middle of what panels leave free.
TEST(FreeCameraTest, LooksBesidePanelsAndFromAbove) {
  FreeCamera camera(start());
  const glm::dvec3 boat_m(30.0, 0.0, -90.0);
  camera.look_at(boat_m, 8.0, calm, {.left = -0.2, .right = 1.0});
  const Camera& now = camera.camera();
  const glm::dvec3 way_m = boat_m - now.eye_m;
  EXPECT_GT(now.eye_m.y, 0.25 * glm::length(way_m));
  const CameraBasis axes = basis(now);
  const double ahead_m = glm::dot(way_m, axes.forward), tangent = half_extent(now).x;
  EXPECT_NEAR(glm::dot(way_m, axes.right) / (ahead_m * tangent), 0.4, 0.04);
  EXPECT_NEAR(glm::dot(way_m, axes.up) / ahead_m, 0.0, 0.05);
  EXPECT_LT(8.0 / (ahead_m * tangent), 0.6) << "it is as wide as what is free";
}

// Fails if a camera that nobody moves is not where its scene has it, as in pictures without a window.
TEST(FreeCameraTest, StaysWhereItIs) {
  Camera low = start();
  low.eye_m = {4e6, 0.05, -3.0};
  FreeCamera camera(low);
  camera.advance({.turn = {0.03, 0.01}, .wheel = 1.0}, 1.0, [](double, double) { return 5.0; });
  EXPECT_EQ(camera.camera().eye_m, low.eye_m);
}

// Fails if the eye flies where no scene file may have it: it could not be saved.
TEST(FreeCameraTest, StaysWhereScenesAre) {
  FreeCamera camera(start());
  for (const glm::dvec3 way : {glm::dvec3(1.0, 1.0, 0.0), glm::dvec3(-1.0, 0.0, 1.0)}) {
    camera.advance({.move = way}, 1e9, calm);
    EXPECT_LE(std::abs(camera.camera().eye_m.x), 1e7);
    EXPECT_LE(std::abs(camera.camera().eye_m.z), 1e7);
    EXPECT_LE(camera.camera().eye_m.y, 50e3);
  }
}

// Fails if the wheel does not change the speed, or without end.
TEST(FreeCameraTest, ChangesSpeedWithTheWheel) {
  FreeCamera camera(start());
  const double before_mps = camera.speed_mps();
  camera.advance({.wheel = 1.0}, 0.0, calm);
  EXPECT_GT(camera.speed_mps(), before_mps);
  camera.advance({.wheel = -1000.0}, 0.0, calm);
  EXPECT_GT(camera.speed_mps(), 0.0);
}

// Fails if the way home forgets the window's size, which belongs to the window.
TEST(FreeCameraTest, ReturnsToItsStart) {
  FreeCamera camera(start());
  camera.camera().width_px = 99;
  camera.advance({.move = {1.0, 1.0, 1.0}, .turn = {0.05, 0.05}}, 3.0, calm);
  camera.reset();
  EXPECT_EQ(camera.camera().eye_m, start().eye_m);
  EXPECT_EQ(camera.camera().yaw_rad, start().yaw_rad);
  EXPECT_EQ(camera.camera().width_px, 99);
}

}  // namespace
}  // namespace offing::present
