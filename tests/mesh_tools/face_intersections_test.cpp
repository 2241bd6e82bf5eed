// SPDX-License-Identifier: GPL-3.0-or-later (CGAL)
#include "mesh_tools/face_intersections.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <gtest/gtest.h>

#include "host/io/meshes/read_mesh.h"
#include "mesh_tools/surface.h"
#include "tests/io/meshes/mesh_samples.h"

namespace offing::mesh_tools {
namespace {

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

/// The same by CGAL's own search, which knows manifolds only.
Pairs by_half_edges(const TriangleMesh& mesh) {
  const Surface surface = to_surface(mesh, "test");
  std::vector<std::pair<Surface::Face_index, Surface::Face_index>> found;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(found));
  Pairs pairs;
  for (const auto& [a, b] : found) pairs.push_back({std::min(a.idx(), b.idx()), std::max(a.idx(), b.idx())});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// Fails if a pair of faces is missed or invented: random radii, moved about until faces pierce one another.
TEST(FaceIntersections, AreThoseOfHalfEdges) {
  std::size_t all = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift_m(-0.5, 0.5);
    TriangleMesh mesh = test::random_mesh(seed, 8, 11);
    for (glm::dvec3& position : mesh.positions_m)
      position += glm::dvec3(shift_m(random), shift_m(random), 0.0);
    const Pairs pairs = intersecting_faces(mesh, CancelToken());
    EXPECT_EQ(pairs, by_half_edges(mesh)) << seed;
    all += pairs.size();
  }
  EXPECT_GT(all, 1000u);
}

// The same of real meshes, one with many intersections and one with none.
TEST(FaceIntersections, OfMeasuredFiles) {
  const char* const data = std::getenv("OFFING_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "OFFING_TEST_DATA is not set";
  for (const char* const name : {"bones_26comp.off", "knot_2880.obj"}) {
    const TriangleMesh mesh = read_mesh(std::filesystem::path(data) / "meshes" / name);
    EXPECT_EQ(intersecting_faces(mesh, CancelToken()), by_half_edges(mesh)) << name;
  }
}

}  // namespace
}  // namespace offing::mesh_tools
