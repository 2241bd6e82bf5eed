#include "host/highlights/highlight_tracks.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/highlights/nearest_face.h"
#include "host/highlights/track_step.h"
#include "tests/highlights/example_surfaces.h"

namespace offing::highlights {
namespace {

constexpr double pi = std::numbers::pi;

class HighlightTracksTest : public testing::Test {
 protected:
  HighlightSurface surface(const test::ExampleSurface& example) const {
    return {device_, example.mesh, example.curvatures};
  }
  /// A lamp far away that circles about y once in 10 s, and an eye far away.
  static Lighting circling(double time_s) {
    const double angle = 2.0 * pi * time_s / 10.0;
    return {{Source::Kind::direction, {0.0, 1.0, 0.5}},
            {{Source::Kind::direction, {std::cos(angle), 0.3, std::sin(angle)}}}};
  }

  ocl::Device device_ = ocl::Device::open();
};

// Fails if identity is lost while a highlight goes around, or if what is shown is not where the point is.
TEST_F(HighlightTracksTest, AHighlightKeepsItsIdAllTheWayAround) {
  const HighlightSurface shape = surface(test::ellipsoid(4, {1.0, 0.8, 0.9}));
  HighlightTracks tracks(shape, circling);
  for (int frame = 0; frame <= 600; ++frame) {
    tracks.advance_to(frame / 60.0);
    ASSERT_EQ(tracks.tracks().size(), 1u);
    const HighlightTrack& track = tracks.tracks()[0];
    ASSERT_EQ(track.id, 0u);
    ASSERT_EQ(track.opacity, 1.0);
    ASSERT_EQ(track.projector.centre_m, track.point.position_m);
  }
}

// Once around and home: the same place and sizes as at the start within 1e-5. Fails if anything adds up on
// the way.
TEST_F(HighlightTracksTest, RoundTripsEndWhereTheyBegan) {
  const HighlightSurface shape = surface(test::ellipsoid(4, {1.0, 0.5, 0.75}));
  HighlightTracks tracks(shape, [](double time_s) { return circling(std::min(time_s, 10.0)); });
  const Projector start = tracks.tracks()[0].projector;
  tracks.advance_to(10.5);
  ASSERT_EQ(tracks.tracks().size(), 1u);
  const Projector& end = tracks.tracks()[0].projector;
  EXPECT_LE(glm::distance(end.centre_m, start.centre_m), 1e-5 * shape.diagonal_m());
  EXPECT_NEAR(end.width_m, start.width_m, 1e-5 * start.width_m);
  EXPECT_NEAR(end.height_m, start.height_m, 1e-5 * start.height_m);
  EXPECT_NEAR(std::abs(glm::dot(end.right, start.right)), 1.0, 1e-5);
}

// A lamp that jumps leaves its highlight behind, which fades out there; another fades in. Fails if one is
// dragged over the surface, or pops.
TEST_F(HighlightTracksTest, AJumpOfTheLampFadesFromOneToAnother) {
  const HighlightSurface shape = surface(test::ellipsoid(4, glm::dvec3(1.0)));
  HighlightTracks tracks(shape, [](double time_s) { return circling(time_s < 1.0 ? 0.0 : 5.0); });
  tracks.advance_to(0.99);
  const glm::dvec3 old_m = tracks.tracks()[0].projector.centre_m;
  double last[2] = {1.0, 0.0};
  for (int frame = 60; frame < 60 + 14; ++frame) {
    tracks.advance_to(frame / 60.0);
    ASSERT_EQ(tracks.tracks().size(), 2u);
    EXPECT_EQ(tracks.tracks()[0].projector.centre_m, old_m);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_LE(std::abs(tracks.tracks()[i].opacity - last[i]), 4.0 / 60.0 + 1e-12);
      last[i] = tracks.tracks()[i].opacity;
    }
  }
  tracks.advance_to(2.0);
  ASSERT_EQ(tracks.tracks().size(), 1u);
  EXPECT_EQ(tracks.tracks()[0].id, 1u);
  EXPECT_EQ(tracks.tracks()[0].opacity, 1.0);
}

// A triangle of as large a box as a sphere of radius 1, and points anywhere in its plane z = 1.
class TrackStepTest : public HighlightTracksTest {
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
  HighlightSurface shape_ = surface(triangle());
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

// If the older of two in one region ends, the other takes over. Fails if the region goes dark: together they
// show at least one full highlight but for what a fade takes.
TEST_F(TrackStepTest, AnHeirTakesOverTheRegion) {
  const HighlightPoint first = point_at(0.0, 0.0), second = point_at(0.05, 0.0);
  TrackState state = first_state(shape_, {first, second}, options_);
  ASSERT_EQ(state.tracks[1].opacity, 0.0);
  for (int step = 0; step < 30; ++step) {
    advance(shape_, {second}, options_, state);
    double sum = 0.0;
    for (const HighlightTrack& track : state.tracks) sum += track.opacity;
    EXPECT_GE(sum, 0.9);
  }
  ASSERT_EQ(state.tracks.size(), 1u);
  EXPECT_EQ(state.tracks[0].id, 1u);
  EXPECT_EQ(state.tracks[0].opacity, 1.0);
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
  EXPECT_NEAR(state.tracks[0].opacity, 4.0 / 60.0, 1e-12);
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

void expect_same(const TrackState& a, const TrackState& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.next_id, b.next_id);
  ASSERT_EQ(a.tracks.size(), b.tracks.size());
  for (std::size_t i = 0; i < a.tracks.size(); ++i) {
    EXPECT_EQ(a.tracks[i].id, b.tracks[i].id);
    EXPECT_EQ(a.tracks[i].projector, b.tracks[i].projector);
    EXPECT_EQ(a.tracks[i].opacity, b.tracks[i].opacity);
    EXPECT_EQ(a.tracks[i].seed_face, b.tracks[i].seed_face);
  }
}

// Fails if what is shown depends on which frames were asked for, on going back, or on where a replay begins.
TEST_F(HighlightTracksTest, TheSameTimeShowsTheSame) {
  const HighlightSurface shape = surface(test::bumpy_sphere(3));
  HighlightTracks often(shape, circling), once(shape, circling), restored(shape, circling);
  for (int frame = 0; frame <= 70; ++frame) often.advance_to(0.1 * frame);
  ASSERT_GE(often.state().next_id, 5u) << "too calm a test";
  once.advance_to(7.0);
  expect_same(once.state(), often.state());
  once.advance_to(9.0);
  once.advance_to(3.3);
  restored.restore(once.state());
  EXPECT_EQ(restored.time_s(), once.time_s());
  once.advance_to(7.0);
  expect_same(once.state(), often.state());
  restored.advance_to(7.0);
  expect_same(restored.state(), often.state());
  // A new start forgets the past.
  often.reset(7.0);
  EXPECT_EQ(often.time_s(), 7.0);
  for (const HighlightTrack& track : often.tracks()) EXPECT_LT(track.id, often.tracks().size());
}

// A sphere that is carried off by a diagonal a second and drawn out to an ellipsoid on the way: its one
// highlight goes along. Fails if it is taken for another, falls behind, or is not where a surface made of the
// same vertices has it.
TEST_F(HighlightTracksTest, HighlightsGoAlongWithADeformedSurface) {
  const auto at = [](double time_s) {
    return test::moved(test::ellipsoid(4, {1.0 + 0.5 * time_s, 1.0, 1.0 - 0.2 * time_s}), glm::dmat3(1.0),
                       {0.0, 3.5 * time_s, 0.0});
  };
  HighlightSurface shape = surface(at(0.0));
  HighlightTracks tracks(shape, [&](double time_s) {
    const test::ExampleSurface now = at(time_s);
    shape.deform(now.mesh.positions_m, now.mesh.normals, now.curvatures);
    return circling(0.1 * time_s);
  });
  tracks.advance_to(2.0);
  ASSERT_EQ(tracks.tracks().size(), 1u);
  const HighlightTrack& track = tracks.tracks()[0];
  EXPECT_EQ(track.id, 0u);
  EXPECT_EQ(track.opacity, 1.0);
  EXPECT_EQ(track.projector.centre_m, track.point.position_m);
  HighlightPoints search(device_);
  const auto expected = search.find(surface(at(2.0)), circling(0.2));
  ASSERT_EQ(expected.size(), 1u);
  EXPECT_EQ(track.point.position_m, expected[0].position_m);
  EXPECT_EQ(track.point.k_max_per_m, expected[0].k_max_per_m);
  test::ExampleSurface fewer = at(0.0);
  fewer.mesh.positions_m.pop_back();
  EXPECT_THROW(shape.deform(fewer.mesh.positions_m, fewer.mesh.normals, fewer.curvatures), Error);
}

// Long runs keep fewer keys, not wrong ones. Fails if a key that has been dropped is gone back to.
TEST_F(HighlightTracksTest, GoingBackAfterALongTimeShowsTheSame) {
  const HighlightSurface shape = surface(test::ellipsoid(2, {1.0, 0.8, 0.6}));
  const TrackOptions options{.key_steps = 1};
  HighlightTracks once(shape, circling, options), back(shape, circling, options);
  once.advance_to(10.05);
  back.advance_to(1500.0 / 60.0);
  back.advance_to(10.05);
  expect_same(back.state(), once.state());
}

TEST_F(HighlightTracksTest, BadTimesAndOptionsAreErrors) {
  const HighlightSurface shape = surface(test::ellipsoid(1, glm::dvec3(1.0)));
  HighlightTracks tracks(shape, circling);
  EXPECT_THROW(tracks.advance_to(-0.1), Error);
  EXPECT_THROW(tracks.advance_to(std::nan("")), Error);
  EXPECT_THROW(tracks.reset(1e9), Error);
  for (const TrackOptions& options : {TrackOptions{.step_s = 0.0}, TrackOptions{.size = {.threshold = 1.5}},
                                      TrackOptions{.limits = {.fade_per_s = std::nan("")}},
                                      TrackOptions{.lag_share = -1.0}, TrackOptions{.key_steps = 0}}) {
    EXPECT_THROW(HighlightTracks(shape, circling, options), Error);
  }
}

// A walk downhill from the far side ends where a search through all faces does. Fails if distances to edges
// and corners are wrong.
TEST_F(HighlightTracksTest, NearestFacesAreFoundByWalking) {
  const HighlightSurface shape = surface(test::ellipsoid(3, {1.0, 0.9, 1.1}));
  const TriangleMesh& mesh = shape.mesh();
  test::RandomVectors random(32);
  const auto distance2 = [&](std::uint32_t f, const glm::dvec3& p) {
    return squared_distance(p, mesh.positions_m[mesh.faces[f][0]], mesh.positions_m[mesh.faces[f][1]],
                            mesh.positions_m[mesh.faces[f][2]]);
  };
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 p = (0.8 + random.uniform()) * random.direction();
    double least = 1e9;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) least = std::min(least, distance2(f, p));
    EXPECT_NEAR(distance2(nearest_face(shape, 0, p), p), least, 1e-12);
  }
  // By hand: above the inside, beyond an edge, beyond a corner.
  const glm::dvec3 a(0.0), b(2.0, 0.0, 0.0), c(0.0, 2.0, 0.0);
  EXPECT_NEAR(squared_distance({0.5, 0.5, 3.0}, a, b, c), 9.0, 1e-12);
  EXPECT_NEAR(squared_distance({1.0, -2.0, 1.0}, a, b, c), 5.0, 1e-12);
  EXPECT_NEAR(squared_distance({3.0, -1.0, 0.0}, a, b, c), 2.0, 1e-12);
}

}  // namespace
}  // namespace offing::highlights
