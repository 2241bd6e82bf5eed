// Clouds of the C interface against those of the world behind it.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/c/handles.h"
#include "host/c/offing.h"
#include "tests/c/watcher.h"

namespace offing {
namespace {

using testing::HasSubstr;

/// One ball of 80 m radius, 500 m north of the origin and 300 m up.
constexpr const char* scene_with_a_cloud = R"(version = 1
[sun]
azimuth_deg = 150
elevation_deg = 40
[camera]
y_m = 300
yaw_deg = 10
pitch_deg = 1
fov_deg = 50
[[cloud]]
genus = "cumulus"
modelling = "sampled"
target_particles = 60
extinction_per_m = 0.05
noise_blend = 0
drag_s = 0
y_m = 300
z_m = -500
[[cloud.ball]]
radius_m = 80
)";
constexpr int width_px = 48, height_px = 32;
constexpr std::size_t pixels = std::size_t{width_px} * height_px;

class CloudCallsTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(offing_open_device(nullptr, &device_), OFFING_OK) << offing_last_error();
    ASSERT_EQ(offing_parse_scene(scene_with_a_cloud, nullptr, &scene_), OFFING_OK)
        << offing_last_error() << offing_last_hint();
    ASSERT_EQ(offing_make_world(device_, scene_, &world_), OFFING_OK) << offing_last_error();
  }
  void TearDown() override {
    offing_free_world(world_);
    offing_free_scene(scene_);
    offing_close_device(device_);
  }

  /// Straight at the ball.
  static OffingCamera camera() {
    OffingCamera camera{};
    camera.size = sizeof camera;
    camera.eye_m[1] = 300.0;
    camera.vertical_field_of_view_rad = 0.6;
    camera.width_px = width_px;
    camera.height_px = height_px;
    return camera;
  }

  OffingDevice* device_ = nullptr;
  OffingScene* scene_ = nullptr;
  OffingWorld* world_ = nullptr;
};

/// A cloud that grows level by level, and so reports many shares.
class GrowingCloudTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string text = scene_with_a_cloud;
    const std::string sampled = "modelling = \"sampled\"\ntarget_particles = 60";
    text.replace(text.find(sampled), sampled.size(), "modelling = \"hierarchical\"");
    ASSERT_EQ(offing_open_device(nullptr, &device_), OFFING_OK) << offing_last_error();
    ASSERT_EQ(offing_parse_scene(text.c_str(), nullptr, &scene_), OFFING_OK)
        << offing_last_error() << offing_last_hint();
  }
  void TearDown() override {
    offing_free_scene(scene_);
    offing_close_device(device_);
  }

  /// nullptr where the call was stopped.
  OffingWorld* make(const Watcher* watcher, OffingStatus expected) {
    OffingWorldOptions options{};
    options.size = sizeof options;
    options.progress = watcher == nullptr ? nullptr : watcher->progress();
    OffingWorld* world = nullptr;
    EXPECT_EQ(offing_make_world_with(device_, scene_, &options, &world), expected) << offing_last_error();
    return world;
  }
  static std::vector<double> places_m(OffingWorld* world) {
    const std::size_t count = offing_cloud_particle_count(world);
    std::vector<double> place_m(3 * count);
    OffingCloudParticles particles{};
    particles.size = sizeof particles;
    particles.place_m = place_m.data();
    EXPECT_EQ(offing_read_cloud_particles(world, count, &particles), OFFING_OK) << offing_last_error();
    return place_m;
  }

  OffingDevice* device_ = nullptr;
  OffingScene* scene_ = nullptr;
};

// Fails if a world that is watched is another one, its clouds grow unseen, or shares do not rise from 0 to 1.
TEST_F(GrowingCloudTest, GrowsUnderTheEyesOfACallback) {
  const Watcher watcher;
  OffingWorld* const watched = make(&watcher, OFFING_OK);
  OffingWorld* const unwatched = make(nullptr, OFFING_OK);
  const std::vector<double>& shares = watcher.shares();
  ASSERT_GT(shares.size(), 10u);
  EXPECT_EQ(shares.front(), 0.0);
  EXPECT_EQ(shares.back(), 1.0);
  EXPECT_EQ(std::adjacent_find(shares.begin(), shares.end(), std::greater_equal<>()), shares.end());
  EXPECT_FALSE(places_m(watched).empty());
  EXPECT_EQ(places_m(watched), places_m(unwatched));
  offing_free_world(unwatched);
  offing_free_world(watched);
}

