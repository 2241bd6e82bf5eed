#include "host/io/meshes/prepared_mesh.h"

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/io/meshes/mesh_samples.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

using ::testing::HasSubstr;

/// Some mesh with some curvatures that keep the promises.
PreparedMesh some_mesh() {
  PreparedMesh prepared{.mesh = test::random_mesh(9), .curvatures = {}};
  for (std::size_t i = 0; i < prepared.mesh.positions_m.size(); ++i) {
    const double t = 0.1 * static_cast<double>(i);
    const glm::dvec3 e_max(std::cos(t), std::sin(t), 0.0), e_min(-std::sin(t), std::cos(t), 0.0);
    prepared.mesh.normals.push_back(glm::cross(e_max, e_min));
    prepared.curvatures.e_max.push_back(i == 3 ? glm::dvec3(0.0) : e_max);
    prepared.curvatures.e_min.push_back(i == 3 ? glm::dvec3(0.0) : e_min);
    prepared.curvatures.k_max_per_m.push_back(1.0 / 3.0 + t);
    prepared.curvatures.k_min_per_m.push_back(1.0 / 3.0 - t);
    prepared.curvatures.area_m2.push_back(0.7 * t);
    prepared.curvatures.confidence.push_back(i == 3 ? 0.0 : 1.0 - 1.0 / (3.0 + t));
  }
  return prepared;
}

// Fails if an array is written under another's name, or lost. Bound: numbers are floats, 2^-24 of about 10.
TEST(PreparedMesh, ReadsBack) {
  const TemporaryFolder folder;
  const PreparedMesh written = some_mesh();
  const std::vector<double> extra(written.mesh.positions_m.size(), 5.0);
  const std::vector<Colour8> colours(written.mesh.positions_m.size(), Colour8{1, 2, 3});
  write_prepared(folder.path() / "a.ply", written,
                 {.properties = {{"true_k_max", extra}}, .colours = colours, .comments = {"a comment"}});
  const PreparedMesh read = read_prepared(folder.path() / "a.ply");
  EXPECT_EQ(read.mesh.positions_m, written.mesh.positions_m);
  EXPECT_EQ(read.mesh.faces, written.mesh.faces);
  constexpr double tolerance = 1e-6;
  for (std::size_t i = 0; i < written.mesh.positions_m.size(); ++i) {
    EXPECT_NEAR(read.curvatures.k_max_per_m[i], written.curvatures.k_max_per_m[i], tolerance);
    EXPECT_NEAR(read.curvatures.k_min_per_m[i], written.curvatures.k_min_per_m[i], tolerance);
    EXPECT_NEAR(read.curvatures.area_m2[i], written.curvatures.area_m2[i], tolerance);
    EXPECT_NEAR(read.curvatures.confidence[i], written.curvatures.confidence[i], tolerance);
    EXPECT_LT(glm::distance(read.curvatures.e_max[i], written.curvatures.e_max[i]), tolerance);
    EXPECT_LT(glm::distance(read.curvatures.e_min[i], written.curvatures.e_min[i]), tolerance);
    EXPECT_LT(glm::distance(read.mesh.normals[i], written.mesh.normals[i]), tolerance);
  }
  EXPECT_EQ(glm::length(read.curvatures.e_max[3]), 0.0);
  EXPECT_NEAR(glm::length(read.curvatures.e_max[4]), 1.0, 1e-15);
}

/// What read_prepared() says of a mesh after a change.
std::string fault_of(const std::function<void(PreparedMesh&)>& change) {
  const TemporaryFolder folder;
  PreparedMesh prepared = some_mesh();
  change(prepared);
  write_prepared(folder.path() / "a.ply", prepared);
  try {
    read_prepared(folder.path() / "a.ply");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    return error.what();
  }
  return "";
}

// Fails if curvatures that break the promises of VertexCurvatures are taken, or the vertex is not named.
TEST(PreparedMesh, BrokenPromisesAreRefused) {
  EXPECT_EQ(fault_of([](PreparedMesh&) {}), "");
  EXPECT_THAT(fault_of([](PreparedMesh& p) { p.curvatures.k_min_per_m[2] = 9.0; }),
              HasSubstr("k_max >= k_min at vertex 2"));
  EXPECT_THAT(fault_of([](PreparedMesh& p) { p.curvatures.e_max[5] *= 1.1; }),
              HasSubstr("unit directions at vertex 5"));
  EXPECT_THAT(fault_of([](PreparedMesh& p) { p.curvatures.area_m2[1] = -1.0; }),
              HasSubstr("an area from 0 on at vertex 1"));
  EXPECT_THAT(fault_of([](PreparedMesh& p) { p.curvatures.confidence[7] = 1.5; }), HasSubstr("confidence"));
}

// Fails if a mesh without curvatures or normals is taken for a prepared one.
TEST(PreparedMesh, WhatIsNotPreparedIsRefused) {
  const TemporaryFolder folder;
  PreparedMesh prepared = some_mesh();
  write_ply(folder.path() / "plain.ply", prepared.mesh);
  try {
    read_prepared(folder.path() / "plain.ply");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("plain.ply: expected a property k_max of vertices, got none"));
    EXPECT_THAT(error.hint(), HasSubstr("offing-mesh curvature"));
  }
  prepared.mesh.normals.clear();
  EXPECT_THROW(write_prepared(folder.path() / "a.ply", prepared), Error);
  prepared = some_mesh();
  prepared.curvatures.e_max.pop_back();
  EXPECT_THROW(write_prepared(folder.path() / "a.ply", prepared), Error);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.ply"));
}

}  // namespace
}  // namespace offing
