// Submerged parts in still water, against closed forms.
#include "host/bodies/hydrostatics.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/bodies/floating_body.h"
#include "tests/bodies/example_bodies.h"

namespace offing::bodies {
namespace {

// Fails if cut faces are integrated wrongly.
TEST(SubmergedTest, Box) {
  const Submerged found = submerged_below(test::box({4.0, 2.0, 3.0}), -0.4);
  EXPECT_NEAR(found.volume_m3, 4.0 * 3.0 * 0.6, 1e-12);
  EXPECT_NEAR(found.centre_m.y, -0.7, 1e-12);
  EXPECT_NEAR(found.plane_m2, 12.0, 1e-12);
  EXPECT_NEAR(found.plane_xx_m4, 3.0 * 64.0 / 12.0, 1e-11);
  EXPECT_NEAR(found.plane_zz_m4, 4.0 * 27.0 / 12.0, 1e-11);
}

// Fails if the cap of a sphere is not pi h^2 (R - h / 3): an icosphere of level 6 has 0.04 % less.
TEST(SubmergedTest, Sphere) {
  const TriangleMesh sphere = test::ball(2.0, 6);
  for (const double level_m : {-1.5, -0.3, 0.0, 1.2}) {
    const double h = level_m + 2.0;
    const double volume_m3 = std::numbers::pi * h * h * (2.0 - h / 3.0);
    EXPECT_NEAR(submerged_below(sphere, level_m).volume_m3 / volume_m3, 1.0, 1e-3) << level_m;
    const double radius2 = 4.0 - level_m * level_m;
    EXPECT_NEAR(submerged_below(sphere, level_m).plane_m2 / (std::numbers::pi * radius2), 1.0, 1e-3)
        << level_m;
  }
}

// Fails if the search for the draught ends early, or takes a mass that sinks.
TEST(SubmergedTest, LevelFollowsFromVolume) {
  const TriangleMesh hull = test::ship(30.0);
  for (const double level_m : {-1.5, 0.0, 0.7}) {
    const double volume_m3 = submerged_below(hull, level_m).volume_m3;
    EXPECT_NEAR(level_that_displaces(hull, volume_m3, "ship"), level_m, 1e-9);
  }
  EXPECT_THROW(level_that_displaces(hull, 1e6, "ship"), Error);
  EXPECT_THROW(level_that_displaces(hull, 0.0, "ship"), Error);
  EXPECT_THROW(level_that_displaces(hull, std::nan(""), "ship"), Error);
}

// Fails if a loaded body would not stay upright: the metacentre, I / V above the centre of buoyancy, stands
// over the mass centre.
TEST(SubmergedTest, LoadedShipsAreStable) {
  const FloatingBody body = load_to_level("ship", test::ship(30.0), 0.0, test::sea_density_kgpm3);
  const Submerged below = submerged_below(body.hull, 0.0);
  EXPECT_NEAR(body.mass_kg, test::sea_density_kgpm3 * below.volume_m3, 1e-6);
  EXPECT_GT(below.plane_zz_m4 / below.volume_m3, body.mass_centre_m.y - below.centre_m.y);
  const BodyPose pose = at_rest(body, test::sea_density_kgpm3, 3.0, -4.0, 0.5);
  EXPECT_NEAR(pose.mass_centre_m.y, body.mass_centre_m.y, 1e-9);
  EXPECT_NEAR(heading_of(pose), 0.5, 1e-12);
}

// Fails if a body is refused for a propeller or a rudder that nobody gave it: a raft that is 0.1 mm deep in
// the water, or an island of 600 m.
TEST(FloatingBodyTest, MayDrawLittleOrMuch) {
  EXPECT_NO_THROW(
      require_valid(load_to_level("raft", test::box({2.0, 2.0, 2.0}), -0.9999, test::sea_density_kgpm3)));
  EXPECT_NO_THROW(require_valid(
      load_to_level("island", test::box({1000.0, 800.0, 1000.0}), 200.0, test::sea_density_kgpm3)));
}

}  // namespace
}  // namespace offing::bodies
