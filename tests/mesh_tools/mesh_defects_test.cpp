#include "mesh_tools/mesh_defects.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/io/meshes/read_mesh.h"
#include "mesh_tools/repair.h"
#include "mesh_tools/subdivide.h"
#include "tests/io/meshes/mesh_samples.h"

namespace offing::mesh_tools {
namespace {

MeshDefects defects_of(const TriangleMesh& mesh) {
  return find_defects(mesh, CancelToken());
}

/// Vertices on a small grid, so that many fall together, and faces among them at random.
TriangleMesh random_soup(unsigned seed) {
  std::mt19937 random(seed);
  TriangleMesh mesh;
  const std::size_t vertices = 3 + random() % 12, faces = 1 + random() % 30;
  for (std::size_t i = 0; i < vertices; ++i)
    mesh.positions_m.emplace_back(random() % 4, random() % 4, random() % 3);
  for (std::size_t i = 0; i < faces; ++i) {
    mesh.faces.push_back({static_cast<std::uint32_t>(random() % vertices),
                          static_cast<std::uint32_t>(random() % vertices),
                          static_cast<std::uint32_t>(random() % vertices)});
  }
  return mesh;
}

/// Whether a face names three vertices.
bool is_proper(const TriangleIndices& face) {
  return std::set<std::uint32_t>(face.begin(), face.end()).size() == 3;
}

/// Non-manifold edges and vertices by their definitions, from maps and searches instead of sorted arrays.
std::pair<std::size_t, std::size_t> slow_non_manifolds(const TriangleMesh& mesh) {
  std::map<std::set<std::uint32_t>, std::vector<std::size_t>> faces_of;
  std::map<std::uint32_t, std::set<std::size_t>> around;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const TriangleIndices& face = mesh.faces[f];
    if (!is_proper(face)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      faces_of[{face[i], face[(i + 1) % 3]}].push_back(f);
      around[face[i]].insert(f);
    }
  }
  std::size_t edges = 0, vertices = 0;
  for (const auto& [edge, faces] : faces_of) edges += faces.size() > 2;
  for (auto& [vertex, faces] : around) {
    std::vector<std::size_t> reached{*faces.begin()};
    faces.erase(faces.begin());
    for (std::size_t next = 0; next < reached.size(); ++next) {
      for (const std::uint32_t other : mesh.faces[reached[next]]) {
        if (other == vertex) continue;
        for (const std::size_t neighbour : faces_of[{vertex, other}]) {
          if (faces.erase(neighbour) > 0) reached.push_back(neighbour);
        }
      }
    }
    vertices += !faces.empty();
  }
  return {edges, vertices};
}

// Fails if edges or fans are counted otherwise than their definitions say, whatever the faces.
TEST(MeshDefects, AgreeWithSlowCountsOnRandomSoups) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    const TriangleMesh mesh = random_soup(seed);
    const MeshDefects defects = find_index_defects(mesh);
    const auto [edges, vertices] = slow_non_manifolds(mesh);
    EXPECT_EQ(defects.non_manifold_edges, edges) << seed;
    EXPECT_EQ(defects.non_manifold_vertices, vertices) << seed;
  }
}

// Fails if a count is wrong where it can be told at sight.
TEST(MeshDefects, SmallMeshes) {
  TriangleMesh mesh = test::random_mesh(3);
  MeshDefects defects = defects_of(mesh);
  EXPECT_EQ(defects.components, 1u);
  EXPECT_EQ(defects.boundary_loops + defects.non_manifold_edges + defects.degenerate_faces, 0u);
  EXPECT_TRUE(defects.orientable);
  EXPECT_EQ(defects.turned_edges, 0u);
  EXPECT_EQ(defects.self_intersections, 0u);

  mesh.positions_m.emplace_back(9, 9, 9);         // of no face
  std::swap(mesh.faces[4][0], mesh.faces[4][1]);  // disagrees with its three neighbours
  mesh.faces.push_back({mesh.faces[0][2], mesh.faces[0][0], mesh.faces[0][1]});  // the first again
  mesh.faces.push_back({3, 3, 5});
  defects = defects_of(mesh);
  EXPECT_EQ(defects.isolated_vertices, 1u);
  EXPECT_EQ(defects.turned_edges, 3u);
  EXPECT_TRUE(defects.orientable);
  EXPECT_EQ(defects.duplicate_faces, 1u);
  EXPECT_EQ(defects.non_manifold_edges, 3u);  // those of the repeated face
  EXPECT_EQ(defects.degenerate_faces, 1u);
  EXPECT_EQ(defects.repeating_faces, 1u);
}