// Fails if a world that a callback watches spends minutes on clouds before it shows anything. The particles
// take 8 s here; what is tried to know it, one.
TEST_F(GrowingCloudTest, RefusesCloudsThatTakeLong) {
  offing_free_scene(scene_);
  scene_ = nullptr;
  std::string text = scene_with_a_cloud;
  const std::string few = "target_particles = 60";
  text.replace(text.find(few), few.size(), "target_particles = 40001");
  ASSERT_EQ(offing_parse_scene(text.c_str(), nullptr, &scene_), OFFING_OK) << offing_last_error();
  const char* const usual = std::getenv("OFFING_LONGEST_WAIT_S");
  const std::string before = usual == nullptr ? "" : usual;
  setenv("OFFING_LONGEST_WAIT_S", "0.5", 1);
  const Watcher watcher;
  EXPECT_EQ(make(&watcher, OFFING_BAD_INPUT), nullptr);
  EXPECT_THAT(offing_last_error(), HasSubstr("40001 particles would take"));
  EXPECT_THAT(offing_last_hint(), HasSubstr("OFFING_LONGEST_WAIT_S="));
  usual == nullptr ? unsetenv("OFFING_LONGEST_WAIT_S") : setenv("OFFING_LONGEST_WAIT_S", before.c_str(), 1);
}

// Fails if a start goes on after the callback asked to stop, makes a world all the same, or leaves the device
// or the scene unusable.
TEST_F(GrowingCloudTest, StopsWhenAsked) {
  for (const double share : {0.0, 0.5, 1.0}) {
    const Watcher watcher(share);
    EXPECT_EQ(make(&watcher, OFFING_CANCELLED), nullptr);
    const std::vector<double>& shares = watcher.shares();
    EXPECT_EQ(std::count_if(shares.begin(), shares.end(), [&](double at) { return at >= share; }), 1);
  }
  OffingWorld* const world = make(nullptr, OFFING_OK);
  EXPECT_FALSE(places_m(world).empty());
  offing_free_world(world);
}

// Fails if an array is filled from another quantity, or places are not those of the world.
TEST_F(CloudCallsTest, ReadParticles) {
  EXPECT_EQ(offing_cloud_count(world_), 1u);
  EXPECT_EQ(offing_cloud_count(nullptr), 0u);
  const std::size_t count = offing_cloud_particle_count(world_);
  ASSERT_GT(count, 10u);
  std::vector<double> place_m(3 * count);
  std::vector<float> radius_m(count), mass_m2(count), albedo(3 * count);
  std::vector<std::uint32_t> cloud(count, 7), id(count);
  const OffingCloudParticles particles{sizeof particles, place_m.data(), radius_m.data(), mass_m2.data(),
                                       albedo.data(),    cloud.data(),   id.data()};
  ASSERT_EQ(offing_read_cloud_particles(world_, count, &particles), OFFING_OK) << offing_last_error();
  const world::WorldClouds& clouds = *world_->world.clouds();
  const std::vector<CloudParticle> due = clouds.particles().read();
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(place_m[3 * i + 2], clouds.sky_origin_m().z + double{due[i].z});
    EXPECT_LT(std::abs(place_m[3 * i + 2] + 500.0), 90.0);
    EXPECT_EQ(radius_m[i], due[i].radius);
    EXPECT_EQ(mass_m2[i], due[i].optical_mass);
    EXPECT_EQ(albedo[3 * i + 1], due[i].green);
    EXPECT_EQ(cloud[i], 0u);
    EXPECT_EQ(id[i], due[i].id);
  }
}

// A ball's extinction is that of its look in the middle and none at its rim. Particles spread it: within a
// third. Fails if extinction is of another place, or kept beyond its frame or its cells.
TEST_F(CloudCallsTest, SamplesExtinction) {
  const std::vector<double> points_m{0.0, 300.0, -500.0, 0.0, 300.0, 0.0};
  std::array<double, 2> fine{}, coarse{};
  ASSERT_EQ(offing_sample_clouds(world_, 5.0, points_m.data(), 2, fine.data()), OFFING_OK)
      << offing_last_error();
  EXPECT_NEAR(fine[0], 0.05, 0.017);
  EXPECT_EQ(fine[1], 0.0);
  ASSERT_EQ(offing_sample_clouds(world_, 40.0, points_m.data(), 2, coarse.data()), OFFING_OK);
  EXPECT_NE(coarse[0], fine[0]);
  std::array<double, 2> again{};
  ASSERT_EQ(offing_sample_clouds(world_, 5.0, points_m.data(), 2, again.data()), OFFING_OK);
  EXPECT_EQ(again, fine);
}

