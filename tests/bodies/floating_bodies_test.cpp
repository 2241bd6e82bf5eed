// Bodies that move: against closed forms of rigid bodies and of ships.
#include "host/bodies/floating_bodies.h"

#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/bodies/body_forces.h"
#include "host/bodies/hydrostatics.h"
#include "tests/bodies/example_bodies.h"

namespace offing::bodies {
namespace {

constexpr double density = test::sea_density_kgpm3, gravity = 9.81;

class FloatingBodiesTest : public testing::Test {
 protected:
  static FloatingBody ship() { return load_to_level("ship", test::ship(30.0), 0.0, density); }

  const ocl::Device device_ = ocl::Device::open();
};

// Fails if bodies do not come to rest at their draught of Archimedes, within 1 % of it, from 20 % above.
TEST_F(FloatingBodiesTest, FloatAtTheirDraught) {
  std::vector<FloatingBody> bodies{load_to_mass("box", test::box({4.0, 2.0, 3.0}), 9000.0, density),
                                   load_to_mass("ball", test::ball(1.0), 2000.0, density), ship()};
  std::vector<double> draughts_m, centres_m;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double level_m = level_that_displaces(bodies[i].hull, bodies[i].mass_kg / density, "body");
    double keel_m = level_m;
    for (const glm::dvec3& place : bodies[i].hull.positions_m) keel_m = std::min(keel_m, place.y);
    draughts_m.push_back(level_m - keel_m);
    bodies[i].start = at_rest(bodies[i], density, 50.0 * static_cast<double>(i), 0.0, 0.3);
    centres_m.push_back(bodies[i].start.mass_centre_m.y);
    bodies[i].start.mass_centre_m.y += 0.2 * draughts_m.back();
  }
  FloatingBodies floating(device_, bodies);
  floating.advance_to(60.0, test::still_water());
  const std::vector<BodyPose> poses = floating.read_poses();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    EXPECT_NEAR(poses[i].mass_centre_m.y, centres_m[i], 0.01 * draughts_m[i]) << bodies[i].name;
    EXPECT_NEAR((poses[i].turn * glm::dvec3(0.0, 1.0, 0.0)).y, 1.0, 1e-5) << bodies[i].name;
  }
}

// Fails if what has no water under it does not fall as Galilei has it: semi-implicit steps reach g t (t + dt)
// / 2.
TEST_F(FloatingBodiesTest, FallFreely) {
  FloatingBody body = load_to_level("box", test::box({1.0, 1.0, 1.0}), 0.0, density);
  body.start.mass_centre_m.y = 500.0;
  body.start.velocity_mps = {3.0, 0.0, -1.0};
  FloatingBodies floating(device_, {body}, {.air_density_kgpm3 = 0.0});
  floating.advance_to(5.0, test::still_water());
  const BodyPose pose = floating.read_poses().front();
  EXPECT_NEAR(pose.mass_centre_m.y, 500.0 - 0.5 * gravity * 5.0 * (5.0 + 1.0 / 120.0), 0.02);
  EXPECT_NEAR(pose.mass_centre_m.x, 15.0, 1e-3);
  EXPECT_NEAR(pose.mass_centre_m.z, -5.0, 1e-3);
  EXPECT_NEAR(pose.velocity_mps.y, -5.0 * gravity, 1e-3);
}

// Fails if a body without moments does not keep its angular momentum in the world: first-order steps of 1/120
// s at 1 rad/s drift by some 1e-3 in 10 s; gate 1 %.
TEST_F(FloatingBodiesTest, KeepTheirAngularMomentum) {
  FloatingBody body = load_to_level("box", test::box({1.0, 2.0, 3.0}), 0.0, density);
  body.start.mass_centre_m.y = 5000.0;
  body.start.spin_radps = {0.6, 0.8, 0.1};
  body.drag.added_inertia = 0.0;
  const auto momentum = [&](const BodyPose& pose) {
    return pose.turn * (body.inertia_kgm2 * pose.spin_radps);
  };
  FloatingBodies floating(device_, {body}, {.air_density_kgpm3 = 0.0});
  const glm::dvec3 before = momentum(body.start);
  floating.advance_to(10.0, test::still_water());
  const glm::dvec3 after = momentum(floating.read_poses().front());
  EXPECT_LT(glm::length(after - before), 0.01 * glm::length(before));
}

