// Rays against the faces of meshes: the same hits as by trying every face.
#include "host/highlights/search/face_tree.h"

#include <cmath>
#include <limits>
#include <random>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "host/mesh_shapes/shape.h"

namespace offing::highlights {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// By Cramer's rule, face by face.
std::optional<FaceHit> tried(const TriangleMesh& mesh, const glm::dvec3& origin_m, const glm::dvec3& way) {
  std::optional<FaceHit> first;
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    const auto& [i, j, k] = mesh.faces[face];
    const glm::dvec3 a = mesh.positions_m[i], b = mesh.positions_m[j] - a, c = mesh.positions_m[k] - a;
    const glm::dmat3 system(-way, b, c);
    const double volume = glm::determinant(system);
    if (volume == 0.0) continue;
    const auto solved = [&](int column) {
      glm::dmat3 other = system;
      other[column] = origin_m - a;
      return glm::determinant(other) / volume;
    };
    const double distance = solved(0), u = solved(1), v = solved(2);
    if (u < 0.0 || v < 0.0 || u + v > 1.0 || distance <= 0.0) continue;
    if (!first || distance < first->distance) first = FaceHit{face, distance, {1.0 - u - v, u, v}};
  }
  return first;
}

// Fails if the tree loses a face, finds one that is not first, or gives another place. Random rays at 1,536
// faces; those of both ways agree to rounding, 1e-9 of the mesh.
TEST(FaceTreeTest, FindsWhatTryingEveryFaceFinds) {
  const TriangleMesh mesh = mesh_shapes::make_torus_knot({}, {.u_cells = 64, .v_cells = 12}).mesh;
  const FaceTree tree(mesh);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
  int hits = 0;
  for (int ray = 0; ray < 500; ++ray) {
    const glm::dvec3 origin_m = 1.5 * vector(), way = 0.8 * vector() - origin_m;
    const auto found = tree.first_hit(origin_m, way, infinity), expected = tried(mesh, origin_m, way);
    ASSERT_EQ(found.has_value(), expected.has_value()) << ray;
    EXPECT_EQ(tree.is_blocked(origin_m, way, infinity), expected.has_value());
    if (!expected) continue;
    ++hits;
    EXPECT_EQ(found->face, expected->face);
    EXPECT_NEAR(found->distance, expected->distance, 1e-9);
    EXPECT_LT(glm::distance(found->weights, expected->weights), 1e-6);
    // Nothing is nearer than the first, nor counts beyond the end.
    EXPECT_FALSE(tree.is_blocked(origin_m, way, expected->distance * (1.0 - 1e-9)));
    EXPECT_TRUE(tree.is_blocked(origin_m, way, expected->distance * (1.0 + 1e-9)));
  }
  EXPECT_GT(hits, 100);
}

// Fails if rays along an axis, with components of 0, or meshes without faces or area are trouble.
TEST(FaceTreeTest, TakesDegenerateInput) {
  EXPECT_FALSE(FaceTree(TriangleMesh{}).first_hit({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, infinity));
  TriangleMesh mesh{
      .positions_m = {{-1, 0, -1}, {1, 0, -1}, {0, 0, 2}, {0, 0, 0}}, .normals = {}, .faces = {}};
  mesh.faces = {{0, 1, 2}, {3, 3, 3}, {0, 3, 0}};
  const FaceTree tree(mesh);
  const auto hit = tree.first_hit({0.0, 3.0, 0.5}, {0.0, -1.0, 0.0}, infinity);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->face, 0u);
  EXPECT_EQ(hit->distance, 3.0);
  EXPECT_FALSE(tree.first_hit({0.0, 3.0, 0.5}, {0.0, -1.0, 0.0}, 2.9));
  EXPECT_FALSE(tree.first_hit({0.0, 3.0, 0.5}, {0.0, 1.0, 0.0}, infinity));
  EXPECT_FALSE(tree.first_hit({0.0, 3.0, 0.5}, {1.0, 0.0, 0.0}, infinity));
}

}  // namespace
}  // namespace offing::highlights
