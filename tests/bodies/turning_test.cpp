// A ship that turns by her rudder: against what ships do.
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "host/bodies/body_forces.h"
#include "host/bodies/floating_bodies.h"
#include "host/bodies/hull.h"
#include "host/bodies/panel_method.h"
#include "tests/bodies/example_bodies.h"

namespace offing::bodies {
namespace {

using std::numbers::pi;

/// The coaster of scenes/afloat.toml.
FloatingBody coaster() {
  TriangleMesh hull = test::ship(24.0, 24);
  const double level_m = extent_of(hull).low_m.y + 1.4;
  FloatingBody body = load_to_level("coaster", std::move(hull), level_m, test::sea_density_kgpm3);
  body.hydrodynamics = std::make_shared<const HydrodynamicData>(
      panel_method(body.hull, level_m, body.mass_centre_m, test::sea_density_kgpm3, 9.81, {.panels = 120}));
  body.start = at_rest(body, test::sea_density_kgpm3, 0.0, 0.0, 0.0);
  body.start.velocity_mps.x = 5.0;
  return body;
}

struct Turn {
  double speed_mps = 0.0;                    ///< before it
  double advance_m = 0.0, transfer_m = 0.0;  ///< along and across the first course, 90 degrees from it
  double tactical_diameter_m = 0.0;          ///< across it, 180 degrees from it
  double steady_diameter_m = 0.0, steady_mps = 0.0, drift_deg = 0.0;
};

Turn turn(const ocl::Device& device, FloatingBody body, float rudder_rad) {
  FloatingBodies floating(device, {body});
  constexpr double straight_s = 30.0, step_s = 0.5;
  const auto drive = [&](std::size_t, double time_s) {
    BodyDrive made{};
    made.thrust_n = 9e3f;
    made.rudder_rad = time_s < straight_s ? 0.0f : rudder_rad;
    return made;
  };
  floating.advance_to(straight_s, test::still_water(), drive);
  const BodyPose start = floating.read_poses().front();
  Turn turn;
  const double side = rudder_rad > 0.0f ? 1.0 : -1.0;
  turn.speed_mps = glm::length(start.velocity_mps);
  double turned_rad = 0.0, last_rad = heading_of(start);
  for (double time_s = straight_s + step_s; time_s < straight_s + 240.0; time_s += step_s) {
    floating.advance_to(time_s, test::still_water(), drive);
    const BodyPose pose = floating.read_poses().front();
    // As a turn to starboard.
    const double rate = side * std::remainder(heading_of(pose) - last_rad, 2.0 * pi), before_rad = turned_rad;
    last_rad = heading_of(pose);
    turned_rad += rate;
    const glm::dvec3 run_m = pose.mass_centre_m - start.mass_centre_m;
    if (before_rad < 0.5 * pi && turned_rad >= 0.5 * pi) {
      turn.advance_m = run_m.x;
      turn.transfer_m = side * run_m.z;
    }
    if (before_rad < pi && turned_rad >= pi) turn.tactical_diameter_m = side * run_m.z;
    if (turned_rad < 3.0 * pi) continue;
    turn.steady_mps = glm::length(pose.velocity_mps);
    turn.steady_diameter_m = 2.0 * turn.steady_mps * step_s / rate;
    const glm::dvec3 velocity_mps = glm::conjugate(pose.turn) * pose.velocity_mps;
    turn.drift_deg = std::atan2(-side * velocity_mps.z, velocity_mps.x) * 180.0 / pi;
    break;
  }
  return turn;
}

class TurningTest : public testing::Test {
 protected:
  const ocl::Device device_ = ocl::Device::open();
};

// Fails if she turns on the spot or hardly, drifts sideways, or turns better to one side. IMO's standards for
// ship manoeuvrability (2002) allow a tactical diameter of 5 lengths and an advance of 4.5; ships have 3 to 5
// and 2.5 to 4, drift by 8 to 12 degrees, and lose about half of their speed. Measured: 3.6, 2.8, 11.4 and
// 0.52.
TEST_F(TurningTest, CoasterTurnsAsShipsDo) {
  const float rudder_rad = 35.0f * static_cast<float>(pi) / 180.0f;
  const Turn starboard = turn(device_, coaster(), rudder_rad), port = turn(device_, coaster(), -rudder_rad);
  const double length_m = 24.6;  // of her water line
  EXPECT_GT(starboard.tactical_diameter_m, 3.0 * length_m);
  EXPECT_LT(starboard.tactical_diameter_m, 5.0 * length_m);
  EXPECT_GT(starboard.advance_m, 2.5 * length_m);
  EXPECT_LT(starboard.advance_m, 4.5 * length_m);
  EXPECT_GT(starboard.drift_deg, 8.0);
  EXPECT_LT(starboard.drift_deg, 12.0);
  EXPECT_NEAR(starboard.steady_mps / starboard.speed_mps, 0.5, 0.15);
  // Sums of faces in another order.
  EXPECT_NEAR(port.tactical_diameter_m, starboard.tactical_diameter_m, 0.02 * starboard.tactical_diameter_m);
  EXPECT_NEAR(port.drift_deg, starboard.drift_deg, 0.3);
}

// Fails if a sign, a factor or an axis of the derivatives is wrong: those of Clarke et al. 1983 for a box of
// 30 x 5 x 2 m under water that runs at 5 m/s. Cross-flow and friction add 5 % to the sway force, 2 % to the
// moment; limit 8 %.
TEST_F(TurningTest, BoxAtAnAngleHasTheForcesOfClarke) {
  const double l = 30.0, b = 5.0, t = 2.0, speed_mps = 5.0, sway_mps = 0.05, spin_radps = 0.004;
  FloatingBody body = load_to_level("box", test::box({l, 4.0, b}), 0.0, test::sea_density_kgpm3, 0.0);
  const double half = 0.5 * test::sea_density_kgpm3 * l * l * speed_mps, base = pi * t * t / (l * l);
  const auto report = [&](const glm::dvec3& velocity_mps, double about_up_radps) {
    body.start = at_rest(body, test::sea_density_kgpm3, 0.0, 0.0, 0.0);
    body.start.velocity_mps = velocity_mps;
    body.start.spin_radps = {0.0, about_up_radps, 0.0};
    FloatingBodies floating(device_, {body});
    floating.advance_to(1e-3, test::still_water());
    return floating.read_reports().front();
  };
  const BodyReport sway = report({speed_mps, 0.0, sway_mps}, 0.0);
  const double force_n = -half * sway_mps * base * (1.0 + 0.4 * b / t);
  EXPECT_NEAR(force_of(sway, BODY_DRAG).z, force_n, 0.08 * std::abs(force_n));
  const double moment_nm = half * l * sway_mps * base * (0.5 + 2.4 * t / l);
  EXPECT_NEAR(moment_of(sway, BODY_DRAG).y, moment_nm, 0.08 * std::abs(moment_nm));
  const BodyReport yaw = report({speed_mps, 0.0, 0.0}, spin_radps);
  // A turn about the axis up is one to port.
  const double side_n = half * l * spin_radps * base * (-0.5 + 2.2 * b / l - 0.08 * b / t);
  EXPECT_NEAR(force_of(yaw, BODY_DRAG).z, side_n, 0.08 * std::abs(force_n));
  const double turning_nm = -half * l * l * spin_radps * base * (0.25 + 0.039 * b / t - 0.56 * b / l);
  EXPECT_NEAR(moment_of(yaw, BODY_DRAG).y, turning_nm, 0.08 * std::abs(turning_nm));
}

// Fails if lift, cross-flow or the rudder does work on a ship that drifts and turns: her kinetic energy, with
// that of the water that she accelerates, falls. Waves and pitch give some of theirs back: at most 2 % of
// what she has, measured 0.
TEST_F(TurningTest, DriftingShipGainsNoEnergy) {
  for (const double ahead_mps : {4.0, -4.0}) {
    FloatingBody body = coaster();
    body.start.velocity_mps = {ahead_mps, 0.0, 2.0};
    body.start.spin_radps = {0.0, 0.15, 0.0};
    const HullMatrix& added = body.hydrodynamics->added_mass_at_infinity;
    FloatingBodies floating(device_, {body});
    const auto energy_j = [&](const BodyPose& pose) {
      const glm::dvec3 v = glm::conjugate(pose.turn) * pose.velocity_mps;
      const std::array<double, 6> u{v.x, v.y, v.z, pose.spin_radps.x, pose.spin_radps.y, pose.spin_radps.z};
      double sum = 0.5 * body.mass_kg * glm::dot(v, v) +
                   0.5 * glm::dot(pose.spin_radps, body.inertia_kgm2 * pose.spin_radps);
      for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) sum += 0.5 * added[6 * i + j] * u[i] * u[j];
      }
      return sum;
    };
    const double first_j = energy_j(body.start);
    double last_j = first_j;
    for (double time_s = 0.5; time_s < 20.0; time_s += 0.5) {
      floating.advance_to(time_s, test::still_water());
      const double now_j = energy_j(floating.read_poses().front());
      EXPECT_LT(now_j, last_j + 0.02 * first_j) << time_s;
      last_j = now_j;
    }
    EXPECT_LT(last_j, 0.5 * first_j);
  }
}

}  // namespace
}  // namespace offing::bodies