// Fails if a box does not heave with the period 2 pi sqrt((m + added) / (density g A)): with no drag at all
// it goes on for ever; measured over ten periods, within 1 %.
TEST_F(FloatingBodiesTest, HeaveWithTheirPeriod) {
  FloatingBody body = load_to_mass("box", test::box({4.0, 2.0, 3.0}), 9000.0, density);
  body.drag = {
      .face = 0.0, .wake = 0.0, .waves = 0.0, .added_along = 0.0, .added_up = 0.5, .added_inertia = 0.0};
  body.start = at_rest(body, density, 0.0, 0.0, 0.0);
  const double rest_m = body.start.mass_centre_m.y;
  body.start.mass_centre_m.y += 0.02;
  FloatingBodies floating(device_, {body});
  std::vector<double> crossings_s;
  double last_m = 0.02;
  for (int step = 1; crossings_s.size() < 11; ++step) {
    ASSERT_LT(step, 10000);
    floating.advance_to(step / 120.0, test::still_water());
    const double now_m = floating.read_poses().front().mass_centre_m.y - rest_m;
    if (last_m < 0.0 && now_m >= 0.0) crossings_s.push_back((step - now_m / (now_m - last_m)) / 120.0);
    last_m = now_m;
  }
  const double period_s = 2.0 * std::numbers::pi * std::sqrt(9000.0 * 1.5 / (density * gravity * 4.0 * 3.0));
  EXPECT_NEAR((crossings_s.back() - crossings_s.front()) / 10.0, period_s, 0.01 * period_s);
}

// Fails if a box does not roll with the period 2 pi sqrt(I / (m g GM)), GM = KB + BM - KG of a box: within 2
// %, as the angle of 0.02 rad is small.
TEST_F(FloatingBodiesTest, RollWithTheirPeriod) {
  FloatingBody body = load_to_mass("box", test::box({6.0, 2.0, 3.0}), 9000.0, density);
  body.drag = {
      .face = 0.0, .wake = 0.0, .waves = 0.0, .added_along = 0.0, .added_up = 0.0, .added_inertia = 0.0};
  body.start = at_rest(body, density, 0.0, 0.0, 0.0);
  body.start.turn = glm::angleAxis(0.02, glm::dvec3(1.0, 0.0, 0.0));
  const double draught_m = 9000.0 / density / 18.0;
  const double metacentric_m =
      3.0 * 3.0 / (12.0 * draught_m) - (body.mass_centre_m.y + 1.0 - 0.5 * draught_m);
  FloatingBodies floating(device_, {body});
  std::vector<double> crossings_s;
  double last = 0.02;
  for (int step = 1; crossings_s.size() < 6; ++step) {
    ASSERT_LT(step, 10000);
    floating.advance_to(step / 120.0, test::still_water());
    const double now = (floating.read_poses().front().turn * glm::dvec3(0.0, 1.0, 0.0)).z;
    if (last < 0.0 && now >= 0.0) crossings_s.push_back((step - now / (now - last)) / 120.0);
    last = now;
  }
  const double period_s =
      2.0 * std::numbers::pi * std::sqrt(body.inertia_kgm2[0][0] / (9000.0 * gravity * metacentric_m));
  EXPECT_NEAR((crossings_s.back() - crossings_s.front()) / 5.0, period_s, 0.02 * period_s);
}

