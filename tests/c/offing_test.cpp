// The C interface from C++, so that its answers can be held against those of the classes behind it;
// examples/buoyancy.c is a program in C.
#include "host/c/offing.h"

#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/log.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/world_scene.h"

namespace offing {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* scene_text =
    "version = 1\n[wind]\nspeed_mps = 9\n[ocean]\nsize = 64\n[ocean.gerstner]\ncount = 8\n";

class OffingInterfaceTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(offing_open_device(nullptr, &device_), OFFING_OK) << offing_last_error();
    ASSERT_EQ(offing_parse_scene(scene_text, nullptr, &scene_), OFFING_OK) << offing_last_error();
    ASSERT_EQ(offing_make_world(device_, scene_, &world_), OFFING_OK) << offing_last_error();
  }
  void TearDown() override {
    offing_free_world(world_);
    offing_free_scene(scene_);
    offing_close_device(device_);
  }

  std::vector<float> heights() {
    std::vector<float> values(64 * 64);
    EXPECT_EQ(offing_read(world_, 0, OFFING_DISPLACEMENT_Y, values.data(), values.size()), OFFING_OK);
    return values;
  }

  OffingDevice* device_ = nullptr;
  OffingScene* scene_ = nullptr;
  OffingWorld* world_ = nullptr;
};

// Fails if a point's answer is of another sea, time or query than the C++ interface gives, or in other
// places.
TEST_F(OffingInterfaceTest, SamplesTheWorldOfItsTime) {
  const std::vector<OffingPoint> points{{0.0, 0.0}, {31.5, -12.25}, {1e5, 2e5}};
  std::vector<OffingSample> found(points.size());
  const OffingQuery query{.depth_m = 1.5, .min_wavelength_m = 4.0};
  ASSERT_EQ(offing_frame(world_, 3.25), OFFING_OK);
  ASSERT_EQ(offing_sample(world_, &query, points.data(), points.size(), found.data()), OFFING_OK);

  const scene::Scene scene = scene::parse_scene(scene_text, "scene", "");
  world::World world(ocl::Device::open(), scene::prepare_world(scene));
  world.at(3.25, 5.0);
  const std::vector<ocean::WaterPoint> places{{0.0, 0.0}, {31.5, -12.25}, {1e5, 2e5}};
  const auto expected = world.ocean().sample(places, {.depth_m = 1.5, .min_wavelength_m = 4.0});
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(found[i].height_m, expected[i].height_m);
    EXPECT_EQ(found[i].velocity_mps[1], expected[i].velocity_y_mps);
    EXPECT_EQ(found[i].pressure_pa, expected[i].pressure_pa);
    EXPECT_EQ(found[i].normal[2], ocean::normal_of(expected[i])[2]);
    EXPECT_NEAR(std::hypot(found[i].normal[0], found[i].normal[1], found[i].normal[2]), 1.0, 1e-6);
    EXPECT_LT(found[i].residual_m, 1e-3);
  }
  EXPECT_GT(found[0].pressure_pa, 0.0f);
}

// Fails if a frame depends on those before it, or maps are those of another time.
TEST_F(OffingInterfaceTest, FramesComeInAnyOrder) {
  ASSERT_EQ(offing_frame(world_, 2.0), OFFING_OK);
  const std::vector<float> first = heights();
  ASSERT_EQ(offing_frame(world_, 7.0), OFFING_OK);
  EXPECT_NE(heights(), first);
  ASSERT_EQ(offing_frame(world_, 2.0), OFFING_OK);
  EXPECT_EQ(heights(), first);
}

// Fails if a map cannot be read, or is that of another field.
TEST_F(OffingInterfaceTest, ReadsEveryField) {
  ASSERT_GT(offing_cascade_count(world_), 0);
  ASSERT_EQ(offing_map_size(world_), 64);
  EXPECT_GT(offing_patch_length_m(world_, 0), 10.0);
  EXPECT_EQ(offing_patch_length_m(world_, 99), 0.0);
  std::vector<std::vector<float>> maps;
  for (int field = OFFING_DISPLACEMENT_X; field <= OFFING_FOAM; ++field) {
    std::vector<float> values(64 * 64, -5.0f);
    ASSERT_EQ(offing_read(world_, 0, static_cast<OffingField>(field), values.data(), values.size()),
              OFFING_OK);
    for (const auto& other : maps) EXPECT_NE(values, other) << field;
    for (const float value : values) ASSERT_NE(value, -5.0f) << field;
    maps.push_back(values);
  }
}

