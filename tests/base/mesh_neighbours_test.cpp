#include "host/base/mesh_neighbours.h"

#include <algorithm>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

bool is_face(const TriangleIndices& face) {
  return face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
}

bool has(const TriangleIndices& face, std::uint32_t vertex) {
  return std::ranges::find(face, vertex) != face.end();
}

// All lists against a search through all faces, for any faces among few vertices: edges of many faces,
// repeated faces, faces that name a vertex twice, vertices of none. Fails if a list misses, repeats or
// invents an entry.
TEST(MeshNeighboursTest, AreThoseThatASearchFinds) {
  constexpr std::uint32_t vertices = 7;
  std::mt19937 generator(3);
  std::uniform_int_distribution<std::uint32_t> any_vertex(0, vertices - 1), any_count(0, 12);
  for (int round = 0; round < 500; ++round) {
    std::vector<TriangleIndices> faces(any_count(generator));
    for (TriangleIndices& face : faces) {
      for (std::uint32_t& corner : face) corner = any_vertex(generator);
    }
    const MeshNeighbours mesh = mesh_neighbours(vertices, faces);
    std::vector<EdgeIndices> edges;
    for (std::uint32_t a = 0; a < vertices; ++a) {
      std::vector<std::uint32_t> around, neighbours;
      for (std::uint32_t face = 0; face < faces.size(); ++face) {
        if (is_face(faces[face]) && has(faces[face], a)) around.push_back(face);
      }
      EXPECT_THAT(mesh.vertex_faces.row(a), ElementsAreArray(around));
      for (std::uint32_t b = 0; b < vertices; ++b) {
        std::vector<std::uint32_t> at_edge;
        std::ranges::copy_if(around, std::back_inserter(at_edge),
                             [&](std::uint32_t face) { return b != a && has(faces[face], b); });
        if (at_edge.empty()) continue;
        neighbours.push_back(b);
        if (b < a) continue;
        EXPECT_THAT(mesh.edge_faces.row(edges.size()), ElementsAreArray(at_edge));
        edges.push_back({a, b});
      }
      EXPECT_THAT(mesh.neighbours_of(a), testing::UnorderedElementsAreArray(neighbours));
    }
    EXPECT_EQ(mesh.edges, edges);
    for (std::size_t face = 0; face < faces.size(); ++face) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t edge = mesh.face_edges[face][i];
        if (!is_face(faces[face])) {
          EXPECT_EQ(edge, MeshNeighbours::none);
          continue;
        }
        const std::uint32_t from = faces[face][i], to = faces[face][(i + 1) % 3];
        EXPECT_EQ(mesh.edges[edge], (EdgeIndices{std::min(from, to), std::max(from, to)}));
        EXPECT_EQ(mesh.runs_along(static_cast<std::uint32_t>(face), edge), from < to);
      }
    }
  }
}

TEST(MeshNeighboursTest, WeldsPlacesAndRefusesUnknownVertices) {
  const std::vector<glm::dvec3> positions_m{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}};
  const std::vector<TriangleIndices> faces{{0, 1, 2}, {3, 2, 1}};
  EXPECT_THAT(welded_faces(faces, first_at_place(positions_m)),
              ElementsAre(TriangleIndices{0, 1, 2}, TriangleIndices{0, 2, 1}));
  try {
    mesh_neighbours(3, faces);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), "mesh: face 1: expected vertices below 3, found 3");
  }
}

}  // namespace
}  // namespace offing