// Fails if a small body does not ride on a long wave: height and slope of the water are its own.
TEST_F(FloatingBodiesTest, RideOnLongWaves) {
  FloatingBody body = load_to_mass("box", test::box({2.0, 1.0, 2.0}), 1500.0, density);
  body.start = at_rest(body, density, 0.0, 0.0, 0.0);
  const double rest_m = body.start.mass_centre_m.y;
  const test::LongWave wave{.amplitude_m = 2.0, .wavelength_m = 250.0};
  FloatingBodies floating(device_, {body});
  double worst_m = 0.0, highest_m = -10.0;
  for (int step = 300; step < 900; step += 3) {
    floating.advance_to(step / 30.0, test::wavy_water(wave));
    const BodyPose pose = floating.read_poses().front();
    const double k = 2.0 * std::numbers::pi / wave.wavelength_m;
    const double height_m =
        wave.amplitude_m * std::cos(k * pose.mass_centre_m.x - std::sqrt(gravity * k) * step / 30.0);
    worst_m = std::max(worst_m, std::abs(pose.mass_centre_m.y - rest_m - height_m));
    highest_m = std::max(highest_m, pose.mass_centre_m.y - rest_m);
  }
  EXPECT_LT(worst_m, 0.05 * wave.amplitude_m);
  EXPECT_GT(highest_m, 0.9 * wave.amplitude_m);
}

std::vector<BodyState> states_at_30_s(const ocl::Device& device, const FloatingBody& body,
                                      const std::vector<double>& frames_s) {
  FloatingBodies floating(device, {body});
  const auto drive = [](std::size_t, double time_s) {
    BodyDrive now{};
    now.thrust_n = 20e3f;
    now.rudder_rad = static_cast<float>(0.3 * std::sin(0.2 * time_s));
    return now;
  };
  for (const double time_s : frames_s) floating.advance_to(time_s, test::wavy_water({}), drive);
  floating.advance_to(30.0, test::wavy_water({}), drive);
  return floating.path().read();
}

// Fails if where a body is depends on which times were asked for: states have the same bits.
TEST_F(FloatingBodiesTest, StatesDoNotDependOnTheFrames) {
  FloatingBody body = ship();
  body.start = at_rest(body, density, 0.0, 0.0, 0.0);
  std::vector<double> sixty, irregular;
  for (int i = 0; i < 1790; ++i) sixty.push_back(i / 60.0);
  for (double time_s = 0.0; time_s < 29.9; time_s += 0.013 + 0.09 * std::abs(std::sin(7.0 * time_s))) {
    irregular.push_back(time_s);
  }
  const std::vector<BodyState> expected = states_at_30_s(device_, body, {});
  for (const std::vector<double>& frames_s : {sixty, irregular}) {
    const std::vector<BodyState> found = states_at_30_s(device_, body, frames_s);
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_EQ(std::memcmp(found.data(), expected.data(), found.size() * sizeof(BodyState)), 0);
  }
}

// Fails if a propeller does not push, or a speed does not come to where thrust and drag are equal.
TEST_F(FloatingBodiesTest, ComeToTheSpeedOfTheirThrust) {
  FloatingBody body = load_to_level("boat", test::ship(10.0), 0.0, density);
  body.start = at_rest(body, density, 0.0, 0.0, 0.0);
  FloatingBodies floating(device_, {body});
  const auto ahead = [](std::size_t, double) {
    BodyDrive drive{};
    drive.thrust_n = 1500.0f;
    return drive;
  };
  floating.advance_to(120.0, test::still_water(), ahead);
  const double speed_mps = floating.read_poses().front().velocity_mps.x;
  EXPECT_GT(speed_mps, 2.0);
  EXPECT_LT(speed_mps, 8.0);
  EXPECT_NEAR(force_of(floating.read_reports().front(), BODY_DRAG).x +
                  force_of(floating.read_reports().front(), BODY_PRESSURE).x,
              -1500.0, 0.02 * 1500.0);
  floating.advance_to(125.0, test::still_water(), ahead);
  EXPECT_NEAR(floating.read_poses().front().velocity_mps.x, speed_mps, 0.02 * speed_mps);
}

// Fails if a rudder above 0 does not let the heading grow, from +x toward +z.
TEST_F(FloatingBodiesTest, TurnWithTheirRudder) {
  FloatingBody body = ship();
  body.start = at_rest(body, density, 0.0, 0.0, 0.0);
  body.start.velocity_mps.x = 4.0;
  FloatingBodies floating(device_, {body});
  floating.advance_to(10.0, test::still_water(), [](std::size_t, double) {
    BodyDrive drive{};
    drive.thrust_n = 15e3f;
    drive.rudder_rad = 0.4f;
    return drive;
  });
  EXPECT_GT(heading_of(floating.read_poses().front()), 0.1);
  EXPECT_LT(heading_of(floating.read_poses().front()), 2.5);
}