// Fails if rows lie upside down, the camera is another one, or channels are mixed up.
TEST_F(CloudCallsTest, DrawPictures) {
  OffingCamera seen_by = camera();
  std::vector<float> rgba(4 * pixels), distance_m(pixels);
  ASSERT_EQ(offing_draw_clouds(world_, &seen_by, rgba.data(), distance_m.data(), pixels), OFFING_OK)
      << offing_last_error();
  const std::size_t middle = std::size_t{width_px} * (height_px / 2) + width_px / 2;
  EXPECT_GT(rgba[4 * middle + 3], 0.9f);
  EXPECT_LE(rgba[4 * middle + 3], 1.0f);
  EXPECT_GT(rgba[4 * middle], 0.5f);
  EXPECT_GT(distance_m[middle], 410.0f);
  EXPECT_LT(distance_m[middle], 500.0f);
  EXPECT_EQ(rgba[3], 0.0f);
  EXPECT_EQ(distance_m[0], 0.0f);
  // Looking up, the ball sinks to the lower half.
  seen_by.pitch_rad = 0.25;
  ASSERT_EQ(offing_draw_clouds(world_, &seen_by, rgba.data(), nullptr, pixels), OFFING_OK);
  const auto opacity_of_half = [&](std::size_t first_row) {
    float sum = 0.0f;
    for (std::size_t i = 0; i < pixels / 2; ++i) sum += rgba[4 * (first_row * width_px + i) + 3];
    return sum;
  };
  EXPECT_GT(opacity_of_half(height_px / 2), 10.0f);
  EXPECT_LT(opacity_of_half(0), 0.01f * opacity_of_half(height_px / 2));
}

// Fails if the camera is not that of the scene.
TEST_F(CloudCallsTest, TellTheCamera) {
  OffingCamera found{};
  found.size = sizeof found;
  ASSERT_EQ(offing_get_camera(world_, &found), OFFING_OK);
  EXPECT_EQ(found.eye_m[1], 300.0);
  EXPECT_NEAR(found.yaw_rad, 10.0 * 3.14159265358979 / 180.0, 1e-9);
  EXPECT_NEAR(found.vertical_field_of_view_rad, 50.0 * 3.14159265358979 / 180.0, 1e-9);
}

// Fails if a bad argument is taken, or a call gets into a world that another one is using.
TEST_F(CloudCallsTest, RefuseBadArguments) {
  OffingCamera seen_by = camera();
  std::vector<float> rgba(4 * pixels);
  EXPECT_EQ(offing_draw_clouds(world_, &seen_by, rgba.data(), nullptr, 5), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("expected 1536, got 5"));
  EXPECT_EQ(offing_draw_clouds(world_, nullptr, rgba.data(), nullptr, pixels), OFFING_BAD_INPUT);
  seen_by.vertical_field_of_view_rad = 0.0;
  EXPECT_EQ(offing_draw_clouds(world_, &seen_by, rgba.data(), nullptr, pixels), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("vertical_field_of_view_rad"));
  seen_by = camera();
  seen_by.width_px = 16385;
  EXPECT_EQ(offing_draw_clouds(world_, &seen_by, rgba.data(), nullptr, pixels), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("[1, 16384]"));
  const double point_m[3] = {0.0, 0.0, 0.0};
  double extinction_per_m = 0.0;
  EXPECT_EQ(offing_sample_clouds(world_, 0.0, point_m, 1, &extinction_per_m), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("cell_m"));
  EXPECT_EQ(offing_sample_clouds(world_, 1e-3, point_m, 1, &extinction_per_m), OFFING_BAD_INPUT);
  EXPECT_STRNE(offing_last_hint(), "");
  EXPECT_EQ(offing_read_cloud_particles(world_, 1, nullptr), OFFING_BAD_INPUT);
  const c::Use use(world_, "world");
  seen_by = camera();
  EXPECT_EQ(offing_draw_clouds(world_, &seen_by, rgba.data(), nullptr, pixels), OFFING_BUSY);
}

}  // namespace
}  // namespace offing
