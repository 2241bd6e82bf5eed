// What must not change curvatures: where a mesh is, how large, in which order, on how many threads.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>

#include "host/mesh_shapes/shape.h"
#include "mesh_tools/curvature/curvature.h"

namespace offing::mesh_tools {
namespace {

using namespace mesh_shapes;

constexpr CurvatureMethod all_methods[] = {CurvatureMethod::fit,          CurvatureMethod::tensor,
                                           CurvatureMethod::tensor_exact, CurvatureMethod::paper,
                                           CurvatureMethod::diffused,     CurvatureMethod::jet};

TriangleMesh rough_torus() {
  return make_torus(1.0, 0.4, {40, 20, Diagonals::random}, {.jitter = 0.3, .normal_noise = 0.02, .seed = 3})
      .mesh;
}

// Rotation about (1, 2, 3) / sqrt(14) by 1 rad, by Rodrigues' formula.
glm::dmat3 rotation() {
  const glm::dvec3 k = glm::normalize(glm::dvec3(1.0, 2.0, 3.0));
  const auto turned = [&](const glm::dvec3& v) {
    return std::cos(1.0) * v + std::sin(1.0) * glm::cross(k, v) + (1.0 - std::cos(1.0)) * glm::dot(k, v) * k;
  };
  return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})};
}

// Curvatures are of the surface itself. A turned, moved and enlarged mesh rounds at 1e-16 of its extent, 40
// times that of an edge, whose square the jets divide by; but a vertex on the rim of a ball to the last bit
// may fall in or out, which this mesh does not have. Gate 1e-9 of the largest curvature.
TEST(CurvatureInvariance, RigidMotionAndScaleChangeNothing) {
  const TriangleMesh mesh = rough_torus();
  constexpr double scale = 7.0;
  const glm::dmat3 turn = rotation();
  TriangleMesh moved = mesh;
  for (glm::dvec3& p : moved.positions_m) p = scale * (turn * p) + glm::dvec3(10.0, -20.0, 5.0);
  for (const CurvatureMethod method : all_methods) {
    const VertexCurvatures here = vertex_curvatures(mesh, {.method = method}).curvatures;
    const VertexCurvatures there = vertex_curvatures(moved, {.method = method}).curvatures;
    const double largest = *std::ranges::max_element(here.k_max_per_m);
    for (std::size_t i = 0; i < here.k_max_per_m.size(); ++i) {
      ASSERT_NEAR(scale * there.k_max_per_m[i], here.k_max_per_m[i], 1e-9 * largest)
          << name_of(method) << " " << i;
      ASSERT_NEAR(scale * there.k_min_per_m[i], here.k_min_per_m[i], 1e-9 * largest)
          << name_of(method) << " " << i;
      const glm::dvec3 expected = turn * here.e_max[i];
      ASSERT_GT(std::abs(glm::dot(there.e_max[i], expected)), 1.0 - 1e-6) << name_of(method) << " " << i;
      ASSERT_NEAR(there.area_m2[i], scale * scale * here.area_m2[i], 1e-9 * there.area_m2[i]);
    }
  }
}

// Sums run in another order: rounding, amplified as above. Fails if a result depends on which vertex comes
// first.
TEST(CurvatureInvariance, OrderOfVerticesAndFacesChangesNothing) {
  const TriangleMesh mesh = rough_torus();
  std::mt19937 generator(11);
  std::vector<std::uint32_t> place(mesh.positions_m.size());
  std::iota(place.begin(), place.end(), 0u);
  std::ranges::shuffle(place, generator);
  TriangleMesh shuffled = mesh;
  for (std::size_t i = 0; i < place.size(); ++i) shuffled.positions_m[place[i]] = mesh.positions_m[i];
  for (TriangleIndices& face : shuffled.faces) {
    for (std::uint32_t& corner : face) corner = place[corner];
    std::ranges::rotate(face, face.begin() + static_cast<long>(generator() % 3));
  }
  std::ranges::shuffle(shuffled.faces, generator);
  for (const CurvatureMethod method : all_methods) {
    const VertexCurvatures here = vertex_curvatures(mesh, {.method = method}).curvatures;
    const VertexCurvatures there = vertex_curvatures(shuffled, {.method = method}).curvatures;
    const double largest = *std::ranges::max_element(here.k_max_per_m);
    for (std::size_t i = 0; i < place.size(); ++i) {
      ASSERT_NEAR(there.k_max_per_m[place[i]], here.k_max_per_m[i], 1e-9 * largest)
          << name_of(method) << " " << i;
      ASSERT_NEAR(there.k_min_per_m[place[i]], here.k_min_per_m[i], 1e-9 * largest)
          << name_of(method) << " " << i;
    }
  }
}

// Not a bit: scripts compare files. The mesh has more vertices than threads take at a time.
TEST(CurvatureInvariance, ThreadsChangeNothing) {
  const TriangleMesh mesh =
      make_torus(1.0, 0.4, {100, 50, Diagonals::random}, {.jitter = 0.3, .normal_noise = 0.02, .seed = 5})
          .mesh;
  for (const CurvatureMethod method : all_methods) {
    const VertexCurvatures one = vertex_curvatures(mesh, {.method = method, .threads = 1}).curvatures;
    const VertexCurvatures five = vertex_curvatures(mesh, {.method = method, .threads = 5}).curvatures;
    EXPECT_EQ(one.k_max_per_m, five.k_max_per_m) << name_of(method);
    EXPECT_EQ(one.k_min_per_m, five.k_min_per_m) << name_of(method);
    EXPECT_EQ(one.e_max, five.e_max) << name_of(method);
    EXPECT_EQ(one.confidence, five.confidence) << name_of(method);
  }
}

// A seam, as texture coordinates make it: every face has corners of its own. Fails if copies of a vertex are
// taken for borders, or differ among themselves.
TEST(CurvatureInvariance, SeamsAreWelded) {
  const TriangleMesh mesh = rough_torus();
  TriangleMesh cut;
  for (const TriangleIndices& face : mesh.faces) {
    const auto first = static_cast<std::uint32_t>(cut.positions_m.size());
    for (const std::uint32_t corner : face) cut.positions_m.push_back(mesh.positions_m[corner]);
    cut.faces.push_back({first, first + 1, first + 2});
  }
  for (const CurvatureMethod method : all_methods) {
    const CurvatureResult whole = vertex_curvatures(mesh, {.method = method});
    const CurvatureResult seamed = vertex_curvatures(cut, {.method = method});
    for (std::size_t i = 0; i < cut.positions_m.size(); ++i) {
      const std::uint32_t corner = mesh.faces[i / 3][i % 3];
      ASSERT_NEAR(seamed.curvatures.k_max_per_m[i], whole.curvatures.k_max_per_m[corner], 1e-8)
          << name_of(method);
      ASSERT_NEAR(seamed.curvatures.area_m2[i], whole.curvatures.area_m2[corner], 1e-12) << name_of(method);
      ASSERT_GT(seamed.curvatures.confidence[i] + 1e-6, whole.curvatures.confidence[corner])
          << name_of(method);
    }
  }
}

}  // namespace
}  // namespace offing::mesh_tools