// Fails if a body leaves its path along x and z or its heading, or does not heave on it.
TEST_F(FloatingBodiesTest, FollowTheirPaths) {
  FloatingBody body = ship();
  body.start = at_rest(body, density, 0.0, 0.0, 0.0);
  FloatingBodies floating(device_, {body});
  double lowest_m = 0.0, highest_m = 0.0;
  const double rest_m = body.start.mass_centre_m.y;
  for (int frame = 1; frame <= 300; ++frame) {
    floating.advance_to(frame / 15.0, test::wavy_water({.amplitude_m = 1.0, .wavelength_m = 120.0}),
                        [](std::size_t, double time_s) {
                          const double end_s = time_s + 1.0 / FloatingBodies::steps_per_s;
                          BodyDrive drive{};
                          drive.follows_path = 1;
                          drive.tile_x = 1;
                          drive.x_m = static_cast<float>(6.0 * end_s - 64.0);
                          drive.z_m = 2.0f;
                          drive.heading_rad = static_cast<float>(0.05 * end_s);
                          drive.velocity_x_mps = 6.0f;
                          drive.heading_rate_radps = 0.05f;
                          return drive;
                        });
    const BodyPose pose = floating.read_poses().front();
    // A float's last digit of 64 m, twice.
    EXPECT_NEAR(pose.mass_centre_m.x, 6.0 * frame / 15.0, 2e-5);
    EXPECT_NEAR(pose.mass_centre_m.z, 2.0, 1e-5);
    EXPECT_NEAR(heading_of(pose), 0.05 * frame / 15.0, 1e-4);
    lowest_m = std::min(lowest_m, pose.mass_centre_m.y - rest_m);
    highest_m = std::max(highest_m, pose.mass_centre_m.y - rest_m);
  }
  EXPECT_LT(lowest_m, -0.5);
  EXPECT_GT(highest_m, 0.5);
}

// Fails if late poses are not those of the advance before, or a reset does not begin anew.
TEST_F(FloatingBodiesTest, LatePosesAreThoseOfTheLastFrame) {
  FloatingBody body = ship();
  body.start = at_rest(body, density, 0.0, 0.0, 0.0);
  body.start.mass_centre_m.y += 1.0;
  FloatingBodies floating(device_, {body});
  EXPECT_EQ(floating.late_poses().front().mass_centre_m, body.start.mass_centre_m);
  floating.advance_to(0.5, test::still_water());
  EXPECT_EQ(floating.late_poses().front().mass_centre_m, body.start.mass_centre_m);
  const double then_m = floating.read_poses().front().mass_centre_m.y;
  EXPECT_NE(then_m, body.start.mass_centre_m.y);
  floating.advance_to(0.51, test::still_water());
  EXPECT_EQ(floating.late_poses().front().mass_centre_m.y, then_m);
  floating.reset(3.0);
  EXPECT_EQ(floating.late_poses().front().mass_centre_m, body.start.mass_centre_m);
  floating.advance_to(3.5, test::still_water());
  EXPECT_NEAR(floating.read_poses().front().mass_centre_m.y, then_m, 1e-7);
}

// Fails if times that are gone are answered with others.
TEST_F(FloatingBodiesTest, RefusesTimesThatAreGone) {
  FloatingBody body = ship();
  body.start = at_rest(body, density, 0.0, 0.0, 0.0);
  FloatingBodies floating(device_, {body});
  floating.advance_to(1.0, test::still_water());
  EXPECT_NO_THROW(floating.advance_to(0.98, test::still_water()));
  EXPECT_THROW(floating.advance_to(0.9, test::still_water()), Error);
  EXPECT_THROW(floating.advance_to(std::nan(""), test::still_water()), Error);
  EXPECT_THROW(FloatingBodies(device_, {}), Error);
}

