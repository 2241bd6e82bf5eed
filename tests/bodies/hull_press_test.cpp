// What floating hulls press aside in a wake window, and paths that lead them.
#include "host/bodies/hull_press.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "host/bodies/path_drive.h"
#include "host/ocl/device.h"
#include "tests/bodies/example_bodies.h"

namespace offing::bodies {
namespace {

constexpr int cells = 64;
constexpr float cell_m = 0.5f;

class HullPressTest : public testing::Test {
 protected:
  std::vector<float> displaced_by(const HullPresser& hull, const BodyPose& pose, double share = 1.0,
                                  const WakeGrid& grid = {cells, -32, -32, cell_m}) {
    ocl::Buffer<float> displaced(device_, std::size_t{cells} * cells, "displaced");
    displaced.fill(0.0f);
    hull.press(pose, share, grid, displaced);
    return displaced.read();
  }

  static double volume_m3(const std::vector<float>& displaced) {
    return std::accumulate(displaced.begin(), displaced.end(), 0.0) * static_cast<double>(cell_m * cell_m);
  }

  const ocl::Device device_ = ocl::Device::open();
};

// Fails if a hull presses another volume than it displaces, whichever way it is turned and wherever it stands
// between cells. The map has 1 % steps of a ship's outline, and each cell 16 samples of it: measured 0.5 %,
// gate 2 %.
TEST_F(HullPressTest, PressesWhatItDisplaces) {
  const TriangleMesh ship = test::ship(12.0);
  const HullPresser hull(device_, map_of_hull(ship), {0.0, 0.3, 0.0});
  for (int i = 0; i < 8; ++i) {
    BodyPose pose{.mass_centre_m = {0.13 * i, 0.2, -0.31 * i},
                  .turn = turn_of_heading(0.8 * i) * glm::angleAxis(0.1 * i, glm::dvec3(1.0, 0.0, 0.0)),
                  .displaced_m3 = 2.0 + i};
    // A hull that heels casts a shorter shadow.
    const double shadow = (pose.turn * glm::dvec3(0.0, 1.0, 0.0)).y;
    EXPECT_NEAR(volume_m3(displaced_by(hull, pose)) / (shadow * pose.displaced_m3), 1.0, 0.02) << i;
    EXPECT_NEAR(volume_m3(displaced_by(hull, pose, 0.5)) / (0.5 * shadow * pose.displaced_m3), 1.0, 0.02)
        << i;
  }
}

// Fails if a hull presses elsewhere than where it is: a box of 4 x 2 x 3 m with its mass centre at (10, -5),
// heading south, covers 3 m along x and 4 m along z.
TEST_F(HullPressTest, PressesWhereItIs) {
  const HullPresser hull(device_, map_of_hull(test::box({4.0, 2.0, 3.0})), {0.0, 0.0, 0.0});
  const BodyPose pose{.mass_centre_m = {10.0, 0.0, -5.0},
                      .turn = turn_of_heading(std::numbers::pi / 2.0),
                      .displaced_m3 = 12.0};
  const std::vector<float> displaced = displaced_by(hull, pose, 1.0, {cells, -20, -40, cell_m});
  const auto at = [&](double x_m, double z_m) {
    const int column = static_cast<int>(std::lround(x_m / cell_m)) & (cells - 1);
    const int row = static_cast<int>(std::lround(z_m / cell_m)) & (cells - 1);
    return displaced[static_cast<std::size_t>(row * cells + column)];
  };
  EXPECT_NEAR(at(10.0, -5.0), 1.0, 1e-3);
  EXPECT_NEAR(at(10.0, -6.5), 1.0, 1e-3);
  EXPECT_EQ(at(10.0, -7.5), 0.0f);
  EXPECT_NEAR(at(11.0, -5.0), 1.0, 1e-3);
  EXPECT_EQ(at(12.0, -5.0), 0.0f);
}

// Fails if what is beside the window is written into it, or what displaces nothing presses.
TEST_F(HullPressTest, LeavesTheRestOfTheWindow) {
  const HullPresser hull(device_, map_of_hull(test::box({4.0, 2.0, 3.0})), {0.0, 0.0, 0.0});
  const BodyPose away{.mass_centre_m = {1000.0, 0.0, 0.0}, .displaced_m3 = 12.0};
  EXPECT_EQ(volume_m3(displaced_by(hull, away)), 0.0);
  const BodyPose at_edge{.mass_centre_m = {-16.0, 0.0, 0.0}, .displaced_m3 = 12.0};
  const double half_m3 = volume_m3(displaced_by(hull, at_edge));
  EXPECT_GT(half_m3, 5.0);
  EXPECT_LT(half_m3, 7.5);
  EXPECT_EQ(volume_m3(displaced_by(hull, {})), 0.0);
}

// Fails if a level is not that of its volume: a box of 12 m2 stands 1 m deep with 12 m3.
TEST_F(HullPressTest, FindsTheLevel) {
  const HullPresser hull(device_, map_of_hull(test::box({4.0, 2.0, 3.0})), {0.0, 0.0, 0.0});
  EXPECT_NEAR(hull.level_m(12.0), 0.0, 1e-6);
  EXPECT_NEAR(hull.level_m(3.0), -0.75, 1e-6);
  EXPECT_NEAR(hull.level_m(0.0), -1.0, 1e-6);
  EXPECT_NEAR(hull.level_m(1e3), 1.0, 1e-6);
}

// Fails if a path's places or speeds are not those of its end, or a heading that passes half a turn spins the
// body around.
TEST(PathDriveTest, LeadsToThePathsPlace) {
  const Path path = [](double time_s) {
    return PathPlace{500.0 + 3.0 * time_s, -2.0 * time_s, 3.1 + 0.5 * time_s};
  };
  const double step_s = 1.0 / 120.0;
  const BodyDrive drive = drive_along(path, 0.1);
  EXPECT_EQ(drive.follows_path, 1);
  EXPECT_NEAR(64.0 * drive.tile_x + static_cast<double>(drive.x_m), 500.0 + 3.0 * (0.1 + step_s), 1e-4);
  EXPECT_NEAR(drive.z_m, -2.0 * (0.1 + step_s), 1e-6);
  EXPECT_NEAR(drive.velocity_x_mps, 3.0, 1e-5);
  EXPECT_NEAR(drive.velocity_z_mps, -2.0, 1e-5);
  EXPECT_NEAR(drive.heading_rate_radps, 0.5, 1e-5);
  EXPECT_NEAR(drive.heading_rad, 3.15 + 0.5 * step_s - 2.0 * std::numbers::pi, 1e-5);
}

}  // namespace
}  // namespace offing::bodies
