// Made shapes: their truth against differences of the mesh itself, and their topology.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/mesh_shapes/shape.h"
#include "mesh_tools/curvature/unit_mesh.h"

namespace offing::mesh_tools {
namespace {

using namespace mesh_shapes;

/// Closed, and every edge is passed once each way.
void expect_closed(const Shape& shape, long long characteristic) {
  const UnitMesh mesh = unit_mesh(shape.mesh);
  EXPECT_EQ(euler_characteristic(mesh.neighbours), characteristic);
  for (std::uint32_t edge = 0; edge < mesh.neighbours.edges.size(); ++edge) {
    const auto faces = mesh.neighbours.edge_faces.row(edge);
    ASSERT_EQ(faces.size(), 2u);
    ASSERT_NE(mesh.neighbours.runs_along(faces[0], edge), mesh.neighbours.runs_along(faces[1], edge));
  }
}

double enclosed_volume_m3(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.faces) {
    sum += glm::dot(mesh.positions_m[a], glm::cross(mesh.positions_m[b], mesh.positions_m[c])) / 6.0;
  }
  return sum;
}

/// Along a short edge d at a vertex with normal n, the surface falls by k d^2 / 2, and k lies between the
/// principal curvatures as Euler has it: k = k_max cos^2 + k_min sin^2. The mean over edges of the
/// difference, over the largest curvature; third derivatives leave some first order of the edge.
double euler_difference(const Shape& shape) {
  const VertexCurvatures& truth = *shape.truth;
  double sum = 0.0, count = 0.0;
  for (const TriangleIndices& face : shape.mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = face[i], to = face[(i + 1) % 3];
      const glm::dvec3 along = shape.mesh.positions_m[to] - shape.mesh.positions_m[from];
      const double length_squared = glm::dot(along, along);
      const double measured = -2.0 * glm::dot(along, shape.mesh.normals[from]) / length_squared;
      const double c = glm::dot(along, truth.e_max[from]), s = glm::dot(along, truth.e_min[from]);
      const double expected =
          (truth.k_max_per_m[from] * c * c + truth.k_min_per_m[from] * s * s) / (c * c + s * s);
      sum += std::abs(measured - expected) /
             std::max(std::abs(truth.k_max_per_m[from]), std::abs(truth.k_min_per_m[from]));
      ++count;
    }
  }
  return sum / count;
}

// The truth of each shape against its own vertices. Fails if a formula, a sign or a direction is wrong: that
// is an error of the order of 1. Halving edges must halve what is left, the error of the comparison itself.
TEST(Shapes, TruthIsWhatTheirEdgesShow) {
  const auto expect_true = [](const auto& make, const char* name) {
    const double coarse = euler_difference(make(1)), fine = euler_difference(make(2));
    EXPECT_LT(fine, 0.05) << name;
    EXPECT_LT(fine, 0.65 * coarse) << name;
  };
  expect_true([](int times) { return make_ellipsoid({1.0, 0.75, 0.5}, 3 + times); }, "ellipsoid");
  expect_true([](int times) { return make_torus(2.0, 0.7, {64 * times, 32 * times}); }, "torus");
  expect_true([](int times) { return make_torus_knot({}, {360 * times, 36 * times}); }, "torus knot");
  expect_true([](int times) { return make_saddle(3.0, {32 * times, 32 * times}); }, "saddle");
  expect_true([](int times) { return make_head(0.1, 5 + times); }, "head");
  expect_true([](int times) { return make_bumpy_sphere(0.1, 0.002, 4 + times); }, "bumpy");
}

