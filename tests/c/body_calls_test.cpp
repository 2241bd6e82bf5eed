// Floating bodies of the C interface against those of the world behind it.
#include <array>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/bodies/body_forces.h"
#include "host/c/handles.h"
#include "host/c/offing.h"

namespace offing {
namespace {

using testing::HasSubstr;

constexpr const char* scene_with_bodies = R"(version = 1
[wind]
speed_mps = 6
[ocean]
size = 32
[[mesh]]
name = "box"
shape = "box"
size_m = 2
highlights = "off"
[[mesh]]
name = "raft"
shape = "box"
size_m = 3
highlights = "off"
[[body]]
name = "buoy"
mesh = "box"
draught_m = 1
mass_centre_m = [0, -0.5, 0]
x_m = 4
[[body]]
mesh = "raft"
draught_m = 1
mass_centre_m = [0, -1, 0]
x_m = 20
)";
// Boxes of 4 and 6 m, drawn 1 m.
constexpr double weight_n = 9.81 * 1025.0 * 4.0 * 4.0 * 1.0;

class BodyCallsTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(offing_open_device(nullptr, &device_), OFFING_OK) << offing_last_error();
    ASSERT_EQ(offing_parse_scene(scene_with_bodies, nullptr, &scene_), OFFING_OK) << offing_last_error();
    ASSERT_EQ(offing_make_world(device_, scene_, &world_), OFFING_OK) << offing_last_error();
  }
  void TearDown() override {
    offing_free_world(world_);
    offing_free_scene(scene_);
    offing_close_device(device_);
  }

  OffingDevice* device_ = nullptr;
  OffingScene* scene_ = nullptr;
  OffingWorld* world_ = nullptr;
};

// Fails if a body has another's name, pose, or one of another time than the frame's.
TEST_F(BodyCallsTest, HaveTheirPoses) {
  ASSERT_EQ(offing_body_count(world_), 2u);
  EXPECT_STREQ(offing_body_name(world_, 0), "buoy");
  EXPECT_STREQ(offing_body_name(world_, 1), "");
  EXPECT_STREQ(offing_body_name(world_, 2), "");
  EXPECT_EQ(offing_body_count(nullptr), 0u);
  std::array<double, 6> centre_m{}, velocity_mps{}, spin_radps{};
  std::array<double, 8> turn{};
  std::array<double, 2> displaced_m3{};
  const OffingBodyPoses poses{sizeof poses,        centre_m.data(),   turn.data(),
                              velocity_mps.data(), spin_radps.data(), displaced_m3.data()};
  ASSERT_EQ(offing_frame(world_, 1.23), OFFING_OK) << offing_last_error();
  ASSERT_EQ(offing_read_body_poses(world_, 2, &poses), OFFING_OK) << offing_last_error();
  ASSERT_EQ(world_->world.time_s(), 1.23);
  for (std::size_t i = 0; i < 2; ++i) {
    const bodies::BodyPose due = world_->world.bodies()->pose(i, 1.23);
    EXPECT_EQ(centre_m[3 * i], due.mass_centre_m.x);
    EXPECT_EQ(centre_m[3 * i + 1], due.mass_centre_m.y);
    EXPECT_EQ(turn[4 * i], due.turn.w);
    EXPECT_EQ(turn[4 * i + 3], due.turn.z);
    EXPECT_EQ(velocity_mps[3 * i + 1], due.velocity_mps.y);
    EXPECT_EQ(spin_radps[3 * i + 2], due.spin_radps.z);
    EXPECT_EQ(displaced_m3[i], due.displaced_m3);
  }
}

// A body that floats in small waves is carried by its weight, but for what they lift it: within a third of
// it. Pressure acts on what is wetted, and displaces what weighs as much. Fails if forces are of another
// body, or in the place of others.
TEST_F(BodyCallsTest, HaveTheirForces) {
  double time_s = 0.0;
  std::array<float, 6> pressure_n{}, pressure_moment_nm{}, drag_n{}, drag_moment_nm{};
  std::array<float, 2> displaced_m3{}, wetted_m2{};
  std::vector<float> by_kind(2 * OFFING_FORCE_KINDS * 6);
  const OffingBodyForces forces{sizeof forces,       &time_s,
                                pressure_n.data(),   pressure_moment_nm.data(),
                                drag_n.data(),       drag_moment_nm.data(),
                                displaced_m3.data(), wetted_m2.data(),
                                by_kind.data()};
  ASSERT_EQ(offing_frame(world_, 2.0), OFFING_OK) << offing_last_error();
  ASSERT_EQ(offing_read_body_forces(world_, 2, &forces), OFFING_OK) << offing_last_error();
  EXPECT_GT(time_s, 2.0);
  EXPECT_LT(time_s, 2.14);
  EXPECT_NEAR(pressure_n[1], weight_n, weight_n / 3.0);
  EXPECT_NEAR(pressure_n[4], 9.0 / 4.0 * weight_n, 0.75 * weight_n);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(pressure_n[3 * i + 1], 1025.0 * 9.81 * displaced_m3[i], 0.1 * weight_n);
    EXPECT_LT(std::abs(drag_n[3 * i + 1]), 0.5 * weight_n);
    EXPECT_NE(drag_n[3 * i + 1], 0.0f);
    EXPECT_NE(drag_moment_nm[3 * i + 2], 0.0f);
    EXPECT_NE(pressure_moment_nm[3 * i + 2], 0.0f);
  }
  EXPECT_NEAR(wetted_m2[0], 16.0 + 16.0, 6.0);
  const std::vector<BodyReport> due = world_->world.bodies()->read_reports();
  const std::size_t gravity_y = (OFFING_FORCE_KINDS + OFFING_FORCE_GRAVITY) * 6 + 1;
  EXPECT_NEAR(by_kind[gravity_y], -9.0 / 4.0 * weight_n, 0.01 * weight_n);
  EXPECT_STREQ(offing_body_force_name(OFFING_FORCE_MOORING), "mooring");
  EXPECT_STREQ(offing_body_force_name(OFFING_FORCE_KINDS), "");
  using bodies::force_of, bodies::moment_of;
  EXPECT_EQ(drag_n[3], force_of(due[1], BODY_DRAG).x);
  EXPECT_EQ(drag_moment_nm[4], moment_of(due[1], BODY_DRAG).y);
  EXPECT_EQ(pressure_moment_nm[5], moment_of(due[1], BODY_PRESSURE).z);
}

// Fails if an array of another size is filled, or a call gets into a world that another one is using.
TEST_F(BodyCallsTest, RefuseBadArguments) {
  OffingBodyPoses poses{};
  poses.size = sizeof poses;
  EXPECT_EQ(offing_read_body_poses(world_, 3, &poses), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("expected 2, got 3"));
  EXPECT_EQ(offing_read_body_poses(world_, 2, nullptr), OFFING_BAD_INPUT);
  EXPECT_STRNE(offing_last_hint(), "");
  OffingBodyForces forces{};
  EXPECT_EQ(offing_read_body_forces(world_, 2, &forces), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_hint(), HasSubstr("sizeof"));
  const c::Use use(world_, "world");
  EXPECT_EQ(offing_read_body_poses(world_, 2, &poses), OFFING_BUSY);
}

}  // namespace
}  // namespace offing
