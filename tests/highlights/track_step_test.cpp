#include "host/highlights/tracks/track_step.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/highlights/example_surfaces.h"

namespace offing::highlights {
namespace {

using std::numbers::pi;

// A triangle of as large a box as a sphere of radius 1, and points anywhere in its plane z = 1.
class TrackStepTest : public testing::Test {
 protected:
  static test::ExampleSurface triangle() {
    constexpr std::size_t count = 3;
    return {.mesh = {.positions_m = {{0.0, 0.0, 1.0}, {side_m, 0.0, 1.0}, {0.0, side_m, 1.0}},
                     .normals = {},
                     .faces = {{0, 1, 2}}},
            .curvatures = {.k_max_per_m = std::vector<double>(count, 2.0),
                           .k_min_per_m = std::vector<double>(count, 1.0),
                           .e_max = std::vector<glm::dvec3>(count, {1.0, 0.0, 0.0}),
                           .e_min = std::vector<glm::dvec3>(count, {0.0, 1.0, 0.0}),
                           .area_m2 = std::vector<double>(count, 1.0),
                           .confidence = std::vector<double>(count, 1.0)}};
  }
  HighlightPoint point_at(double x_m, double y_m) const {
    HighlightPoint point;
    point.weights = {1.0 - (x_m + y_m) / side_m, x_m / side_m, y_m / side_m};
    point.position_m = place_on(shape_, point.face, point.weights);
    point.normal = {0.0, 0.0, 1.0};
    point.e_max = {1.0, 0.0, 0.0};
    point.k_max_per_m = 2.0;
    point.k_min_per_m = 1.0;
    return point;
  }

