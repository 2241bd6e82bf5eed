// Meshes as they come: nothing of them may crash a method or make it answer NaN.
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/mesh_shapes/shape.h"
#include "mesh_tools/curvature/curvature.h"

namespace offing::mesh_tools {
namespace {

using namespace mesh_shapes;

constexpr CurvatureMethod all_methods[] = {CurvatureMethod::fit,          CurvatureMethod::tensor,
                                           CurvatureMethod::tensor_exact, CurvatureMethod::paper,
                                           CurvatureMethod::diffused,     CurvatureMethod::jet};

/// All of the result is finite, directions are a frame or 0, confidence is within 0 ... 1, larger is larger.
void expect_sound(const TriangleMesh& mesh, const std::string& what) {
  for (const CurvatureMethod method : all_methods) {
    const CurvatureResult result = vertex_curvatures(mesh, {.method = method});
    const VertexCurvatures& found = result.curvatures;
    ASSERT_EQ(found.k_max_per_m.size(), mesh.positions_m.size());
    for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
      const std::string where = what + ", " + std::string(name_of(method)) + ", vertex " + std::to_string(i);
      ASSERT_TRUE(std::isfinite(found.k_max_per_m[i]) && std::isfinite(found.k_min_per_m[i])) << where;
      ASSERT_GE(found.k_max_per_m[i], found.k_min_per_m[i]) << where;
      ASSERT_TRUE(found.area_m2[i] >= 0.0 && std::isfinite(found.area_m2[i])) << where;
      ASSERT_TRUE(found.confidence[i] >= 0.0 && found.confidence[i] <= 1.0) << where << found.confidence[i];
      ASSERT_NEAR(glm::length(result.normals[i]), 1.0, 1e-9) << where;
      if (found.e_max[i] == glm::dvec3(0.0)) {
        ASSERT_EQ(found.confidence[i], 0.0) << where;
        ASSERT_EQ(found.e_min[i], glm::dvec3(0.0)) << where;
      } else {
        ASSERT_LT(glm::distance(glm::cross(found.e_max[i], found.e_min[i]), result.normals[i]), 1e-6)
            << where;
      }
    }
  }
}

TEST(BrokenMesh, NothingAtAll) {
  expect_sound({}, "empty");
  expect_sound({.positions_m = {{1, 2, 3}, {4, 5, 6}}, .normals = {}, .faces = {}}, "no faces");
}

TEST(BrokenMesh, FacesWithoutArea) {
  const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 0, 0}};
  expect_sound({points, {}, {{0, 0, 1}}}, "a vertex twice");
  expect_sound({points, {}, {{0, 1, 3}}}, "three in a row");
  expect_sound({points, {}, {{0, 4, 1}}}, "two at one place");
  expect_sound({points, {}, {{0, 1, 2}, {0, 1, 3}, {1, 1, 1}}}, "beside a sound one");
  expect_sound({std::vector<glm::dvec3>(5, {1e300, -1e300, 3}), {}, {{0, 1, 2}}}, "all at one place");
}

TEST(BrokenMesh, ManifoldNowhere) {
  const std::vector<glm::dvec3> points{{0, 0, 0},  {1, 0, 0},  {0, 1, 0}, {0, 0, 1},
                                       {0, -1, 0}, {-1, 0, 0}, {0, 0, -1}};
  expect_sound({points, {}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}}, "three faces at an edge");
  expect_sound({points, {}, {{0, 1, 2}, {0, 1, 2}, {0, 2, 1}}}, "a face three times, once turned over");
  expect_sound({points, {}, {{0, 1, 2}, {0, 2, 1}}}, "two faces back to back");
  expect_sound({points, {}, {{0, 1, 2}, {0, 5, 6}}}, "two fans at a vertex");
  expect_sound({points, {}, {{0, 1, 2}, {0, 1, 3}}}, "two faces that disagree which side is out");
}

// Any triples of any few points, thousands of meshes: whatever happens among 8 points happens here.
TEST(BrokenMesh, AnyFacesAmongFewPoints) {
  std::mt19937 generator(5);
  std::uniform_int_distribution<std::uint32_t> any_vertex(0, 7), any_count(0, 14);
  std::uniform_int_distribution<int> any_coordinate(-1, 1);
  for (int round = 0; round < 2000; ++round) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
      mesh.positions_m.emplace_back(any_coordinate(generator), any_coordinate(generator),
                                    any_coordinate(generator));
    }
    for (std::uint32_t i = any_count(generator); i > 0; --i) {
      mesh.faces.push_back({any_vertex(generator), any_vertex(generator), any_vertex(generator)});
    }
    ASSERT_NO_FATAL_FAILURE(expect_sound(mesh, "round " + std::to_string(round)));
  }
}

// Squares of such lengths overflow or vanish. Curvatures scale all the same.
TEST(BrokenMesh, HugeAndTiny) {
  const TriangleMesh sphere = make_sphere(1.0, 2).mesh;
  for (const double scale : {1e-90, 1e90}) {
    TriangleMesh scaled = sphere;
    for (glm::dvec3& p : scaled.positions_m) p *= scale;
    expect_sound(scaled, "scaled");
    EXPECT_NEAR(vertex_curvatures(scaled).curvatures.k_max_per_m[0] * scale, 1.0, 0.1);
  }
}

// A plane bends nowhere and prefers no direction, in its middle and on its border.
TEST(BrokenMesh, PlaneHasNoDirection) {
  TriangleMesh plane = make_saddle(1.0, {10, 10}).mesh;
  for (glm::dvec3& p : plane.positions_m) p.z = 0.0;
  for (const CurvatureMethod method : all_methods) {
    const VertexCurvatures found = vertex_curvatures(plane, {.method = method}).curvatures;
    for (std::size_t i = 0; i < found.k_max_per_m.size(); ++i) {
      ASSERT_NEAR(found.k_max_per_m[i], 0.0, 1e-9) << name_of(method);
      ASSERT_LT(found.confidence[i], 1e-3) << name_of(method);
    }
  }
}

// What cannot be answered is refused with what, where and the fix.
TEST(BrokenMesh, RefusesWhatIsNoMesh) {
  const auto refusal = [](const TriangleMesh& mesh, const CurvatureOptions& options = {}) {
    try {
      vertex_curvatures(mesh, options);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal({{{0, 0, 0}, {0, nan, 0}}, {}, {}}),
            "mesh: vertex 1: expected finite coordinates, found (0, nan, 0)");
  EXPECT_EQ(refusal({{{0, 0, 0}}, {}, {{0, 0, 1}}}), "mesh: face 0: expected vertices below 1, found 1");
  EXPECT_EQ(refusal({{{-1e300, 0, 0}, {1e300, 0, 0}}, {}, {}}),
            "mesh: expected an extent of at most 1e+100 m, found 2e+300 m");
  EXPECT_EQ(refusal({}, {.radius_edges = 0.0}),
            "curvature: radius in edges: expected a value within 0.01 ... 100, found 0");
  EXPECT_EQ(refusal({}, {.method = CurvatureMethod::diffused, .rounds = -1}),
            "curvature: rounds: expected a value within 0 ... 1000, found -1");
}

}  // namespace
}  // namespace offing::mesh_tools
