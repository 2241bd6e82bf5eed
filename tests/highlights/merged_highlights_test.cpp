// How many highlights the eye sees, and for how long.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>

#include "host/highlights/curvature/diffused_curvature.h"
#include "host/highlights/tracks/highlight_tracker.h"
#include "host/mesh_shapes/shape.h"

namespace offing::highlights {
namespace {

/// Of 96 frames at 24 a second.
struct Seen {
  std::vector<int> counts;      ///< [frames] visible highlights
  std::vector<int> lives;       ///< [highlights] frames in which each is visible, ascending
  std::vector<int> full_lives;  ///< of those that begin and end within the frames
};

/// A mesh that turns about y before an eye, a light at a place and, if so asked, one far away.
Seen seen_on(const HighlightSurface& surface, double degrees_per_s, std::size_t light_count) {
  Lighting world{{Source::Kind::place, {0.0, 0.3, 5.0}},
                 {{Source::Kind::place, {-3.0, 3.1, 4.0}}, {Source::Kind::direction, {0.63, 0.57, 0.53}}}};
  world.lights.resize(light_count);
  const auto lighting_at = [&](double time_s) {
    const double angle_rad = degrees_per_s * time_s * std::numbers::pi / 180.0;
    const double cosine = std::cos(angle_rad), sine = std::sin(angle_rad);
    const glm::dmat3 turn({cosine, 0.0, sine}, {0.0, 1.0, 0.0}, {-sine, 0.0, cosine});
    return in_mesh_axes(world, {turn, glm::dvec3(0.0)});
  };
  HighlightTracker tracks(surface, lighting_at, {.has_shadows = true});
  constexpr int frames = 96;
  std::map<std::uint64_t, std::vector<int>> frames_of;  // by id
  Seen seen;
  for (int frame = 0; frame < frames; ++frame) {
    int count = 0;
    for (const HighlightTrack& track : tracks.shown_at(frame / 24.0).tracks) {
      if (!(track.opacity > 0.0)) continue;
      ++count;
      frames_of[track.id].push_back(frame);
    }
    seen.counts.push_back(count);
  }
  for (const auto& [id, visible] : frames_of) {
    const int life = static_cast<int>(visible.size());
    seen.lives.push_back(life);
    if (visible.front() > 0 && visible.back() < frames - 1) seen.full_lives.push_back(life);
  }
  std::ranges::sort(seen.lives);
  return seen;
}

// The knot of the papers' figure 8, which has 6 or 7. Fails if highlights crowd (30 at once), or come and go
// within frames (a median of 6): points are born and die in pairs wherever the tube is nearly straight.
TEST(MergedHighlightsTest, AKnotShowsFewThatLast) {
  const mesh_shapes::Shape knot = mesh_shapes::make_torus_knot({}, {120, 12});
  const Seen seen = seen_on({ocl::Device::open(), knot.mesh, *knot.truth}, 30.0, 2);
  EXPECT_GE(std::ranges::min(seen.counts), 4);
  EXPECT_LE(std::ranges::max(seen.counts), 10);
  EXPECT_GE(seen.lives[seen.lives.size() / 2], 24);
  for (const int life : seen.full_lives) EXPECT_GE(life, 8);
}

// `offing-mesh generate bumpy --level 6`, of 82,000 faces. Fails if each of many bumps has a highlight of its
// own, or if any blinks.
TEST(MergedHighlightsTest, ABumpySphereIsNotCrowded) {
  const mesh_shapes::Shape bumpy = mesh_shapes::make_bumpy_sphere(1.0, 0.15, 6);
  const Seen seen = seen_on({ocl::Device::open(), bumpy.mesh, *bumpy.truth}, 90.0, 1);
  EXPECT_LE(std::ranges::max(seen.counts), 8);
  for (const int life : seen.full_lives) EXPECT_GE(life, 8);
}

// Noise of a tenth of an edge makes dozens of points where a sphere has one. Fails if they are seen.
TEST(MergedHighlightsTest, ARoughSphereShowsOne) {
  const ocl::Device device = ocl::Device::open();
  TriangleMesh mesh = mesh_shapes::make_sphere(1.0, 5, {.normal_noise = 0.1}).mesh;
  mesh.normals.clear();
  VertexCurvatures curvatures = diffused_curvatures(device, mesh);
  const Seen seen = seen_on({device, std::move(mesh), std::move(curvatures)}, 90.0, 1);
  EXPECT_EQ(seen.lives, std::vector<int>{96});
}

}  // namespace
}  // namespace offing::highlights