  static constexpr double side_m = 2.45;
  test::ExampleSurface triangle_ = triangle();
  HighlightSurface shape_{ocl::Device::open(), triangle_.mesh, triangle_.curvatures};
  TrackOptions options_{.size = {.threshold = 0.8, .cap_radius_m = 1.0}};
};

// Two that come together blend into the older one, and apart again: what they show is continuous, one alone
// when they are at one place, both when they are apart. Fails if both are drawn over one another, or if one
// pops.
TEST_F(TrackStepTest, HighlightsMergeAndSplitWithWeights) {
  const auto points = [this](double apart_m) {
    return std::vector<HighlightPoint>{point_at(0.0, 0.0), point_at(apart_m, 0.0)};
  };
  TrackState state = first_state(shape_, points(1.0), options_);
  EXPECT_EQ(state.tracks[1].opacity, 1.0);
  double least = 1.0, last = 1.0;
  for (int step = 0; step <= 400; ++step) {
    const double apart_m = std::abs(1.0 - step / 200.0);
    advance(shape_, points(apart_m), options_, state);
    ASSERT_EQ(state.tracks.size(), 2u);
    EXPECT_EQ(state.tracks[0].opacity, 1.0);
    EXPECT_LE(std::abs(state.tracks[1].opacity - last), 4.0 / 60.0 + 1e-12);
    last = state.tracks[1].opacity;
    least = std::min(least, last);
  }
  EXPECT_EQ(least, 0.0);
  EXPECT_EQ(last, 1.0);
}

// If the point of the one that is shown ends, it goes over to the other's. Fails if the region goes dark, or
// if the eye sees one highlight end and another begin.
TEST_F(TrackStepTest, TheHighlightGoesOverToAnotherPoint) {
  const HighlightPoint first = point_at(0.0, 0.0), second = point_at(0.05, 0.0);
  TrackState state = first_state(shape_, {first, second}, options_);
  ASSERT_EQ(state.tracks[1].opacity, 0.0);
  for (int step = 0; step < 30; ++step) {
    advance(shape_, {second}, options_, state);
    ASSERT_EQ(state.tracks.size(), 1u);
    EXPECT_EQ(state.tracks[0].id, 0u);
    EXPECT_EQ(state.tracks[0].opacity, 1.0);
  }
  EXPECT_EQ(state.tracks[0].projector.centre_m, second.position_m);
}

// A distance that wavers about the one at which two unite. Fails if the second one blinks: it has to come
// much nearer to vanish than to go to be back.
TEST_F(TrackStepTest, UnitingAndPartingNeedDifferentDistances) {
  options_.unite_share = options_.part_share = 0.0;
  const double unite_m = 0.5 * 0.6 * options_.unite_depth;  // half of the width, 2 * 0.6 / 2.0, is depth 1
  TrackState state = first_state(shape_, {point_at(0.0, 0.0), point_at(1.0, 0.0)}, options_);
  const auto opacity_at = [&](double apart_m) {
    for (int step = 0; step < 30; ++step)
      advance(shape_, {point_at(0.0, 0.0), point_at(apart_m, 0.0)}, options_, state);
    return state.tracks.at(1).opacity;
  };
  EXPECT_EQ(opacity_at(unite_m + 0.02), 1.0);
  EXPECT_EQ(opacity_at(unite_m - 0.02), 0.0);
  EXPECT_EQ(opacity_at(unite_m + 0.02), 0.0);
  EXPECT_EQ(opacity_at(unite_m * options_.part_depth / options_.unite_depth + 0.02), 1.0);
}

// A point that is gone after a tenth of a second. Fails if it is shown at all, or if one that was shown for
// an instant is.
TEST_F(TrackStepTest, HighlightsAreNotShownForAnInstant) {
  TrackState state = first_state(shape_, {}, options_);
  for (int step = 0; step < 6; ++step) {
    advance(shape_, {point_at(0.0, 0.0)}, options_, state);
    EXPECT_EQ(state.tracks.at(0).opacity, 0.0);
  }
  advance(shape_, {point_at(0.0, 0.0)}, options_, state);
  int shown_steps = 0;
  for (; shown_steps < 100 && !state.tracks.empty() && state.tracks[0].opacity > 0.0; ++shown_steps)
    advance(shape_, {}, options_, state);
  EXPECT_GE(shown_steps, 8 * 60 / 24);  // eight frames of a film
  EXPECT_LE(shown_steps, 32);
}

// The edge of a shadow may cross a small highlight within one step. Fails if it blinks then, if it is not
// gone in the end, if it comes back at once, or if rays are cast for one that would not be seen anyway.
TEST_F(TrackStepTest, ShadowsFadeHighlightsWithinTheLimits) {
  double lit = 1.0;
  int asked = 0;
  const LitShare lit_share = [&](const HighlightTrack&) {
    ++asked;
    return lit;
  };
  const std::vector<HighlightPoint> points{point_at(0.0, 0.0), point_at(0.01, 0.0)};
  TrackState state = first_state(shape_, points, options_, lit_share);
  ASSERT_EQ(state.tracks[0].opacity, 1.0);
  ASSERT_EQ(state.tracks[1].share, 0.0);
  double last = 1.0;
  for (int step = 0; step < 120; ++step) {
    lit = step < 60 ? 0.0 : 0.8;
    advance(shape_, points, options_, state, lit_share);
    EXPECT_LE(std::abs(state.tracks[0].opacity - last), 4.0 / 60.0 + 1e-12);
    last = state.tracks[0].opacity;
    if (step == 9) {
      EXPECT_EQ(asked, 11);
    }
    if (step == 59) {
      EXPECT_EQ(last, 0.0);
    }
  }
  EXPECT_NEAR(last, 0.8, 1e-12);
  // Just below, it stays as it is; hidden, it stays hidden.
  lit = 0.3;
  for (int step = 0; step < 30; ++step) advance(shape_, points, options_, state, lit_share);
  EXPECT_NEAR(state.tracks[0].opacity, 0.3, 1e-12);
  lit = 0.1;
  for (int step = 0; step < 30; ++step) advance(shape_, points, options_, state, lit_share);
  lit = 0.3;
  for (int step = 0; step < 30; ++step) advance(shape_, points, options_, state, lit_share);
  EXPECT_EQ(state.tracks[0].opacity, 0.0);
  // One that begins in the dark is not shown.
  lit = 0.0;
  EXPECT_EQ(first_state(shape_, points, options_, lit_share).tracks[0].opacity, 0.0);
}

// A point that a noisy surface loses for some steps is the same when it is back; one that has faded out is
// another.
TEST_F(TrackStepTest, AHighlightThatIsBackSoonKeepsItsId) {
  const std::vector<HighlightPoint> points{point_at(0.0, 0.0)};
  TrackState state = first_state(shape_, points, options_);
  for (int step = 0; step < 5; ++step) advance(shape_, {}, options_, state);
  advance(shape_, points, options_, state);
  ASSERT_EQ(state.tracks.size(), 1u);
  EXPECT_EQ(state.tracks[0].id, 0u);
  for (int step = 0; step < 60; ++step) advance(shape_, {}, options_, state);
  EXPECT_TRUE(state.tracks.empty());
  advance(shape_, points, options_, state);
  EXPECT_EQ(state.tracks[0].id, 1u);
}

// Humps and saddles are born in pairs at one place: fails if one takes the other's id.
TEST_F(TrackStepTest, HumpsAndSaddlesAreNotTakenForOneAnother) {
  HighlightPoint saddle = point_at(0.01, 0.0);
  saddle.orientation = -1;
  TrackState state = first_state(shape_, {point_at(0.0, 0.0), saddle}, options_);
  HighlightPoint moved_saddle = point_at(0.0, 0.01);
  moved_saddle.orientation = -1;
  advance(shape_, {moved_saddle, point_at(0.01, 0.0)}, options_, state);
  ASSERT_EQ(state.tracks.size(), 2u);
  EXPECT_EQ(state.tracks[0].point.orientation, 1);
  EXPECT_EQ(state.tracks[1].point.orientation, -1);
}

// Directions of curvature are lines. Fails if a texture turns over when the search gives the other end of
// one, or spins where curvatures are so alike that noise decides about their direction.
TEST_F(TrackStepTest, AxesDoNotTurnOverNorFollowNoise) {
  HighlightPoint point = point_at(0.0, 0.0);
  TrackState state = first_state(shape_, {point}, options_);
  const Projector start = state.tracks[0].projector;
  for (int step = 0; step < 50; ++step) {
    point.e_max = -point.e_max;
    advance(shape_, {point}, options_, state);
    EXPECT_EQ(state.tracks[0].projector, start);
  }
  test::RandomVectors random(31);
  point.k_min_per_m = 0.97 * point.k_max_per_m;
  for (int step = 0; step < 50; ++step) {
    const double angle = 2.0 * pi * random.uniform();
    point.e_max = {std::cos(angle), std::sin(angle), 0.0};
    advance(shape_, {point}, options_, state);
    EXPECT_LE(glm::distance(state.tracks[0].projector.right, start.right), 1e-12);
  }
}

// What is shown follows a point that runs, tilts, turns and shrinks faster than the limits, and arrives.
// Fails if a limit is exceeded in any step, or if it never gets there.
TEST_F(TrackStepTest, LimitsHoldAndThePointIsReached) {
  TrackState state = first_state(shape_, {point_at(0.0, 0.0)}, options_);
  HighlightPoint point = point_at(0.0, 0.1);
  point.normal = glm::normalize(glm::dvec3(0.5, 0.3, 1.0));
  point.e_max = glm::normalize(glm::cross(glm::dvec3(0.3, -1.0, 0.2), point.normal));
  point.k_max_per_m = 40.0;
  point.k_min_per_m = 10.0;
  const double limit_m = 0.45 / 60.0 * shape_.diagonal_m();
  int steps_until_there = 0;
  for (int step = 0; step < 120; ++step) {
    const Projector before = state.tracks[0].projector;
    advance(shape_, {point}, options_, state);
    ASSERT_EQ(state.tracks.size(), 1u);
    const Projector& after = state.tracks[0].projector;
    EXPECT_LE(glm::distance(before.centre_m, after.centre_m), limit_m * (1.0 + 1e-12));
    EXPECT_LE(std::abs(std::log(after.width_m / before.width_m)), 2.4 / 60.0 + 1e-12);
    EXPECT_LE(std::abs(std::log(after.height_m / before.height_m)), 2.4 / 60.0 + 1e-12);
    const double cosine = 0.5 * (glm::dot(before.right, after.right) + glm::dot(before.up, after.up) +
                                 glm::dot(before.normal, after.normal) - 1.0);
    // Near 1 the arc cosine loses half of the digits.
    EXPECT_LE(std::acos(std::min(cosine, 1.0)), 2.094 / 60.0 + 1e-7);
    EXPECT_LE(glm::distance(glm::cross(after.right, after.up), after.normal), 1e-14);
    if (glm::distance(after.centre_m, point.position_m) > 0.0) steps_until_there = step + 1;
  }
  EXPECT_EQ(steps_until_there, static_cast<int>(0.1 / limit_m));
  const Projector& end = state.tracks[0].projector;
  EXPECT_LE(glm::distance(end.normal, point.normal), 1e-12);
  EXPECT_NEAR(std::abs(glm::dot(end.right, point.e_max)), 1.0, 1e-12);
  EXPECT_NEAR(end.width_m, 2.0 * 0.6 / 40.0, 1e-9);
}

}  // namespace
}  // namespace offing::highlights
