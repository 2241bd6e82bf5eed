// Highlights of the C interface: where Blinn has them, and as the world behind it gives them.
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/c/handles.h"
#include "host/c/offing.h"

namespace offing {
namespace {

using testing::HasSubstr;

constexpr const char* scene_with_highlights = R"(version = 1
[camera]
x_m = 1
y_m = 2
z_m = 6
[sun]
azimuth_deg = 200
elevation_deg = 40
[[light]]
name = "key"
azimuth_deg = 120
elevation_deg = 30
[[mesh]]
name = "ball"
shape = "sphere"
size_m = 1.6
detail = 5
x_m = 0.5
y_m = 1
spin_deg_per_s = 40
[[mesh.highlight]]
light = "sun"
texture = "star"
split = 2
[[mesh]]
shape = "box"
highlights = "off"
)";

class HighlightCallsTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(offing_open_device(nullptr, &device_), OFFING_OK) << offing_last_error();
    ASSERT_EQ(offing_parse_scene(scene_with_highlights, nullptr, &scene_), OFFING_OK) << offing_last_error();
    ASSERT_EQ(offing_make_world(device_, scene_, &world_), OFFING_OK) << offing_last_error();
  }
  void TearDown() override {
    offing_free_world(world_);
    offing_free_scene(scene_);
    offing_close_device(device_);
  }

  std::size_t count_of(std::size_t mesh) {
    std::size_t count = 99;
    EXPECT_EQ(offing_count_highlights(world_, mesh, &count), OFFING_OK) << offing_last_error();
    return count;
  }

  OffingDevice* device_ = nullptr;
  OffingScene* scene_ = nullptr;
  OffingWorld* world_ = nullptr;
};

/// Toward a light: azimuth clockwise from north (-z).
glm::dvec3 toward(double azimuth_deg, double elevation_deg) {
  const double azimuth = azimuth_deg * std::numbers::pi / 180.0,
               elevation = elevation_deg * std::numbers::pi / 180.0;
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
          -std::cos(azimuth) * std::cos(elevation)};
}

// Blinn by hand, as tests/cli/highlights_test.cpp has it: on a ball the key light's highlight stands where
// the normal is half way between eye and light, in every frame with the same id. Gate as there. Fails if
// poses or projectors are in other axes or of another time.
TEST_F(HighlightCallsTest, StandWhereBlinnHasThem) {
  ASSERT_EQ(offing_mesh_count(world_), 2u);
  EXPECT_STREQ(offing_mesh_name(world_, 0), "ball");
  EXPECT_STREQ(offing_mesh_name(world_, 9), "");
  EXPECT_EQ(count_of(0), 0u);
  const glm::dvec3 eye(1.0, 2.0, 6.0), middle(0.5, 1.0, 0.0);
  std::uint64_t first_id = 0;
  for (int frame = 0; frame < 3; ++frame) {
    ASSERT_EQ(offing_frame(world_, 0.1 * frame), OFFING_OK);
    ASSERT_EQ(offing_find_highlights(world_, 0.0), OFFING_OK) << offing_last_error();
    const std::size_t count = count_of(0);
    ASSERT_EQ(count, 3u);
    EXPECT_EQ(count_of(1), 0u);
    std::vector<std::uint64_t> id(count);
    std::vector<std::int32_t> rule(count), copy(count), light(count), texture(count);
    std::vector<double> position_m(3 * count), right(3 * count), up(3 * count), normal(3 * count),
        width_m(count), height_m(count), opacity(count), softness(count), colour(3 * count);
    const OffingHighlights highlights{sizeof highlights, id.data(),         rule.data(),     copy.data(),
                                      light.data(),      position_m.data(), right.data(),    up.data(),
                                      normal.data(),     width_m.data(),    height_m.data(), opacity.data(),
                                      texture.data(),    softness.data(),   colour.data()};
    ASSERT_EQ(offing_read_highlights(world_, 0, count, &highlights), OFFING_OK) << offing_last_error();
    OffingMeshPose pose{};
    pose.size = sizeof pose;
    ASSERT_EQ(offing_get_mesh_pose(world_, 0, &pose), OFFING_OK);
    const glm::dquat turn(pose.turn[0], pose.turn[1], pose.turn[2], pose.turn[3]);
    const glm::dvec3 origin_m(pose.position_m[0], pose.position_m[1], pose.position_m[2]);
    int of_key = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto vector = [i](const std::vector<double>& all) {
        return glm::dvec3(all[3 * i], all[3 * i + 1], all[3 * i + 2]);
      };
      EXPECT_GT(opacity[i], 0.0);
      EXPECT_LE(opacity[i], 1.0);
      EXPECT_GT(width_m[i], 0.0);
      EXPECT_GT(height_m[i], 0.0);
      EXPECT_EQ(vector(colour), glm::dvec3(1.0));
      EXPECT_LT(glm::distance(glm::cross(vector(right), vector(up)), vector(normal)), 1e-9);
      EXPECT_EQ(texture[i], light[i] == 1 ? OFFING_TEXTURE_STAR : OFFING_TEXTURE_DOT);
      EXPECT_EQ(rule[i], light[i] == 1 ? 0 : -1);
      if (light[i] != 0) continue;
      ++of_key;
      EXPECT_EQ(copy[i], 0);
      if (frame == 0) first_id = id[i];
      EXPECT_EQ(id[i], first_id);
      const glm::dvec3 place = origin_m + turn * vector(position_m);
      const glm::dvec3 half = glm::normalize(toward(120.0, 30.0) + glm::normalize(eye - place));
      EXPECT_LE(glm::distance(turn * vector(normal), half), 2e-3);
      EXPECT_LE(glm::distance(glm::normalize(place - middle), half), 2e-3);
    }
    EXPECT_EQ(of_key, 1);
  }
}

// Fails if a bad argument is taken, or a call gets into a world that another one is using.
TEST_F(HighlightCallsTest, RefuseBadArguments) {
  EXPECT_EQ(offing_find_highlights(world_, 1.0), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("first_s"));
  EXPECT_EQ(offing_find_highlights(world_, -1e8), OFFING_BAD_INPUT);  // would simulate three years
  EXPECT_EQ(offing_find_highlights(world_, std::nan("")), OFFING_BAD_INPUT);
  EXPECT_EQ(offing_read_highlights(world_, 2, 0, nullptr), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_hint(), HasSubstr("offing_mesh_count"));
  OffingHighlights highlights{};
  highlights.size = sizeof highlights;
  EXPECT_EQ(offing_read_highlights(world_, 0, 5, &highlights), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("expected 0, got 5"));
  const c::Use use(world_, "world");
  EXPECT_EQ(offing_find_highlights(world_, 0.0), OFFING_BUSY);
}

}  // namespace
}  // namespace offing
