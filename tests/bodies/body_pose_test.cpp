// Poses on their way to the device and back.
#include "host/bodies/body_pose.h"

#include <cmath>

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing::bodies {
namespace {

// Fails if places lose digits far from the origin: rests are within 32 m, where a float's last digit is 4e-6
// m.
TEST(BodyPoseTest, KeepsItsDigitsFarAway) {
  BodyPose pose{.mass_centre_m = {1.234567e7 + 0.123456, -2.5, -1.9e7 - 31.98765},
                .turn = turn_of_heading(2.1),
                .velocity_mps = {1.0, 2.0, 3.0},
                .spin_radps = {0.1, 0.2, 0.3}};
  const BodyPose back = pose_of(device_state(pose));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(back.mass_centre_m[axis], pose.mass_centre_m[axis], 4e-6);
    EXPECT_NEAR(back.velocity_mps[axis], pose.velocity_mps[axis], 1e-6);
    EXPECT_NEAR(back.spin_radps[axis], pose.spin_radps[axis], 1e-7);
  }
  EXPECT_NEAR(heading_of(back), 2.1, 1e-6);
}

// Fails if headings grow from +x toward -z.
TEST(BodyPoseTest, HeadingsGoFromXTowardZ) {
  const glm::dvec3 forward = turn_of_heading(0.3) * glm::dvec3(1.0, 0.0, 0.0);
  EXPECT_NEAR(forward.x, std::cos(0.3), 1e-12);
  EXPECT_NEAR(forward.z, std::sin(0.3), 1e-12);
}

// Fails if a place that no world has goes to a device.
TEST(BodyPoseTest, RefusesPlacesBeyondTheWorld) {
  EXPECT_THROW(device_state({.mass_centre_m = {3e7, 0.0, 0.0}}), Error);
  EXPECT_THROW(device_state({.mass_centre_m = {0.0, std::nan(""), 0.0}}), Error);
}

// Fails if turns take the long way round.
TEST(BodyPoseTest, GoesBetweenTheShortestWay) {
  const BodyPose from{.turn = turn_of_heading(3.0)}, to{.turn = -turn_of_heading(3.2)};
  EXPECT_NEAR(std::remainder(heading_of(pose_between(from, to, 0.5)) - 3.1, 6.283185307179586), 0.0, 1e-9);
}

}  // namespace
}  // namespace offing::bodies
