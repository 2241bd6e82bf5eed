// What a world with ground shows of it.
#include "host/world/ground_view.h"

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/world/world.h"

namespace offing::world {
namespace {

/// A ridge along z, 100 m high in the middle, of 65 x 33 posts.
GroundParameters ridge() {
  auto map = std::make_shared<HeightMap>();
  map->columns = 65;
  map->rows = 33;
  map->spacing_x_m = 10.0;
  map->spacing_z_m = 20.0;
  for (int row = 0; row < map->rows; ++row) {
    for (int column = 0; column < map->columns; ++column) {
      map->heights_m.push_back(static_cast<float>(100.0 - 3.0 * std::abs(column - 32)));
    }
  }
  return {.map = map, .origin_x_m = -320.0, .origin_z_m = -320.0, .latitude_deg = {}, .lines = {}};
}

class GroundViewTest : public testing::Test {
 protected:
  WorldParameters parameters() const {
    WorldParameters dry;
    dry.has_sea = false;
    dry.ground = ridge();
    return dry;
  }
  Camera camera() const {
    return {
        .eye_m = {-500.0, 150.0, 3.0}, .yaw_rad = 1.5, .pitch_rad = -0.2, .width_px = 61, .height_px = 35};
  }
  ocl::Device device_ = ocl::Device::open();
};

// Fails if planes or image are not of the hits, pixel by pixel.
TEST_F(GroundViewTest, HasPlanesAndImageOfItsHits) {
  World world(device_, parameters());
  world.at(0.0, camera().eye_m.y);
  world.see_ground(camera());
  const GroundView& ground = *world.ground();
  ASSERT_TRUE(ground.is_in_reach());
  const auto hits = ground.hits().read();
  const auto planes = ground.planes().read();
  const auto image = ground.image().read();
  ASSERT_EQ(hits.size(), 61u * 35u);
  ASSERT_EQ(planes.size(), 2 * hits.size());
  ASSERT_EQ(image.size(), hits.size());
  std::size_t seen = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    EXPECT_EQ(planes[i], hits[i].distance_m);
    EXPECT_EQ(planes[hits.size() + i], static_cast<float>(hits[i].steps));
    if (hits[i].kind == TERRAIN_MISS) continue;
    ++seen;
    EXPECT_GT(image[i][1], 0.0f) << "dark at noon";
  }
  EXPECT_GT(seen, hits.size() / 10);
  EXPECT_LT(seen, hits.size());
}

// Fails if the place of the map is lost: height under a point of the world.
TEST_F(GroundViewTest, AnswersInPlacesOfTheWorld) {
  const GroundView ground(device_, ridge());
  EXPECT_NEAR(ground.ground_at(0.0, 0.0)->height_m, 100.0, 1e-9);
  EXPECT_NEAR(ground.ground_at(-100.0, 250.0)->height_m, 70.0, 1e-9);
  EXPECT_FALSE(ground.ground_at(321.0, 0.0));
}

// Fails if an eye too far for rays ends the frame instead of seeing nothing.
TEST_F(GroundViewTest, SeesNothingFromTooFar) {
  World world(device_, parameters());
  Camera far = camera();
  far.eye_m.x = -1e8;
  world.at(0.0, far.eye_m.y);
  EXPECT_NO_THROW(world.see_ground(far));
  EXPECT_FALSE(world.ground()->is_in_reach());
  world.see_ground(camera());
  EXPECT_TRUE(world.ground()->is_in_reach());
}

// Fails if a world without a sea has water, or its ground changes otherwise than a fresh world's would.
TEST_F(GroundViewTest, ChangesAsAFreshWorldHasIt) {
  World world(device_, parameters());
  EXPECT_FALSE(world.has_sea());
  EXPECT_THROW(world.ocean(), Error);
  EXPECT_EQ(world.reach().vertical_m, 0.0);
  GroundParameters changed = ridge();
  changed.lines.snow_line_m = 40.0;
  for (const double origin_z_m : {ridge().origin_z_m, -300.0}) {
    changed.origin_z_m = origin_z_m;
    world.set_ground(changed);
    WorldParameters fresh_parameters = parameters();
    fresh_parameters.ground = changed;
    World fresh(device_, fresh_parameters);
    for (World* one : {&world, &fresh}) {
      one->at(0.0, camera().eye_m.y);
      one->see_ground(camera());
    }
    EXPECT_EQ(world.ground()->image().read(), fresh.ground()->image().read());
  }
  world.set_ground(std::nullopt);
  EXPECT_EQ(world.ground(), nullptr);
  EXPECT_NO_THROW(world.see_ground(camera()));
}

}  // namespace
}  // namespace offing::world
