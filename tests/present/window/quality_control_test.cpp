#include "present/window/quality_control.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "host/clouds/particles/particle_thinning.h"

namespace offing::present {
namespace {

constexpr double wanted_ms = 50.0;

/// Frames for so many seconds that take `frame_ms` on the quality control's quality level; returns how often
/// it moved, and fails where it moved twice within two seconds.
int draw(QualityControl& control, double& now_s, double seconds, const std::function<double()>& frame_ms) {
  int moves = 0;
  double moved_s = -1e9;
  for (const double end_s = now_s + seconds; now_s < end_s;) {
    const double ms = frame_ms();
    now_s += 1e-3 * std::fmax(ms, 5.0);
    const std::size_t before = control.level();
    control.note(ms, wanted_ms, now_s);
    if (control.level() == before) continue;
    EXPECT_GE(now_s - moved_s, 2.0);
    moved_s = now_s;
    ++moves;
  }
  return moves;
}

/// A frame of which so much follows the picture's pixels.
double frame_ms(const QualityControl& control, double pixels_ms, double rest_ms) {
  const double side = control.quality().side_share;
  return pixels_ms * side * side + rest_ms;
}

// Fails if frames that take too long stay so, or ones that are quick stay coarse.
TEST(QualityControlTest, GoesToALevelThatFits) {
  QualityControl control;
  double now_s = 0.0;
  draw(control, now_s, 40.0, [&] { return frame_ms(control, 120.0, 10.0); });
  EXPECT_LE(frame_ms(control, 120.0, 10.0), wanted_ms);
  EXPECT_GE(control.quality().side_share, 0.4) << "coarser than is needed";
  draw(control, now_s, 60.0, [&] { return frame_ms(control, 2000.0, 10.0); });
  EXPECT_EQ(control.level(), quality_levels.size() - 1) << "the coarsest there is";
  draw(control, now_s, 120.0, [&] { return frame_ms(control, 20.0, 5.0); });
  EXPECT_EQ(control.level(), 0u);
}

// Fails if two quality levels take turns, of which the finer one just does not fit.
TEST(QualityControlTest, StaysWhereItIs) {
  for (const double pixels_ms : {43.0, 60.0, 75.0, 90.0, 130.0, 200.0}) {
    QualityControl control;
    double now_s = 0.0;
    draw(control, now_s, 40.0, [&] { return frame_ms(control, pixels_ms, 8.0); });
    // One that is remembered not to have fitted is tried again later, which takes two moves.
    EXPECT_LE(draw(control, now_s, 60.0, [&] { return frame_ms(control, pixels_ms, 8.0); }), 4) << pixels_ms;
  }
}

// Fails if a scene whose first seconds are slow, as when kernels are still built, stays coarse for long.
TEST(QualityControlTest, ComesBackFromASlowStart) {
  QualityControl control;
  double now_s = 0.0;
  draw(control, now_s, 8.0, [&] { return frame_ms(control, 120.0, 60.0); });
  EXPECT_EQ(control.level(), quality_levels.size() - 1);
  draw(control, now_s, 15.0, [&] { return frame_ms(control, 20.0, 5.0); });
  EXPECT_EQ(control.level(), 0u);
}

// Fails if a single frame that stood still makes the picture coarse.
TEST(QualityControlTest, ForgivesSingleFrames) {
  QualityControl control;
  double now_s = 0.0;
  int count = 0;
  draw(control, now_s, 30.0, [&] { return ++count % 100 == 0 ? 150.0 : 20.0; });
  EXPECT_EQ(control.level(), 0u);
  // A scene that is opened, a picture that is written.
  draw(control, now_s, 30.0, [&] { return ++count % 100 == 0 ? 3000.0 : 40.0; });
  EXPECT_EQ(control.level(), 0u);
}

// Fails if a quality level is finer than one before it in anything.
TEST(QualityControlTest, LevelsAreCoarserFromOneToTheNext) {
  for (std::size_t i = 1; i < quality_levels.size(); ++i) {
    const Quality &finer = quality_levels[i - 1], &coarser = quality_levels[i];
    EXPECT_LE(coarser.side_share, finer.side_share);
    EXPECT_LE(coarser.side_share * coarser.side_share * coarser.ray_share,
              finer.side_share * finer.side_share * finer.ray_share);
    EXPECT_LE(coarser.grid_share, finer.grid_share);
    EXPECT_LE(coarser.views_share, finer.views_share);
    EXPECT_LE(coarser.mirrors_finely, finer.mirrors_finely);
    EXPECT_GE(coarser.sea_halvings, finer.sea_halvings);
    EXPECT_GE(coarser.cloud_halvings, finer.cloud_halvings);
    EXPECT_GE(coarser.light_lag.altitude_share, finer.light_lag.altitude_share);
    EXPECT_GE(coarser.light_lag.cloud_rad, finer.light_lag.cloud_rad);
    EXPECT_GE(coarser.light_lag.cloud_steps, finer.light_lag.cloud_steps);
    EXPECT_GE(coarser.light_lag.cloud_light_frames, finer.light_lag.cloud_light_frames);
    EXPECT_GE(coarser.light_lag.cloud_parts, finer.light_lag.cloud_parts);
    EXPECT_FALSE(coarser == finer);
  }
  EXPECT_EQ(quality_levels.back().cloud_halvings, clouds::most_particle_halvings) << "clouds refuse more";
}

// Fails if a share of a small number is nothing.
TEST(QualityControlTest, LeavesTheLeast) {
  EXPECT_EQ(share_of(128, 0.5, 16), 64);
  EXPECT_EQ(share_of(20, 0.25, 16), 16);
  EXPECT_EQ(share_of(8, 0.25, 16), 8) << "what is less already stays";
}

}  // namespace
}  // namespace offing::present
