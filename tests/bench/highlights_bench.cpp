// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/highlights/tracks/highlight_tracker.h"
#include "host/io/meshes/read_mesh.h"
#include "host/mesh_shapes/shape.h"
#include "mesh_tools/curvature/curvature.h"
#include "tests/bench/benches.h"
#include "tests/highlights/highlight_frame.h"

namespace offing::bench {
namespace {

using namespace highlights;

constexpr double frames_per_s = 60.0;

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
  int lights = 1;
};

/// Of the sizes of H12, and for the search one as large as a scan.
std::vector<NamedMesh> meshes() {
  std::vector<NamedMesh> result;
  result.push_back({"sphere", mesh_shapes::make_sphere(1.0, 4).mesh});
  result.push_back({"knot", mesh_shapes::make_torus_knot({}, {120, 12}).mesh});
  result.push_back({"fine_knot", mesh_shapes::make_torus_knot({}, {360, 38}).mesh, 2});
  result.push_back({"scan", mesh_shapes::make_torus_knot({}, {2000, 200}).mesh});
  if (const char* folder = std::getenv("OFFING_TEST_DATA"); folder != nullptr)
    result.push_back({"penguin", read_mesh(std::filesystem::path(folder) / "meshes" / "penguin_26880.obj")});
  return result;
}

/// The mesh turns half a degree in a thirtieth of a second before an eye nearby and lights far away: what it
/// sees.
Lighting turning(const HighlightSurface& surface, int lights, double time_s) {
  const double angle = 15.0 * time_s * std::numbers::pi / 180.0, c = std::cos(angle), s = std::sin(angle);
  const RigidMotion motion{glm::dmat3({c, 0.0, -s}, {0.0, 1.0, 0.0}, {s, 0.0, c}), glm::dvec3(0.0)};
  Lighting world{{Source::Kind::place, surface.middle_m() + surface.diagonal_m() * glm::dvec3(0.1, 0.3, 2.0)},
                 {}};
  for (int light = 0; light < lights; ++light) {
    world.lights.push_back({Source::Kind::direction, {light == 0 ? 0.5 : -0.7, 0.8, 0.6}});
  }
  return in_mesh_axes(world, motion);
}

/// The peer: a loop over all faces on one core, H of each corner, the linear system of H3 solved by Cramer's
/// rule up to the signs of its weights. It does not agree with itself on edges.
std::size_t loop_over_faces(const HighlightSurface& surface, const Lighting& lighting) {
  const TriangleMesh& mesh = surface.mesh();
  std::vector<glm::vec3> half(mesh.positions_m.size());
  std::size_t found = 0;
  for (const Source& light : lighting.lights) {
    for (std::size_t vertex = 0; vertex < half.size(); ++vertex) {
      half[vertex] = glm::vec3(half_vector(lighting.eye, light, mesh.positions_m[vertex]));
    }
    for (const TriangleIndices& face : mesh.faces) {
      const glm::vec3 h = half[face[0]] + half[face[1]] + half[face[2]];
      const glm::vec3 a(mesh.normals[face[0]]), b(mesh.normals[face[1]]), c(mesh.normals[face[2]]);
      const float u = glm::dot(glm::cross(b, c), h), v = glm::dot(glm::cross(c, a), h),
                  w = glm::dot(glm::cross(a, b), h);
      const bool is_inside = (u >= 0.0f && v >= 0.0f && w >= 0.0f) || (u <= 0.0f && v <= 0.0f && w <= 0.0f);
      found += is_inside && glm::dot(a + b + c, h) > 0.0f ? 1 : 0;
    }
  }
  return found;
}

void bench_mesh(const ocl::Device& device, const NamedMesh& named, const Settings& settings,
                const Sinks& sinks) {
  const int faces = static_cast<int>(named.mesh.faces.size());
  const HighlightSurface surface(device, named.mesh, mesh_tools::vertex_curvatures(named.mesh).curvatures);
  HighlightFinder search(device);
  const Lighting lighting = turning(surface, named.lights, 0.0);
  const std::size_t ours = search.find(surface, lighting).size(), peers = loop_over_faces(surface, lighting);
  if (ours + 4 < peers || peers + 4 < ours) {
    throw Error(ErrorKind::device,
                fmt::format("highlights of {}: expected about the peer's {} points, found {}", named.name,
                            peers, ours),
                "run the tests of this device: ctest -L quick");
  }
  sinks.row(row_of("highlights_search_" + named.name, faces, "C++, a loop over faces, 1 core",
                   compare([&] { search.find(surface, lighting); },
                           [&] { loop_over_faces(surface, lighting); }, settings.blocks)));

  HighlightTracker tracks(surface, [&](double time_s) { return turning(surface, named.lights, time_s); },
                          {.step_s = 1.0 / frames_per_s});
  RegionSearch regions(surface);
  HighlightFrame frame;
  std::int64_t number = 0;
  std::size_t shown = 0, drawn_on = 0;
  std::vector<double> frame_ms;
  for (int block = 0; block < settings.blocks; ++block) {
    frame_ms.push_back(block_ms([&] {
      tracks.advance_to(static_cast<double>(++number) / frames_per_s);
      make_frame(tracks.tracks(), regions, frame);
      shown += frame.highlights.size();
      drawn_on += frame.faces.size();
    }));
  }
  const auto mean = [&](std::size_t sum) { return static_cast<double>(sum) / static_cast<double>(number); };
  sinks.row({.name = "highlights_frame_" + named.name,
             .size = faces,
             .ours_ms = median(frame_ms),
             .peer = fmt::format("none; {:.1f} highlights on {:.0f} faces", mean(shown), mean(drawn_on)),
             .spread = relative_spread(frame_ms)});
}

}  // namespace

void bench_highlights(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  for (const NamedMesh& named : meshes()) bench_mesh(device, named, settings, sinks);
}

}  // namespace offing::bench
