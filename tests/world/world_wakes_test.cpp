// Wakes in a world: seen by its queries, the same however its frames fall, about an eye.
#include "host/world/world_wakes.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/world/world.h"

namespace offing::world {
namespace {

// A slight sea of 10 cm, and a hull of 1 m draught that has come from the west at 4 m/s to the origin at time
// 0.
WorldParameters with_wake() {
  ocean::SpectrumParameters spectrum;
  spectrum.wind_speed_mps = 2.0;
  WorldParameters result;
  result.spectrum = ocean::make_sea_spectrum(spectrum);
  result.ocean.size = 32;
  result.ocean.cascades = ocean::cascades_from_patches(std::array{20.0}, 32);
  WakeSettings wake{.parameters = {.cells = 64, .length_m = 64.0, .step_s = 0.05}, .history_s = 6.0};
  wake.forcing_at = [](double time_s) {
    const double x_m = 4.0 * time_s;
    return ocean::WakeForcing{.centre = {x_m, 0.0},
                              .hulls = {{.x_m = x_m, .length_m = 8.0, .beam_m = 4.0, .draught_m = 1.0}}};
  };
  result.wakes = {wake};
  return result;
}

double height_m(World& world, double x_m, double z_m) {
  const std::array points{ocean::WaterPoint{x_m, z_m}};
  return world.sample(points).front().height_m;
}

// Fails if queries of a world do not see its wakes, or see them elsewhere than where the hull is: a hollow
// under it.
TEST(WorldWakesTest, QueriesSeeAHullsHollow) {
  World world(ocl::Device::open(), with_wake());
  for (const double time_s : {0.0, 3.0, 100.0}) {
    world.at(time_s, 2.0);
    EXPECT_LT(height_m(world, 4.0 * time_s, 0.0), -0.4) << time_s;
    EXPECT_GT(height_m(world, 4.0 * time_s, 200.0), -0.2) << time_s;
  }
  world.set_wakes({});
  world.at(100.0, 2.0);
  EXPECT_GT(height_m(world, 400.0, 0.0), -0.2);
  EXPECT_EQ(world.wakes(), nullptr);
}

// Fails if the wake of a time depends on the frames in between, or on what was shown before a leap back.
TEST(WorldWakesTest, IsTheSameHoweverFramesFall) {
  const ocl::Device device = ocl::Device::open();
  WorldWakes steady(device, with_wake().wakes), irregular(device, with_wake().wakes);
  for (const double time_s : {1.0, 2.5}) steady.at(time_s, {});
  for (const double time_s : {40.0, 1.0, 1.01, 1.33, 1.9, 2.5}) irregular.at(time_s, {});
  EXPECT_EQ(steady.windows()[0].read_state().height_m, irregular.windows()[0].read_state().height_m);
}

// Fails if a wake that catches up in many frames ends as another one, never ends, or is not shown meanwhile.
TEST(WorldWakesTest, CatchesUpWithItsHistory) {
  const ocl::Device device = ocl::Device::open();
  WorldWakes at_once(device, with_wake().wakes), in_parts(device, with_wake().wakes);
  at_once.at(2.5, {});
  EXPECT_FALSE(at_once.is_behind());
  in_parts.set_most_steps(10);  // of the 120 of its history
  int frames = 0;
  do {
    in_parts.at(2.5, {});
    if (frames == 6) {
      const double x_m = 4.0 * in_parts.windows()[0].time_s();
      EXPECT_LT(x_m, 8.0) << "it has come too far";
    }
    ASSERT_LT(++frames, 20) << "it never catches up";
  } while (in_parts.is_behind());
  EXPECT_EQ(frames, 12);
  EXPECT_EQ(in_parts.windows()[0].read_state().height_m, at_once.windows()[0].read_state().height_m);
  // A window whose steps are shorter than frames stays with them.
  in_parts.set_most_steps(1);
  in_parts.at(2.9, {});
  EXPECT_FALSE(in_parts.is_behind());
}

// Fails if a window about the eye stays where it was.
TEST(WorldWakesTest, FollowsTheEye) {
  WorldParameters parameters = with_wake();
  parameters.wakes[0].is_about_eye = true;
  parameters.wakes[0].history_s = 0.5;
  parameters.wakes[0].forcing_at = [](double) { return ocean::WakeForcing{}; };
  WorldWakes view(ocl::Device::open(), parameters.wakes);
  view.at(0.0, {100.0, -50.0});
  view.at(0.2, {110.0, -50.0});
  EXPECT_EQ(view.windows()[0].grid().first_column, 110 - 32);
  EXPECT_EQ(view.windows()[0].grid().first_row, -50 - 32);
}

}  // namespace
}  // namespace offing::world
