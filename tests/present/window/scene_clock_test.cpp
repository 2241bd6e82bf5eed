#include "present/window/scene_clock.h"

#include <gtest/gtest.h>

namespace offing::present {
namespace {

// Fails if time does not run with the wall clock at its scale.
TEST(SceneClockTest, RunsAtItsScale) {
  SceneClock clock(10.0);
  clock.advance(0.1);
  EXPECT_DOUBLE_EQ(clock.time_s(), 10.1);
  clock.set_scale(0.5);
  clock.advance(0.1);
  EXPECT_DOUBLE_EQ(clock.time_s(), 10.15);
}

// Fails if a pause does not hold, or a step does not pause.
TEST(SceneClockTest, PausesAndSteps) {
  SceneClock clock(0.0);
  clock.step(0.08);
  clock.advance(0.2);
  EXPECT_TRUE(clock.is_paused());
  EXPECT_DOUBLE_EQ(clock.time_s(), 0.08);
  clock.step(-0.04);
  EXPECT_DOUBLE_EQ(clock.time_s(), 0.04);
  clock.toggle_pause();
  clock.advance(0.2);
  EXPECT_DOUBLE_EQ(clock.time_s(), 0.24);
}

// Fails if a loop is left at its end, or begins anew elsewhere than at its begin.
TEST(SceneClockTest, Loops) {
  const TimeSpan loop{1.0, 1.5};
  SceneClock clock(1.45);
  clock.advance(0.1, loop);
  EXPECT_NEAR(clock.time_s(), 1.05, 1e-12);
  clock.advance(0.1, loop);
  EXPECT_NEAR(clock.time_s(), 1.15, 1e-12);
  clock.set_scale(16.0);
  clock.advance(0.25, loop);
  EXPECT_NEAR(clock.time_s(), 1.15, 1e-12) << "eight times around";
  clock.set_scale(1.0);
  clock.set_time(0.0);
  clock.advance(0.1, loop);
  EXPECT_NEAR(clock.time_s(), 0.1, 1e-12) << "what is before it leads into it";
}

// Fails if the sea jumps after the window stood still, or a clock that was set back turns time around.
TEST(SceneClockTest, DoesNotJump) {
  SceneClock clock(0.0);
  clock.advance(60.0);
  EXPECT_LE(clock.time_s(), 0.25);
  const double before_s = clock.time_s();
  clock.advance(-1.0);
  EXPECT_EQ(clock.time_s(), before_s);
}

}  // namespace
}  // namespace offing::present