// Fails if a bad argument is not refused, is refused without a word that helps, or an exception leaves a
// call.
TEST_F(OffingInterfaceTest, RefusesBadArguments) {
  OffingScene* scene = nullptr;
  EXPECT_EQ(offing_parse_scene("version = 1\n[wind]\nspeed = 9\n", nullptr, &scene), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("scene:3:1: wind.speed"));
  EXPECT_EQ(offing_parse_values("version = 1\n[wind]\nspeed = 9\n", nullptr, &scene), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), StartsWith("scene: wind.speed"));
  EXPECT_THAT(offing_last_hint(), HasSubstr("speed_mps"));
  EXPECT_EQ(scene, nullptr);
  EXPECT_EQ(offing_load_scene("no/such.toml", &scene), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("no/such.toml"));
  EXPECT_EQ(offing_load_scene(nullptr, &scene), OFFING_BAD_INPUT);

  OffingDevice* device = nullptr;
  EXPECT_EQ(offing_open_device("no such device", &device), OFFING_NO_DEVICE);
  EXPECT_EQ(device, nullptr);

  EXPECT_EQ(offing_frame(world_, std::nan("")), OFFING_BAD_INPUT);
  EXPECT_EQ(offing_frame(world_, 1e9), OFFING_BAD_INPUT);
  EXPECT_EQ(offing_frame(nullptr, 0.0), OFFING_BAD_INPUT);

  const OffingPoint far{.x_m = 1e9, .z_m = 0.0};
  OffingSample sample;
  EXPECT_EQ(offing_sample(world_, nullptr, &far, 1, &sample), OFFING_BAD_INPUT);
  EXPECT_EQ(offing_sample(world_, nullptr, nullptr, 1, &sample), OFFING_BAD_INPUT);
  EXPECT_EQ(offing_sample(world_, nullptr, nullptr, 0, nullptr), OFFING_OK);

  std::vector<float> values(10);
  EXPECT_EQ(offing_read(world_, 0, OFFING_SLOPE_X, values.data(), values.size()), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("4096"));
  values.resize(64 * 64);
  EXPECT_EQ(offing_read(world_, 9, OFFING_FOAM, values.data(), values.size()), OFFING_BAD_INPUT);
  EXPECT_EQ(
      offing_read(world_, 0, static_cast<OffingField>(OFFING_VELOCITY_Z + 1), values.data(), values.size()),
      OFFING_BAD_INPUT);
}

// Fails if a time that is none reaches keyframes or the sun's clock, or a refused frame has changed the
// world.
TEST_F(OffingInterfaceTest, RefusesTimesBeforeAnythingMoves) {
  OffingScene* scene = nullptr;
  ASSERT_EQ(
      offing_parse_scene("version = 1\n[ocean]\nsize = 64\n[camera]\ny_m = { keys = [ { t = 0, value = 2 }, "
                         "{ t = 5, value = 9 } ] }\n[sun]\ntime_utc = 2026-06-21T09:00:00Z\n"
                         "[world]\nlatitude_deg = 50\nlongitude_deg = 8\n",
                         nullptr, &scene),
      OFFING_OK)
      << offing_last_error();
  OffingWorld* world = nullptr;
  ASSERT_EQ(offing_make_world(device_, scene, &world), OFFING_OK) << offing_last_error();
  for (const double time_s : {std::nan(""), 1e300, -HUGE_VAL, 2e8}) {
    EXPECT_EQ(offing_frame(world, time_s), OFFING_BAD_INPUT) << time_s;
  }
  EXPECT_EQ(offing_frame(world, 2.5), OFFING_OK) << offing_last_error();
  offing_free_world(world);
  offing_free_scene(scene);
}

// Fails if a warning about a scene goes to standard output, which is the program's, or is not printed.
TEST_F(OffingInterfaceTest, WarnsOnStderr) {
  OffingScene* scene = nullptr;
  OffingWorld* world = nullptr;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(
      offing_parse_scene("version = 1\n[ocean]\nsize = 16\nspectrum = \"pm\"\ngamma = 3\n", nullptr, &scene),
      OFFING_OK);
  EXPECT_EQ(offing_make_world(device_, scene, &world), OFFING_OK) << offing_last_error();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("gamma"));
  offing_free_world(world);
  offing_free_scene(scene);
}

// Fails if a logger that the program sets after its first call is replaced by a later one, of another
// function.
TEST_F(OffingInterfaceTest, KeepsTheLoggerOfTheProgram) {
  const std::shared_ptr<spdlog::logger> before = spdlog::default_logger();
  const auto own = std::make_shared<spdlog::logger>("");
  spdlog::set_default_logger(own);
  EXPECT_EQ(offing_frame(world_, 1.0), OFFING_OK);
  heights();
  EXPECT_EQ(spdlog::default_logger(), own);
  spdlog::set_default_logger(before);
}

// Fails if a failure of one thread is told to another.
TEST_F(OffingInterfaceTest, KeepsFailuresOfThreadsApart) {
  EXPECT_EQ(offing_frame(nullptr, 0.0), OFFING_BAD_INPUT);
  std::string elsewhere = "unset";
  std::thread([&] { elsewhere = offing_last_error(); }).join();
  EXPECT_EQ(elsewhere, "");
  EXPECT_STRNE(offing_last_error(), "");
}

}  // namespace
}  // namespace offing
