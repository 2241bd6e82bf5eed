#include "host/highlights/tracks/highlight_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/highlights/search/nearest_face.h"
#include "host/highlights/search/surface_place.h"
#include "host/highlights/search/triangle_point.h"
#include "tests/highlights/example_surfaces.h"

namespace offing::highlights {
namespace {

using std::numbers::pi;

class HighlightTracksTest : public testing::Test {
 protected:
  HighlightSurface surface(const test::ExampleSurface& example) const {
    return {device_, example.mesh, example.curvatures};
  }
  /// A light far away that circles about y once in 10 s, and an eye far away.
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
  HighlightTracker tracks(shape, circling);
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
  HighlightTracker tracks(shape, [](double time_s) { return circling(std::min(time_s, 10.0)); });
  const Projector start = tracks.tracks()[0].projector;
  tracks.advance_to(10.5);
  ASSERT_EQ(tracks.tracks().size(), 1u);
  const Projector& end = tracks.tracks()[0].projector;
  EXPECT_LE(glm::distance(end.centre_m, start.centre_m), 1e-5 * shape.diagonal_m());
  EXPECT_NEAR(end.width_m, start.width_m, 1e-5 * start.width_m);
  EXPECT_NEAR(end.height_m, start.height_m, 1e-5 * start.height_m);
  EXPECT_NEAR(std::abs(glm::dot(end.right, start.right)), 1.0, 1e-5);
}

// A light that jumps leaves its highlight behind, which fades out there; another fades in. Fails if one is
// dragged over the surface, or pops.
TEST_F(HighlightTracksTest, AJumpOfTheLightFadesFromOneToAnother) {
  const HighlightSurface shape = surface(test::ellipsoid(4, glm::dvec3(1.0)));
  HighlightTracker tracks(shape, [](double time_s) { return circling(time_s < 1.0 ? 0.0 : 5.0); });
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

/// Eye and light far away, for a mesh that turns about y.
Lighting spinning(double time_s, double speed_radps) {
  const double cosine = std::cos(speed_radps * time_s), sine = std::sin(speed_radps * time_s);
  const glm::dmat3 turn({cosine, 0.0, sine}, {0.0, 1.0, 0.0}, {-sine, 0.0, cosine});
  return {{Source::Kind::direction, turn * glm::dvec3(0.0, 0.4, 1.0)},
          {{Source::Kind::direction, turn * glm::dvec3(0.9, 0.5, 0.3)}}};
}

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0 / pi;
}

/// How far from H the normal is where a track is shown.
double error_deg(const HighlightSurface& shape, const HighlightTrack& track, const Lighting& lighting) {
  const glm::dvec3& middle_m = track.projector.centre_m;
  const SurfacePlace place = place_of_face_near(shape, track.seed_face, middle_m);
  return degrees_between(normal_at(shape, place), half_vector(lighting.eye, lighting.lights[0], middle_m));
}

// A surface of revolution that turns at 30 degrees a second: its highlight goes around it evenly. Fails if
// frames show the step before them: the movements then differ by up to twice, and N is up to 0.5 degrees
// from H.
TEST_F(HighlightTracksTest, MovesEvenlyAtEveryFrameRate) {
  const HighlightSurface shape = surface(test::ellipsoid(6, {1.0, 0.6, 1.0}));
  for (const double fps :
       {24000.0 / 1001.0, 24.0, 25.0, 30000.0 / 1001.0, 30.0, 50.0, 60000.0 / 1001.0, 60.0, 120.0}) {
    HighlightTracker tracks(shape, [](double time_s) { return spinning(time_s, pi / 6.0); });
    glm::dvec3 before_m{0.0};
    double least_m = 1e9, most_m = 0.0, largest_deg = 0.0;
    for (int frame = 0; frame <= 48; ++frame) {
      const double time_s = frame / fps;
      const std::vector<HighlightTrack>& shown = tracks.shown_at(time_s).tracks;
      ASSERT_EQ(shown.size(), 1u);
      largest_deg = std::max(largest_deg, error_deg(shape, shown[0], spinning(time_s, pi / 6.0)));
      const glm::dvec3 now_m = shown[0].projector.centre_m;
      if (frame > 0) {
        least_m = std::min(least_m, glm::distance(before_m, now_m));
        most_m = std::max(most_m, glm::distance(before_m, now_m));
      }
      before_m = now_m;
    }
    EXPECT_LE(most_m, 1.05 * least_m) << fps;
    EXPECT_LE(largest_deg, 0.05) << fps;
  }
}

// 90 degrees a second, as a turntable makes them. Fails if highlights stay behind (the limits alone let an
// ellipsoid's fall back by tens of degrees), or if one that jumps is let go faster.
TEST_F(HighlightTracksTest, KeepsUpWithAFastTurn) {
  for (const glm::dvec3& half_axes_m :
       {glm::dvec3(1.0), glm::dvec3(1.0, 0.8, 0.9), glm::dvec3(1.0, 0.6, 0.4)}) {
    const HighlightSurface shape = surface(test::ellipsoid(5, half_axes_m));
    HighlightTracker tracks(shape, [](double time_s) { return spinning(time_s, pi / 2.0); });
    double largest_deg = 0.0;
    for (int frame = 1; frame <= 96; ++frame) {
      const double time_s = frame / 24.0;
      const Lighting lighting = spinning(time_s, pi / 2.0);
      for (const HighlightTrack& track : tracks.shown_at(time_s).tracks) {
        EXPECT_EQ(track.opacity, 1.0);
        const glm::dvec3 h = half_vector(lighting.eye, lighting.lights[0], track.projector.centre_m);
        largest_deg = std::max(
            {largest_deg, error_deg(shape, track, lighting), degrees_between(track.projector.normal, h)});
      }
    }
    EXPECT_LE(largest_deg, 3.0) << half_axes_m.z;
  }
}

// Fails if what is shown depends on which frames were asked for, on going back, or on where a replay begins.
TEST_F(HighlightTracksTest, TheSameTimeShowsTheSame) {
  const HighlightSurface shape = surface(test::bumpy_sphere(3));
  HighlightTracker often(shape, circling), once(shape, circling), restored(shape, circling);
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
  // Between steps too, whether frames lead there or not.
  HighlightTracker at_film_rate(shape, circling), at_once(shape, circling);
  for (int frame = 0; frame <= 101; ++frame) at_film_rate.shown_at(frame / 24.0);
  expect_same(at_once.shown_at(101 / 24.0), at_film_rate.shown_at(101 / 24.0));
  at_once.shown_at(7.013);
  expect_same(at_once.shown_at(101 / 24.0), at_film_rate.shown_at(101 / 24.0));
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
  HighlightTracker tracks(shape, [&](double time_s) {
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
  HighlightFinder search(device_);
  const auto expected = search.find(surface(at(2.0)), circling(0.2));
  ASSERT_EQ(expected.size(), 1u);
  EXPECT_EQ(track.point.position_m, expected[0].position_m);
  EXPECT_EQ(track.point.k_max_per_m, expected[0].k_max_per_m);
  test::ExampleSurface fewer = at(0.0);
  fewer.mesh.positions_m.pop_back();
  EXPECT_THROW(shape.deform(fewer.mesh.positions_m, fewer.mesh.normals, fewer.curvatures), Error);
}

// Back to a stored key, where no search is needed, and to a state that was kept. Fails if the surface stays
// as it was at the later time.
TEST_F(HighlightTracksTest, GoingBackTakesTheSurfaceAlong) {
  const test::ExampleSurface start = test::ellipsoid(2, glm::dvec3(1.0));
  HighlightSurface shape = surface(start);
  HighlightTracker tracks(shape, [&](double time_s) {
    const test::ExampleSurface now = test::moved(start, glm::dmat3(1.0), {0.0, time_s, 0.0});
    shape.deform(now.mesh.positions_m, now.mesh.normals, now.curvatures);
    return circling(0.0);
  });
  const double start_m = start.mesh.positions_m[0].y;
  tracks.advance_to(1.0);
  const TrackState key = tracks.state();
  tracks.advance_to(2.5);
  EXPECT_NEAR(shape.mesh().positions_m[0].y, start_m + 2.5, 1e-9);
  tracks.advance_to(1.0);
  EXPECT_NEAR(shape.mesh().positions_m[0].y, start_m + 1.0, 1e-9);
  tracks.advance_to(2.5);
  tracks.restore(key);
  EXPECT_NEAR(shape.mesh().positions_m[0].y, start_m + 1.0, 1e-9);
}

// Times between two steps are shown, then the earlier step. Fails if the surface stays as it was between
// them.
TEST_F(HighlightTracksTest, AStepTakesTheSurfaceBack) {
  const test::ExampleSurface start = test::ellipsoid(2, glm::dvec3(1.0));
  HighlightSurface shape = surface(start);
  const TrackOptions options;
  HighlightTracker tracks(
      shape,
      [&](double time_s) {
        const test::ExampleSurface now =
            test::moved(start, glm::dmat3(1.0), {0.0, time_s / options.step_s, 0.0});
        shape.deform(now.mesh.positions_m, now.mesh.normals, now.curvatures);
        return circling(0.0);
      },
      options);
  const double start_m = start.mesh.positions_m[0].y;
  const auto steps = [&] { return shape.mesh().positions_m[0].y - start_m; };
  tracks.shown_at(1.5 * options.step_s);
  EXPECT_NEAR(steps(), 1.5, 1e-9);
  tracks.shown_at(1.0 * options.step_s);
  EXPECT_NEAR(steps(), 1.0, 1e-9);
  tracks.shown_at(1.25 * options.step_s);
  tracks.advance_to(1.25 * options.step_s);
  EXPECT_NEAR(steps(), 1.0, 1e-9);
  const auto revision = shape.revision();
  tracks.shown_at(1.0 * options.step_s);
  EXPECT_EQ(shape.revision(), revision) << "it is that of this step already";
}

// Fails if a state of another mesh, or one that was damaged, is taken, or changes anything.
TEST_F(HighlightTracksTest, StatesThatCannotBeAreErrors) {
  const HighlightSurface shape = surface(test::ellipsoid(2, glm::dvec3(1.0)));
  HighlightTracker tracks(shape, circling);
  tracks.advance_to(0.5);
  const TrackState good = tracks.state();
  const auto faces = static_cast<std::uint32_t>(shape.mesh().faces.size());
  std::vector<TrackState> states(7, good);
  states[0].tracks[0].seed_face = faces;
  states[1].tracks[0].point.face = faces;
  states[2].step = -1;
  states[3].step = std::numeric_limits<std::int64_t>::max();
  states[4].tracks.push_back(good.tracks[0]);
  states[5].tracks[0].id = good.next_id;
  states[6].tracks[0].nearest.push_back(1.0);
  for (const TrackState& bad : states) {
    EXPECT_THROW(tracks.restore(bad), Error);
    expect_same(tracks.state(), good);
  }
}

// Long runs keep fewer keys, not wrong ones. Fails if a key that has been dropped is gone back to.
TEST_F(HighlightTracksTest, GoingBackAfterALongTimeShowsTheSame) {
  const HighlightSurface shape = surface(test::ellipsoid(2, {1.0, 0.8, 0.6}));
  const TrackOptions options{.key_steps = 1};
  HighlightTracker once(shape, circling, options), back(shape, circling, options);
  once.advance_to(10.05);
  back.advance_to(1500.0 / 60.0);
  back.advance_to(10.05);
  expect_same(back.state(), once.state());
}

// Fails if tracks that never go back fill the memory with states, or cannot go back at all.
TEST_F(HighlightTracksTest, TracksWithoutKeysKeepNone) {
  const HighlightSurface shape = surface(test::ellipsoid(2, {1.0, 0.8, 0.6}));
  HighlightTracker tracks(shape, circling), once(shape, circling);
  tracks.reset(0.0, KeyStates::none);
  tracks.advance_to(5.0);
  EXPECT_EQ(tracks.key_count(), 1u);
  tracks.advance_to(2.2);
  once.advance_to(2.2);
  EXPECT_EQ(once.key_count(), 3u);
  expect_same(tracks.state(), once.state());
}

TEST_F(HighlightTracksTest, BadTimesAndOptionsAreErrors) {
  const HighlightSurface shape = surface(test::ellipsoid(1, glm::dvec3(1.0)));
  HighlightTracker tracks(shape, circling);
  EXPECT_THROW(tracks.advance_to(-0.1), Error);
  EXPECT_THROW(tracks.advance_to(std::nan("")), Error);
  EXPECT_THROW(tracks.reset(1e9), Error);
  for (const TrackOptions& options : {TrackOptions{.step_s = 0.0}, TrackOptions{.size = {.threshold = 1.5}},
                                      TrackOptions{.limits = {.fade_per_s = std::nan("")}},
                                      TrackOptions{.lag_share = -1.0}, TrackOptions{.key_steps = 0}}) {
    EXPECT_THROW(HighlightTracker(shape, circling, options), Error);
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
}

}  // namespace
}  // namespace offing::highlights