TEST(Shapes, AreClosedAndFaceOutward) {
  expect_closed(make_sphere(1.0, 3), 2);
  expect_closed(make_head(0.1, 3), 2);
  expect_closed(make_bumpy_sphere(0.1, 0.015, 3), 2);
  expect_closed(make_torus(1.0, 0.4, {30, 20, Diagonals::random}), 0);
  expect_closed(make_torus_knot({}, {120, 12}), 0);
  expect_closed(make_ship(10.0, {40, 24}), 2);
  expect_closed(make_bird(1.6, {60, 12}), 2);
  expect_closed(make_boat(6.0, {40, 24}), 2);
  expect_closed(make_box({1.0, 2.0, 3.0}, 2), 2);
  expect_closed(make_cylinder(1.0, 2.0, {3, 24}), 2);
  expect_closed(make_cone(1.0, 2.0, {3, 24}), 2);
  // Of 24 corners.
  const double prism_m3 = 2.0 * 12.0 * std::sin(std::numbers::pi / 12.0);
  EXPECT_NEAR(enclosed_volume_m3(make_cylinder(1.0, 2.0, {3, 24}).mesh), prism_m3, 1e-12);
  EXPECT_NEAR(enclosed_volume_m3(make_cone(1.0, 2.0, {3, 24}).mesh), prism_m3 / 3.0, 1e-12);
  EXPECT_NEAR(enclosed_volume_m3(make_sphere(2.0, 5).mesh), 32.0 / 3.0 * std::numbers::pi, 0.05);
  EXPECT_NEAR(enclosed_volume_m3(make_torus(1.0, 0.4, {200, 100}).mesh),
              2.0 * std::pow(std::numbers::pi * 0.4, 2), 0.01);
  EXPECT_GT(enclosed_volume_m3(make_torus_knot({}, {120, 12}).mesh), 0.0);
  EXPECT_GT(enclosed_volume_m3(make_ship(10.0, {40, 24}).mesh), 0.0);
  EXPECT_GT(enclosed_volume_m3(make_bird(1.6, {60, 12}).mesh), 0.0);
  EXPECT_GT(enclosed_volume_m3(make_boat(6.0, {40, 24}).mesh), 0.0);
  EXPECT_NEAR(enclosed_volume_m3(make_box({1.0, 2.0, 3.0}, 2).mesh), 6.0, 1e-12);
  EXPECT_GT(enclosed_volume_m3(make_head(0.1, 4).mesh), 0.0);
}

TEST(Shapes, ThePapersKnotHasItsFaces) {
  EXPECT_EQ(make_torus_knot({}, {120, 12}).mesh.faces.size(), 2880u);
}

// Fails if a number is drawn from anything but seed and index.
TEST(Shapes, SeedsDecideWhatIsDrawn) {
  const auto torus = [](std::uint64_t seed) {
    return make_torus(1.0, 0.4, {30, 20, Diagonals::random},
                      {.jitter = 0.3, .normal_noise = 0.1, .seed = seed})
        .mesh;
  };
  EXPECT_EQ(torus(1).positions_m, torus(1).positions_m);
  EXPECT_EQ(torus(1).faces, torus(1).faces);
  EXPECT_NE(torus(1).positions_m, torus(2).positions_m);
  EXPECT_NE(torus(1).faces, torus(2).faces);
}

TEST(Shapes, RefuseSizesThatMakeNoShape) {
  EXPECT_THROW(make_sphere(-1.0, 3), Error);
  EXPECT_THROW(make_sphere(1.0, 10), Error);
  EXPECT_THROW(make_bumpy_sphere(1.0, 0.5, 3), Error);
  EXPECT_THROW(make_torus(1.0, 1.0, {30, 20}), Error);
  EXPECT_THROW(make_torus(1.0, 0.4, {2, 20}), Error);
  EXPECT_THROW(make_torus_knot({.tube_radius_m = 0.9}, {120, 12}), Error);
  EXPECT_THROW(make_saddle(1.0, {10, 10}, {.jitter = 0.6}), Error);
  EXPECT_THROW(make_ship(std::nan(""), {40, 24}), Error);
  EXPECT_THROW(make_bird(1.0, {60, 3}), Error);
  EXPECT_THROW(make_cone(1.0, 0.0, {12, 48}), Error);
  EXPECT_THROW(make_cylinder(1.0, 2.0, {12, 2}), Error);
}

}  // namespace
}  // namespace offing::mesh_tools