// Fails if light bodies on rough water, or a body dropped from high up, are thrown away or become NaN: drag
// is semi-implicit.
TEST_F(FloatingBodiesTest, StayOnTheWater) {
  FloatingBody raft = load_to_mass("raft", test::box({1.0, 0.1, 1.0}), 8.0, density);
  raft.start = at_rest(raft, density, 0.0, 0.0, 0.0);
  FloatingBody dropped = load_to_mass("ball", test::ball(0.5), 100.0, density);
  dropped.start.mass_centre_m = {100.0, 60.0, 0.0};
  FloatingBodies floating(device_, {raft, dropped});
  floating.advance_to(60.0, test::wavy_water({.amplitude_m = 0.5, .wavelength_m = 12.0}));
  for (const BodyPose& pose : floating.read_poses()) {
    EXPECT_LT(std::abs(pose.mass_centre_m.y), 2.0);
    EXPECT_LT(glm::length(pose.velocity_mps), 10.0);
  }
}

// Fails if the lift of a rudder that is far too large for its step turns a ship's drift around, again and
// again and faster: here it brakes 20 times the drift in one sub-step.
TEST_F(FloatingBodiesTest, LargeRuddersBrakeTheirDrift) {
  FloatingBody body = ship();
  body.start = at_rest(body, density, 0.0, 0.0, 0.0);
  body.start.velocity_mps = {30.0, 0.0, 1.0};
  body.drive.rudder_area_m2 = 7000.0;
  FloatingBodies floating(device_, {body});
  for (int second = 1; second <= 10; ++second) {
    floating.advance_to(second, test::still_water());
    const BodyPose pose = floating.read_poses().front();
    // It begins with 30.02 m/s, and nothing pushes it; a turn by its stern alone is that drift over half its
    // 30 m.
    EXPECT_LT(glm::length(pose.velocity_mps), 30.1) << second;
    EXPECT_LT(glm::length(pose.spin_radps), 1.0) << second;
  }
}

// Fails if any values that bodies may have drive one to a place or a turn that is no number: seeds 1 to 40,
// each quantity within its range.
TEST_F(FloatingBodiesTest, AbsurdDrivesLeaveNumbers) {
  std::vector<FloatingBody> bodies;
  std::vector<BodyDrive> drives;
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
      return low * std::pow(high / low, std::uniform_real_distribution<>(0.0, 1.0)(random));
    };
    FloatingBody body = load_to_mass("absurd", test::ball(between(0.1, 50.0), 1), 0.0042, density);
    body.mass_kg = between(1e-2, 1e8);
    body.inertia_kgm2 = glm::dmat3(body.mass_kg * between(1e-4, 100.0));
    body.drive.propeller_diameter_m = between(1e-3, 100.0);
    body.drive.rudder_area_m2 = between(1.0, 1e4);
    body.start.mass_centre_m = {200.0 * seed, 0.0, 0.0};
    body.start.velocity_mps = {between(1.0, 100.0), 0.0, between(1.0, 100.0)};
    bodies.push_back(std::move(body));
    BodyDrive drive{};
    drive.thrust_n = static_cast<float>((seed % 2 == 0 ? 1.0 : -1.0) * between(1.0, 1e9));
    drive.rudder_rad = static_cast<float>(between(0.01, 1.04));
    drives.push_back(drive);
  }
  FloatingBodies floating(device_, bodies);
  floating.advance_to(5.0, test::wavy_water({.amplitude_m = 2.0, .wavelength_m = 40.0}),
                      [&](std::size_t body, double) { return drives[body]; });
  const std::vector<BodyPose> poses = floating.read_poses();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_LE(glm::length(poses[i].velocity_mps), 1.001 * BODY_LARGEST_SPEED_MPS) << i + 1;
    EXPECT_LE(glm::length(poses[i].spin_radps), 1.001 * BODY_LARGEST_SPIN_RADPS) << i + 1;
    EXPECT_NEAR(glm::length(poses[i].turn), 1.0, 1e-5) << i + 1;
    // Five seconds of its greatest speed.
    EXPECT_LE(glm::length(poses[i].mass_centre_m - bodies[i].start.mass_centre_m),
              5.1 * BODY_LARGEST_SPEED_MPS)
        << i + 1;
  }
}

}  // namespace
}  // namespace offing::bodies
