// Rays, axes, planes and spheres on a screen, against their definitions.
#include "present/editing/handle_geometry.h"

#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace offing::present {
namespace {

Screen screen() {
  Screen screen{.camera = {}, .size_px = {800.0, 400.0}};
  screen.camera.eye_m = {100.0, 200.0, 3000.0};
  screen.camera.yaw_rad = 0.2;
  screen.camera.pitch_rad = 0.1;
  screen.camera.width_px = 400;
  screen.camera.height_px = 200;
  return screen;
}

glm::dvec2 clip_of(glm::dvec2 px) {
  return {2.0 * px.x / 800.0 - 1.0, 1.0 - 2.0 * px.y / 400.0};
}

class HandleGeometryTest : public testing::Test {
 protected:
  glm::dvec3 vector(double reach) {
    std::uniform_real_distribution<double> along(-reach, reach);
    return {along(random_), along(random_), along(random_)};
  }
  glm::dvec3 unit() { return glm::normalize(vector(1.0)); }
  Ray ray() { return {vector(1000.0), unit()}; }

  std::mt19937 random_{3};
};

// Fails if the picture is upside down or stretched: a ray through the pixel of a place passes it.
TEST_F(HandleGeometryTest, RaysGoThroughTheirPixels) {
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 place_m = vector(500.0);
    const auto px = pixel_of(screen(), place_m);
    ASSERT_TRUE(px);
    const Ray ray = ray_at(screen(), clip_of(*px));
    EXPECT_NEAR(*miss_of(ray, {place_m, 1.0}), 0.0, 1e-8);
    EXPECT_LE(glm::distance(pixel_of_clip(screen(), clip_of(*px)), *px), 1e-9);
  }
}

// Fails if a pixel's width is that of another depth: a place one pixel's width beside another one is drawn
// a pixel beside it. Off the middle of a plane at one depth this is exact; bound 1e-6 px by rounding.
TEST_F(HandleGeometryTest, PixelsAreAsWideAsTheyAre) {
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 place_m = vector(500.0);
    const glm::dvec3 beside_m = place_m + pixel_m(screen(), place_m) * basis(screen().camera).right;
    EXPECT_NEAR(pixel_of(screen(), beside_m)->x - pixel_of(screen(), place_m)->x, 1.0, 1e-6);
  }
}

// The way between the nearest points is at right angles to both lines: what defines them.
TEST_F(HandleGeometryTest, NearestPointsOfAxes) {
  for (int i = 0; i < 200; ++i) {
    const Ray ray = this->ray();
    const glm::dvec3 place_m = vector(1000.0), axis = unit();
    const auto along_m = along_axis(ray, place_m, axis);
    if (!along_m) continue;
    const glm::dvec3 on_axis_m = place_m + *along_m * axis;
    const double on_ray_m = glm::dot(on_axis_m - ray.origin_m, ray.direction);
    const glm::dvec3 way_m = ray.origin_m + on_ray_m * ray.direction - on_axis_m;
    EXPECT_NEAR(glm::dot(way_m, axis), 0.0, 1e-6);
  }
  const Ray ray = this->ray();
  EXPECT_FALSE(along_axis(ray, vector(10.0), ray.direction));
  EXPECT_FALSE(along_axis(ray, vector(10.0), -ray.direction));
}

TEST_F(HandleGeometryTest, PlanesAreMetAhead) {
  int met = 0;
  for (int i = 0; i < 200; ++i) {
    const Ray ray = this->ray();
    const glm::dvec3 place_m = vector(1000.0), normal = unit();
    const auto point_m = on_plane(ray, place_m, normal);
    const double slope = glm::dot(ray.direction, normal);
    const bool is_ahead = glm::dot(place_m - ray.origin_m, normal) / slope > 0.0;
    EXPECT_EQ(point_m.has_value(), is_ahead && std::abs(slope) >= 0.05);
    if (!point_m) continue;
    ++met;
    EXPECT_NEAR(glm::dot(*point_m - place_m, normal), 0.0, 1e-6);
    EXPECT_NEAR(glm::length(glm::cross(*point_m - ray.origin_m, ray.direction)), 0.0, 1e-6);
  }
  EXPECT_GT(met, 50);
}

// Rays to the outline touch the sphere: they miss its middle by just its radius. Fails if the outline is that
// of the middle's depth, which is too small near the eye.
TEST_F(HandleGeometryTest, OutlinesTouch) {
  const glm::dvec3 eye_m(10.0, 20.0, 30.0);
  for (const double distance_m : {1.01, 2.0, 50.0}) {
    const Sphere sphere{eye_m + distance_m * 40.0 * unit(), 40.0};
    const std::vector<glm::dvec3> points = outline_of(sphere, eye_m, 24);
    ASSERT_EQ(points.size(), 24u);
    for (const glm::dvec3& point_m : points) {
      EXPECT_NEAR(*miss_of({eye_m, glm::normalize(point_m - eye_m)}, sphere), 1.0, 1e-9);
      EXPECT_NEAR(glm::distance(point_m, sphere.centre_m), 40.0, 1e-9);
    }
  }
  EXPECT_TRUE(outline_of({eye_m, 5.0}, eye_m + 1.0, 24).empty());
}

TEST_F(HandleGeometryTest, SpheresBehindAreNotMet) {
  EXPECT_FALSE(miss_of({{0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}}, {{0.0, 0.0, 5.0}, 10.0}));
}

TEST_F(HandleGeometryTest, Steps) {
  EXPECT_EQ(snapped(74.0, 50.0), 50.0);
  EXPECT_EQ(snapped(-76.0, 50.0), -100.0);
  EXPECT_EQ(snapped(74.3, 0.0), 74.3);
}

}  // namespace
}  // namespace offing::present
