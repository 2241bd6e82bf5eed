// Curvatures on the device against those of the same method in double precision on the host.
#include "host/highlights/curvature/diffused_curvature.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/mesh_shapes/shape.h"
#include "mesh_tools/curvature/curvature.h"

namespace offing {
namespace {

using highlights::DiffusedCurvature;
using mesh_shapes::Diagonals;

std::vector<float> coordinates(const TriangleMesh& mesh) {
  std::vector<float> values;
  for (const glm::dvec3& p : mesh.positions_m) {
    for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(p[axis]));
  }
  return values;
}

/// The mesh that the device gets: positions are floats, so that rounding them is no difference of methods.
TriangleMesh rounded(TriangleMesh mesh) {
  for (glm::dvec3& p : mesh.positions_m) p = glm::dvec3(glm::vec3(p));
  return mesh;
}

VertexCurvatures on_device(const TriangleMesh& mesh, int rounds) {
  const ocl::Device device = ocl::Device::open();
  DiffusedCurvature curvature(device, mesh, rounds);
  curvature.at(ocl::Buffer<float>(device, coordinates(mesh), "positions"));
  return curvature.read();
}

VertexCurvatures on_host(const TriangleMesh& mesh, int rounds) {
  return mesh_tools::vertex_curvatures(mesh,
                                       {.method = mesh_tools::CurvatureMethod::diffused, .rounds = rounds})
      .curvatures;
}

// An angle is the difference of two unit normals that carry some 4 u over the triangle's height as a part of
// its edge each (a difference, a cross product and a division; u = 6e-8), and a curvature is the mean of a
// few angles over an edge's length. With edges of 0.03 to 0.05 m and heights down to a fifth of them the
// bound is 8 u * 5 / 0.03 = 8e-5 a vertex of its own, more beside yet thinner triangles; averaging takes most
// of it away. Measured 1.4e-4, 1.9e-5 and 4.6e-6 1/m after 0, 1 and 3 rounds; gates are some four times that,
// a hundredth of what a wrong neighbour costs. Directions turn by the error over the difference of both
// curvatures. Areas lose the digits that thin
// triangles cancel; confidence is less where bending comes near the rounding of floats, 1e-5 rad an edge.
TEST(DiffusedCurvatureTest, IsThatOfTheHost) {
  const mesh_shapes::Roughness roughness{.jitter = 0.3, .normal_noise = 0.02, .seed = 3};
  const TriangleMesh meshes[] = {rounded(make_torus(1.0, 0.4, {80, 40, Diagonals::random}, roughness).mesh),
                                 rounded(make_saddle(1.0, {40, 40, Diagonals::random}, roughness).mesh),
                                 rounded(make_ellipsoid({1.0, 0.75, 0.5}, 4, roughness).mesh)};
  for (const TriangleMesh& mesh : meshes) {
    for (const auto& [rounds, gate_per_m] : {std::pair{0, 5e-4}, std::pair{1, 8e-5}, std::pair{3, 2e-5}}) {
      const VertexCurvatures found = on_device(mesh, rounds), expected = on_host(mesh, rounds);
      for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
        const double difference_per_m = expected.k_max_per_m[i] - expected.k_min_per_m[i];
        ASSERT_NEAR(found.k_max_per_m[i], expected.k_max_per_m[i], gate_per_m) << rounds << " " << i;
        ASSERT_NEAR(found.k_min_per_m[i], expected.k_min_per_m[i], gate_per_m) << rounds << " " << i;
        ASSERT_NEAR(found.area_m2[i], expected.area_m2[i], 1e-5 * expected.area_m2[i]) << i;
        ASSERT_NEAR(found.confidence[i], expected.confidence[i], 0.01) << rounds << " " << i;
        const double turn = glm::length(glm::cross(found.e_max[i], expected.e_max[i]));
        ASSERT_LT(turn, 2e-6 + gate_per_m / difference_per_m) << rounds << " " << i;
        ASSERT_GT(glm::dot(glm::cross(found.e_max[i], found.e_min[i]),
                           glm::cross(expected.e_max[i], expected.e_min[i])),
                  0.999999);
      }
    }
  }
}

