#include "present/timeline/time_scale.h"

#include <cmath>

#include <gtest/gtest.h>

namespace offing::present {
namespace {

// Fails if a place on the strip is another time than the one drawn there, or a mouse beyond it leaves it.
TEST(TimeScaleTest, GoesThereAndBack) {
  const TimeScale scale{.span = {-2.0, 8.0}, .left_px = 100.0f, .width_px = 500.0f};
  EXPECT_FLOAT_EQ(scale.x_px(-2.0), 100.0f);
  EXPECT_FLOAT_EQ(scale.x_px(3.0), 350.0f);
  for (const double time_s : {-2.0, 0.0, 1.5, 8.0})
    EXPECT_NEAR(scale.time_s(scale.x_px(time_s)), time_s, 1e-5);
  EXPECT_EQ(scale.time_s(0.0f), -2.0);
  EXPECT_EQ(scale.time_s(9e3f), 8.0);
}

// Fails if the scene's span, a keyframe or the time is not on the timeline, or a scene without a span has
// none.
TEST(TimeScaleTest, ShowsAllThereIs) {
  scene::Scene scene;
  scene.time.start_s = 1.0;
  scene.time.end_s = 3.0;
  EXPECT_EQ(shown_span(scene, 2.0), (TimeSpan{1.0, 3.0}));
  EXPECT_EQ(shown_span(scene, 3.0), (TimeSpan{1.0, 3.0}));
  EXPECT_EQ(shown_span(scene, 6.0), (TimeSpan{1.0, 9.0}));
  EXPECT_EQ(shown_span(scene, 0.0), (TimeSpan{-1.0, 3.0}));
  scene.tracks[{"camera.x_m"}] = {.keys = {{-1.0, 0.0}, {7.0, 1.0}}};
  EXPECT_EQ(shown_span(scene, 2.0), (TimeSpan{-1.0, 7.0}));
  scene.tracks.clear();
  scene.time.end_s = 1.0;
  EXPECT_GT(shown_span(scene, 1.0).length_s(), 0.0);
  EXPECT_TRUE(std::isfinite(shown_span(scene, 1e8).end_s));
}

// Fails if marks are closer than they can be read, farther than the next round number, or no round numbers.
TEST(TimeScaleTest, MarksAreRound) {
  for (double length_s = 0.11; length_s < 1e8; length_s *= 1.7) {
    const TimeScale scale{.span = {0.0, length_s}, .left_px = 0.0f, .width_px = 640.0f};
    const double step_s = mark_step_s(scale, 64.0f), least_s = 0.1 * length_s;
    EXPECT_GE(step_s, least_s * (1.0 - 1e-12));
    EXPECT_LE(step_s, 2.51 * least_s);
    const double decade = std::pow(10.0, std::floor(std::log10(step_s) + 1e-9)), digit = step_s / decade;
    EXPECT_TRUE(std::abs(digit - 1.0) < 1e-9 || std::abs(digit - 2.0) < 1e-9 || std::abs(digit - 5.0) < 1e-9)
        << step_s;
  }
}

// Fails if the last frame is not the one that --frames makes last, or a mouse leaves the frames.
TEST(TimeScaleTest, KnowsFrames) {
  EXPECT_DOUBLE_EQ(last_frame_s({.frames_per_second = 10.0, .start_s = 0.0, .end_s = 2.0}), 1.9);
  EXPECT_DOUBLE_EQ(last_frame_s({.frames_per_second = 10.0, .start_s = 0.0, .end_s = 1.95}), 1.9);
  EXPECT_DOUBLE_EQ(last_frame_s({.frames_per_second = 1.0, .start_s = 3.0, .end_s = 3.0}), 3.0);
  EXPECT_DOUBLE_EQ(nearest_frame_s(1.03, 24.0), 25.0 / 24.0);
  EXPECT_FALSE(loop_span({.start_s = 2.0, .end_s = 2.0}));
  EXPECT_EQ(loop_span({.start_s = 1.0, .end_s = 2.0}), (TimeSpan{1.0, 2.0}));
}

}  // namespace
}  // namespace offing::present
