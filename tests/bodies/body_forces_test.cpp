// Forces of one sub-step on the device against those of the reference, at random poses in random water.
#include "host/bodies/body_forces.h"

#include <cmath>
#include <numbers>
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
  std::vector<SurfaceQueryShifted> samples;

  RandomWater(std::size_t count, double deviation_m, std::mt19937& random) : samples(count) {
    std::normal_distribution<float> height(0.0f, static_cast<float>(deviation_m));
    for (SurfaceQueryShifted& sample : samples) sample.water.height_m = height(random);
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
        depths_m.push_back(static_cast<double>(water.samples[i].water.height_m) -
                           FloatingBodies::world_point(body, pose, body.hull.positions_m[i]).y);
      }
      const test::ReferenceForces expected = test::reference_forces(body, pose, depths_m, density * gravity);
      const double weight_n = body.mass_kg * gravity, moment_nm = weight_n * 15.0;
      EXPECT_NEAR(force_of(found, BODY_PRESSURE).x, expected.pressure_n.x, 3e-5 * weight_n);
      EXPECT_NEAR(force_of(found, BODY_PRESSURE).y, expected.pressure_n.y, 3e-5 * weight_n);
      EXPECT_NEAR(force_of(found, BODY_PRESSURE).z, expected.pressure_n.z, 3e-5 * weight_n);
      EXPECT_NEAR(moment_of(found, BODY_PRESSURE).x, expected.pressure_moment_nm.x, 3e-5 * moment_nm);
      EXPECT_NEAR(moment_of(found, BODY_PRESSURE).y, expected.pressure_moment_nm.y, 3e-5 * moment_nm);
      EXPECT_NEAR(moment_of(found, BODY_PRESSURE).z, expected.pressure_moment_nm.z, 3e-5 * moment_nm);
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
  EXPECT_NEAR(force_of(found, BODY_PRESSURE).y, lift_n, 2e-4 * lift_n);
  EXPECT_NEAR(force_of(found, BODY_PRESSURE).x, 0.0, 2e-4 * lift_n);
  EXPECT_NEAR(force_of(found, BODY_PRESSURE).z, 0.0, 2e-4 * lift_n);
  const double arm_m = whole.centre_m.x - body.mass_centre_m.x;
  EXPECT_NEAR(moment_of(found, BODY_PRESSURE).z, arm_m * lift_n, 2e-3 * lift_n);
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
  EXPECT_NEAR(force_of(bodies.read_reports().front(), BODY_DRAG).x, -(friction_n + form_n),
              0.03 * (friction_n + form_n));
}

// Fails if a kind of force is left out of the report, or counts twice: a boat in random water, with
// everything that can act on a hull without hydrodynamic data. Without added mass their sum is mass times
// acceleration; a float's last digit of 3 m/s is 3e-5 m/s2 a sub-step: gate 1e-4 of the weight.
TEST(BodyForcesTest, AddUpToTheMotion) {
  const ocl::Device device = ocl::Device::open();
  std::mt19937 random(11);
  FloatingBody body = load_to_level("boat", test::ship(10.0), 0.1, density);
  body.drag.added_along = body.drag.added_up = body.drag.added_inertia = 0.0;
  body.moorings = {
      {.hull_m = {5.0, 0.5, 0.0}, .anchor_m = {80.0, -20.0, 3.0}, .length_m = 60.0, .stiffness_npm = 500.0}};
  body.start = at_rest(body, density, 0.0, 0.0, 0.2);
  body.start.velocity_mps = {3.0, 0.0, -0.5};
  FloatingBodies bodies(device, {body}, {.wind_mps = {-4.0, 15.0}});
  const RandomWater water(body.hull.positions_m.size() + 1, 0.2, random);
  bodies.advance_to(
      1e-3, [&](double, const auto&, std::size_t, auto& samples) { samples.write(water.samples); },
      [](std::size_t, double) {
        BodyDrive drive{};
        drive.thrust_n = 3000.0f;
        drive.rudder_rad = 0.3f;
        return drive;
      });
  const BodyReport report = bodies.read_reports().front();
  glm::dvec3 sum_n(0.0);
  for (int kind = 0; kind < BODY_FORCE_KINDS; ++kind) {
    const glm::dvec3 force_n = force_of(report, static_cast<BodyForce>(kind));
    sum_n += force_n;
    const bool is_of_data = kind == BODY_RADIATION || kind == BODY_EXCITATION;
    EXPECT_EQ(glm::length(force_n) > 1.0, !is_of_data) << force_kinds[static_cast<std::size_t>(kind)].name;
  }
  const std::vector<BodyState> path = bodies.path().read();
  const glm::dvec3 before_mps = pose_of(path[FloatingBodies::steps_a_question - 2]).velocity_mps;
  const glm::dvec3 after_mps = pose_of(path[FloatingBodies::steps_a_question - 1]).velocity_mps;
  const glm::dvec3 needed_n = body.mass_kg * FloatingBodies::steps_per_s * (after_mps - before_mps);
  EXPECT_LT(glm::length(sum_n - needed_n), 1e-4 * body.mass_kg * gravity);
}

