#include "present/scale_ladder.h"

#include <gtest/gtest.h>

namespace offing::present {
namespace {

/// Frames of a picture whose rays take so long where all are cast, and all else so long.
void draw(ScaleLadder& ladder, int frames, double rays_ms, double rest_ms, double wanted_ms) {
  for (int i = 0; i < frames; ++i) {
    const double now_ms = rays_ms * ray_shares[ladder.rung()];
    ladder.note(now_ms + rest_ms, now_ms, wanted_ms);
  }
}

// Fails if frames that take too long stay so, or ones that are quick stay coarse.
TEST(ScaleLadderTest, GoesToTheRungThatFits) {
  ScaleLadder ladder;
  draw(ladder, 80, 40.0, 5.0, 33.0);
  EXPECT_EQ(ladder.rung(), 2u) << "30 + 5 ms are too long, 20 + 5 ms fit";
  draw(ladder, 80, 200.0, 5.0, 33.0);
  EXPECT_EQ(ladder.rung(), 3u) << "the coarsest there is";
  draw(ladder, 80, 10.0, 5.0, 33.0);
  EXPECT_EQ(ladder.rung(), 0u);
}

// Fails if two rungs take turns, of which the finer one just does not fit.
TEST(ScaleLadderTest, StaysWhereItIs) {
  ScaleLadder ladder;
  for (const double rays_ms : {28.5, 30.0, 38.0, 40.0}) {
    draw(ladder, 80, rays_ms, 5.0, 33.0);
    const std::size_t rung = ladder.rung();
    for (int i = 0; i < 40; ++i) {
      draw(ladder, 1, rays_ms, 5.0, 33.0);
      ASSERT_EQ(ladder.rung(), rung) << rays_ms;
    }
  }
}

// Fails if a single frame that stood still makes the picture coarse.
TEST(ScaleLadderTest, ForgivesSingleFrames) {
  ScaleLadder ladder;
  draw(ladder, 3, 10.0, 5.0, 33.0);
  ladder.note(100.0, 10.0, 33.0);
  draw(ladder, 20, 10.0, 5.0, 33.0);
  EXPECT_EQ(ladder.rung(), 0u);
}

// Fails if a rung does not cast its share of the rays.
TEST(ScaleLadderTest, ScalesSidesByTheRoot) {
  for (std::size_t rung = 0; rung < ray_shares.size(); ++rung) {
    const double scale = ScaleLadder::side_scale(rung);
    EXPECT_NEAR(scale * scale, ray_shares[rung], 1e-12);
  }
}

}  // namespace
}  // namespace offing::present
