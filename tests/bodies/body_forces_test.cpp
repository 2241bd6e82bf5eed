// Forces of one sub-step on the device against those of the reference, at random poses in random water.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "host/bodies/floating_bodies.h"
#include "host/bodies/hull.h"
#include "tests/bodies/example_bodies.h"
#include "tests/bodies/reference_forces.h"

namespace offing::bodies {
namespace {

constexpr double density = test::sea_density_kgpm3, gravity = 9.81;

/// Water of random heights, at rest, the same at all times: a hull in it has vertices that are wet in any
/// pattern.
struct RandomWater {
  std::vector<SurfaceQuerySample> samples;

  RandomWater(std::size_t count, double deviation_m, std::mt19937& random) : samples(count) {
    std::normal_distribution<float> height(0.0f, static_cast<float>(deviation_m));
    for (SurfaceQuerySample& sample : samples) sample.height_m = height(random);
  }
};

glm::dquat random_turn(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(glm::dquat(normal(random), normal(random), normal(random), normal(random)));
}

// Fails if a part of a face is cut, weighed or turned wrongly. A float's last digit is 6e-8 of what is added:
// hull vertices at 15 m, sums of 3,000 faces of either sign; measured 3e-6 of the weight of what is displaced
// (moments: of that times the length), gate 3e-5.
TEST(BodyForcesTest, AreThoseOfTheReference) {
  const ocl::Device device = ocl::Device::open();
  std::mt19937 random(7);
  for (const TriangleMesh& mesh : {test::box({6.0, 3.0, 4.0}), test::ball(3.0), test::ship(30.0)}) {
    FloatingBody body = load_to_level("body", mesh, 0.1, density);
    for (int trial = 0; trial < 12; ++trial) {
      body.start = {.mass_centre_m = {1e5 + 20.0 * trial, 0.3 * trial - 1.5, -3e4},
                    .turn = random_turn(random)};
      FloatingBodies bodies(device, {body});
      const RandomWater water(body.hull.positions_m.size() + 1, 1.0, random);
      bodies.advance_to(
          1e-3, [&](double, const auto&, std::size_t, auto& samples) { samples.write(water.samples); });
      const BodyReport found = bodies.read_reports().front();
      const std::vector<BodyState> path = bodies.path().read();
      const BodyPose pose = pose_of(path[FloatingBodies::steps_a_question - 2]);
      std::vector<double> depths_m;
      for (std::size_t i = 0; i < body.hull.positions_m.size(); ++i) {
        depths_m.push_back(static_cast<double>(water.samples[i].height_m) -
                           FloatingBodies::world_point(body, pose, body.hull.positions_m[i]).y);
      }
      const test::ReferenceForces expected = test::reference_forces(body, pose, depths_m, density * gravity);
      const double weight_n = body.mass_kg * gravity, moment_nm = weight_n * 15.0;
      EXPECT_NEAR(found.pressure_x_n, expected.pressure_n.x, 3e-5 * weight_n);
      EXPECT_NEAR(found.pressure_y_n, expected.pressure_n.y, 3e-5 * weight_n);
      EXPECT_NEAR(found.pressure_z_n, expected.pressure_n.z, 3e-5 * weight_n);
      EXPECT_NEAR(found.pressure_moment_x_nm, expected.pressure_moment_nm.x, 3e-5 * moment_nm);
      EXPECT_NEAR(found.pressure_moment_y_nm, expected.pressure_moment_nm.y, 3e-5 * moment_nm);
      EXPECT_NEAR(found.pressure_moment_z_nm, expected.pressure_moment_nm.z, 3e-5 * moment_nm);
      EXPECT_NEAR(found.wetted_m2, expected.wetted_m2, 3e-5 * expected.wetted_m2 + 1e-3);
    }
  }
}

// Fails if a closed surface under flat water has any force but that of Archimedes: density gravity volume
// upward, through the centre of volume. Digits as above, of pressures at 50 m of depth.
TEST(BodyForcesTest, AreArchimedesBelowFlatWater) {
  const ocl::Device device = ocl::Device::open();
  FloatingBody body = load_to_level("ship", test::ship(30.0), 0.1, density);
  body.start.mass_centre_m.y = -50.0;
  FloatingBodies bodies(device, {body});
  bodies.advance_to(1e-3, test::still_water());
  const BodyReport found = bodies.read_reports().front();
  const Enclosed whole = enclosed_by(body.hull);
  const double lift_n = density * gravity * whole.volume_m3;
  EXPECT_NEAR(found.pressure_y_n, lift_n, 2e-4 * lift_n);
  EXPECT_NEAR(found.pressure_x_n, 0.0, 2e-4 * lift_n);
  EXPECT_NEAR(found.pressure_z_n, 0.0, 2e-4 * lift_n);
  const double arm_m = whole.centre_m.x - body.mass_centre_m.x;
  EXPECT_NEAR(found.pressure_moment_z_nm, arm_m * lift_n, 2e-3 * lift_n);
}

// Fails if drag speeds a body up, or friction is not that of ITTC 1957: a box that is drawn under water along
// its length at 3 m/s has its sides' friction and the drag of its two ends.
TEST(BodyForcesTest, DragIsThatOfItsFaces) {
  const ocl::Device device = ocl::Device::open();
  FloatingBody body = load_to_level("box", test::box({8.0, 2.0, 2.0}), 0.5, density);
  body.start.mass_centre_m.y = -20.0;
  body.start.velocity_mps = {3.0, 0.0, 0.0};
  FloatingBodies bodies(device, {body});
  bodies.advance_to(1e-3, test::still_water());
  const double digits = std::log10(3.0 * 8.0 / 1.19e-6) - 2.0;
  const double friction_n = 0.5 * density * 0.075 / (digits * digits) * 9.0 * 4.0 * 16.0;
  const double form_n = 0.5 * density * 9.0 * 4.0 * (body.drag.face + body.drag.wake);
  // The body loses some 1 % of its speed within the four sub-steps.
  EXPECT_NEAR(bodies.read_reports().front().drag_x_n, -(friction_n + form_n), 0.03 * (friction_n + form_n));
}

}  // namespace
}  // namespace offing::bodies
