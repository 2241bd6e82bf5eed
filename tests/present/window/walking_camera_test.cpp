#include "present/window/walking_camera.h"

#include <cmath>
#include <memory>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/terrain/field/terrain_posts.h"
#include "host/terrain/walk/relief_height.h"

namespace offing::present {
namespace {

/// A plane that rises to the east by 1 in 4, 400 m wide, its middle at the origin.
world::TerrainParameters slope() {
  auto map = std::make_shared<HeightMap>();
  map->columns = map->rows = 41;
  map->spacing_x_m = map->spacing_z_m = 10.0;
  for (int row = 0; row < map->rows; ++row) {
    for (int column = 0; column < map->columns; ++column)
      map->heights_m.push_back(2.5f * static_cast<float>(column));
  }
  return {.map = map, .origin_x_m = -200.0, .origin_z_m = -200.0, .latitude_deg = {}, .lines = {}};
}

const terrain::ReliefSettings relief;

/// The ground as it is drawn below an eye that stands on it.
double terrain_m(const glm::dvec3& eye_m) {
  const world::TerrainParameters terrain = slope();
  const double x_m = eye_m.x + 200.0, z_m = eye_m.z + 200.0;
  const double height_m = terrain::terrain_at(*terrain.map, x_m, z_m)->height_m;
  const double relief_m =
      terrain::relief_height_m(terrain.posts(), relief, x_m, z_m, {x_m, height_m + 1.7, z_m});
  EXPECT_NE(relief_m, 0.0);
  return height_m + relief_m;
}

const scene::ViewScene how = [] {
  scene::ViewScene view;
  view.walking_mps = 2.0;
  return view;
}();

// Fails if the eye is not at its height above the ground, wherever it was put.
TEST(WalkingCameraTest, StandsOnTheGround) {
  WalkingCamera walking;
  const world::TerrainParameters terrain = slope();
  Camera camera{.eye_m = {30.0, 900.0, -7.0}};
  ASSERT_TRUE(walking.advance(terrain, relief, how, {}, 0.02, camera));
  EXPECT_NEAR(camera.eye_m.y, terrain_m(camera.eye_m) + 1.7, 1e-9);
  camera.eye_m = {-100.0, -50.0, 60.0};
  ASSERT_TRUE(walking.advance(terrain, relief, how, {}, 0.02, camera));
  EXPECT_NEAR(camera.eye_m.x, -100.0, 1e-9);
  EXPECT_NEAR(camera.eye_m.y, terrain_m(camera.eye_m) + 1.7, 1e-9);
}

// Fails if keys walk another way than the eye looks, pitch slows, or running is as slow as walking.
TEST(WalkingCameraTest, WalksWhereItLooks) {
  const world::TerrainParameters terrain = slope();
  for (const bool is_fast : {false, true}) {
    WalkingCamera walking;
    Camera camera{.yaw_rad = 0.25 * std::numbers::pi, .pitch_rad = -1.2};
    for (int i = 0; i < 100; ++i) {
      ASSERT_TRUE(
          walking.advance(terrain, relief, how, {.move = {0.0, 0.0, 1.0}, .is_fast = is_fast}, 0.01, camera));
    }
    const double way_m = is_fast ? 10.0 : 2.0;
    EXPECT_NEAR(camera.eye_m.x, way_m * std::numbers::sqrt2 / 2.0, 1e-6);
    EXPECT_NEAR(camera.eye_m.z, -way_m * std::numbers::sqrt2 / 2.0, 1e-6);
    EXPECT_NEAR(camera.eye_m.y, terrain_m(camera.eye_m) + 1.7, 1e-6);
  }
}

// Fails if a camera beyond the ground is moved, or the walk throws there.
TEST(WalkingCameraTest, DoesNotWalkBeyondTheGround) {
  WalkingCamera walking;
  Camera camera{.eye_m = {201.0, 30.0, 0.0}};
  EXPECT_FALSE(walking.advance(slope(), relief, how, {.move = {1.0, 0.0, 0.0}}, 0.1, camera));
  EXPECT_EQ(camera.eye_m, glm::dvec3(201.0, 30.0, 0.0));
}

}  // namespace
}  // namespace offing::present