// Fails if the wind does not push as on walls: half density (0.8 + 0.5) area speed^2 at 50 m of height, where
// it is 5^0.12 times as fast as at 10 m. The box falls, and its faces stand a metre lower or higher: gate 1
// %.
TEST(BodyForcesTest, WindPushesDryFaces) {
  const ocl::Device device = ocl::Device::open();
  FloatingBody body = load_to_level("box", test::box({8.0, 2.0, 3.0}), 0.5, density);
  body.start.mass_centre_m.y = 50.0;
  const auto push_n = [&](double windage) {
    body.drag.windage = windage;
    FloatingBodies bodies(device, {body}, {.wind_mps = {0.0, 20.0}});
    bodies.advance_to(1e-3, test::still_water());
    return force_of(bodies.read_reports().front(), BODY_WIND);
  };
  const double wind_mps = 20.0 * std::pow(5.0, 0.12);
  const double expected_n = 0.5 * 1.225 * 1.3 * 16.0 * wind_mps * wind_mps;
  EXPECT_NEAR(push_n(1.0).z, expected_n, 0.01 * expected_n);
  EXPECT_NEAR(push_n(1.0).x, 0.0, 0.01 * expected_n);
  EXPECT_NEAR(push_n(2.5).z, 2.5 * expected_n, 0.025 * expected_n);
  EXPECT_EQ(push_n(0.0).z, 0.0);
}

// Fails if lines are not springs: a box without drag between two of them, at the height of its mass centre,
// swings with the period 2 pi sqrt(mass / stiffness), both stiffnesses counting. Friction of plates is a
// thousandth of this; steps of 1/120 s and the implicit step change a period of 4 s by less than 1e-4: gate 1
// %.
TEST(BodyForcesTest, LinesAreSprings) {
  const ocl::Device device = ocl::Device::open();
  FloatingBody body = load_to_level("box", test::box({8.0, 2.0, 2.0}), 0.0, density);
  body.drag = {.face = 0.0, .wake = 0.0, .waves = 0.0, .added_along = 0.0, .added_up = 0.0};
  body.start = at_rest(body, density, 1e4, -3e3, 0.0);
  const glm::dvec3 start_m = body.start.mass_centre_m;
  const double period_s = 4.0;
  const double stiffness_npm = 0.5 * body.mass_kg * std::pow(2.0 * std::numbers::pi / period_s, 2.0);
  for (const double side : {-1.0, 1.0}) {
    body.moorings.push_back({.hull_m = body.mass_centre_m,
                             .anchor_m = start_m + glm::dvec3(30.0 * side, 0.0, 0.0),
                             .length_m = 20.0,
                             .stiffness_npm = stiffness_npm});
  }
  body.start.mass_centre_m.x += 0.5;
  FloatingBodies bodies(device, {body});
  double last_mps = 0.0;
  std::vector<double> turns_s;
  for (int frame = 1; frame <= 30 * 9; ++frame) {
    const double time_s = frame / 30.0;
    bodies.advance_to(time_s, test::still_water());
    const double speed_mps = bodies.read_poses().front().velocity_mps.x;
    if (last_mps * speed_mps < 0.0) turns_s.push_back(time_s - speed_mps / (speed_mps - last_mps) / 30.0);
    last_mps = speed_mps;
  }
  ASSERT_EQ(turns_s.size(), 4u);
  EXPECT_NEAR(turns_s[3] - turns_s[1], period_s, 0.01 * period_s);

  // Slack lines do nothing.
  for (MooringLine& line : body.moorings) line.length_m = 40.0;
  FloatingBodies slack(device, {body});
  slack.advance_to(0.1, test::still_water());
  EXPECT_EQ(force_of(slack.read_reports().front(), BODY_MOORING).x, 0.0);
}

}  // namespace
}  // namespace offing::bodies