// Fails if faces without an area are decided by rounded numbers: the third corner lies on the line, or beside
// it by the last bit of a double.
TEST(MeshDefects, AreasAreDecidedExactly) {
  TriangleMesh mesh;
  mesh.positions_m = {
      {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.4, 0.4, 0.4}, {0.4, 0.4, std::nextafter(0.4, 1.0)}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}};
  EXPECT_EQ(defects_of(mesh).degenerate_faces, 1u);
}

// Fails if faces that cross, pierce a shared corner's other face or lie upon one another are missed, or if
// neighbours and seams are taken for intersections.
TEST(MeshDefects, SelfIntersections) {
  TriangleMesh cross;
  cross.positions_m = {{0, 0, 0},     {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1},
                       {0.5, 0.5, 1}, {3, 3, 0}, {2, 0, 0}, {2, 2, 0}};
  cross.faces = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_EQ(defects_of(cross).self_intersections, 1u);
  cross.faces = {{0, 1, 2}, {0, 3, 4}};  // share a corner, and more
  EXPECT_EQ(defects_of(cross).self_intersections, 1u);
  cross.faces = {{0, 1, 2}, {6, 7, 2}};  // a seam: vertex 6 lies where 1 does
  EXPECT_EQ(defects_of(cross).self_intersections, 0u);
  cross.positions_m.emplace_back(0.5, 0.5, 0.0);
  cross.faces = {{0, 1, 2}, {0, 1, 8}};  // folded upon each other
  EXPECT_EQ(defects_of(cross).self_intersections, 1u);
}

struct Expected {
  const char* name;
  std::size_t vertices, faces, components, boundary_loops, boundary_edges, non_manifold_edges,
      non_manifold_vertices;
  bool orientable = true;
};

// Fails if a mesh of the wild is counted otherwise than by those who published it. Reference counts are those
// of the files' own documentation or an independent reader.
TEST(MeshDefects, MeasuredFiles) {
  const char* const data = std::getenv("OFFING_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "OFFING_TEST_DATA is not set";
  const std::vector<Expected> files = {{"knot_2880.obj", 1440, 2880, 1, 0, 0, 0, 0},
                                       {"penguin_26880.obj", 13442, 26880, 1, 0, 0, 0, 0},
                                       {"plane_holes_16747.obj", 8519, 16747, 1, 27, 341, 0, 0},
                                       {"fandisk_12946.off", 6475, 12946, 1, 0, 0, 0, 0},
                                       {"bones_26comp.off", 2154, 4204, 26, 0, 0, 0, 0},
                                       {"spot_low.obj", 829, 1654, 1, 0, 0, 0, 0},
                                       {"cycloidal_nonmanifold.ply", 21384, 43368, 100, 0, 0, 242, 26},
                                       {"triple_vierbein.obj", 75, 108, 1, 1, 60, 20, 0},
                                       {"fan3.obj", 5, 3, 1, 1, 6, 1, 0},
                                       {"hourglass_ico.obj", 23, 40, 1, 0, 0, 0, 1},
                                       {"moebius.obj", 280, 448, 1, 1, 112, 0, 0, false}};
  for (const Expected& expected : files) {
    TriangleMesh mesh = read_mesh(std::filesystem::path(data) / "meshes" / expected.name);
    const MeshDefects found = find_index_defects(mesh);
    EXPECT_EQ(found.vertices, expected.vertices) << expected.name;
    EXPECT_EQ(found.faces, expected.faces) << expected.name;
    EXPECT_EQ(found.components, expected.components) << expected.name;
    EXPECT_EQ(found.boundary_loops, expected.boundary_loops) << expected.name;
    EXPECT_EQ(found.boundary_edges, expected.boundary_edges) << expected.name;
    EXPECT_EQ(found.non_manifold_edges, expected.non_manifold_edges) << expected.name;
    EXPECT_EQ(found.non_manifold_vertices, expected.non_manifold_vertices) << expected.name;
    EXPECT_EQ(found.orientable, expected.orientable) << expected.name;
    EXPECT_EQ(found.isolated_vertices + found.duplicate_faces, 0u) << expected.name;

    // Each can be fixed, and then holds in half-edges.
    repair(mesh, {.most_hole_edges = 0}, CancelToken());
    const MeshDefects after = find_index_defects(mesh);
    EXPECT_EQ(after.faces, expected.faces) << expected.name;
    EXPECT_EQ(after.non_manifold_edges + after.non_manifold_vertices + after.turned_edges, 0u)
        << expected.name;
  }
}

}  // namespace
}  // namespace offing::mesh_tools