// Frames follow one another: fails if anything of the last positions is kept.
TEST(DiffusedCurvatureTest, FollowsADeformingMesh) {
  const TriangleMesh sphere = mesh_shapes::make_sphere(1.0, 3).mesh;
  TriangleMesh stretched = sphere;
  for (glm::dvec3& p : stretched.positions_m) p *= glm::dvec3(1.0, 2.0, 3.0);
  const ocl::Device device = ocl::Device::open();
  DiffusedCurvature curvature(device, sphere);
  curvature.at(ocl::Buffer<float>(device, coordinates(stretched), "positions"));
  const VertexCurvatures first = curvature.read();
  curvature.at(ocl::Buffer<float>(device, coordinates(sphere), "positions"));
  EXPECT_NEAR(curvature.read().k_max_per_m[0], 1.0, 0.05);
  curvature.at(ocl::Buffer<float>(device, coordinates(stretched), "positions"));
  EXPECT_EQ(curvature.read().k_max_per_m, first.k_max_per_m);
}

// A seam: the same surface, each face with corners of its own.
TEST(DiffusedCurvatureTest, WeldsSeams) {
  const TriangleMesh sphere = mesh_shapes::make_sphere(1.0, 2).mesh;
  TriangleMesh cut;
  for (const TriangleIndices& face : sphere.faces) {
    const auto first = static_cast<std::uint32_t>(cut.positions_m.size());
    for (const std::uint32_t corner : face) cut.positions_m.push_back(sphere.positions_m[corner]);
    cut.faces.push_back({first, first + 1, first + 2});
  }
  const VertexCurvatures whole = on_device(sphere, 3), seamed = on_device(cut, 3);
  for (std::size_t i = 0; i < cut.positions_m.size(); ++i) {
    ASSERT_NEAR(seamed.k_max_per_m[i], whole.k_max_per_m[sphere.faces[i / 3][i % 3]], 1e-4);
  }
}

// Any triples of any few points: degenerate, repeated, non-manifold, turned over. Fails on NaN, infinity, or
// directions that are neither a frame nor 0.
TEST(DiffusedCurvatureTest, AnswersWhateverTheFacesAre) {
  std::mt19937 generator(5);
  std::uniform_int_distribution<std::uint32_t> any_vertex(0, 7), any_count(1, 14);
  std::uniform_int_distribution<int> any_coordinate(-1, 1);
  for (int round = 0; round < 100; ++round) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
      mesh.positions_m.emplace_back(any_coordinate(generator), any_coordinate(generator),
                                    any_coordinate(generator));
    }
    for (std::uint32_t i = any_count(generator); i > 0; --i) {
      mesh.faces.push_back({any_vertex(generator), any_vertex(generator), any_vertex(generator)});
    }
    const VertexCurvatures found = on_device(mesh, 2);
    for (std::size_t i = 0; i < 8; ++i) {
      ASSERT_TRUE(std::isfinite(found.k_max_per_m[i]) && std::isfinite(found.k_min_per_m[i]))
          << round << " " << i;
      ASSERT_GE(found.k_max_per_m[i], found.k_min_per_m[i]) << round << " " << i;
      ASSERT_TRUE(found.confidence[i] >= 0.0 && found.confidence[i] <= 1.0) << round << " " << i;
      const double frame = glm::length(glm::cross(found.e_max[i], found.e_min[i]));
      ASSERT_NEAR(frame, frame > 0.5 ? 1.0 : 0.0, 1e-5) << round << " " << i;
    }
  }
}

TEST(DiffusedCurvatureTest, RefusesWhatItCannotUse) {
  const ocl::Device device = ocl::Device::open();
  const TriangleMesh sphere = mesh_shapes::make_sphere(1.0, 1).mesh;
  EXPECT_THROW(DiffusedCurvature(device, sphere, -1), Error);
  EXPECT_THROW(DiffusedCurvature(device, {}, 3), Error);
  EXPECT_THROW(DiffusedCurvature(device, {{{0, 0, 0}}, {}, {{0, 0, 1}}}, 3), Error);
  DiffusedCurvature curvature(device, sphere);
  EXPECT_THROW(curvature.at(ocl::Buffer<float>(device, 5, "too few")), Error);
}

}  // namespace
}  // namespace offing
