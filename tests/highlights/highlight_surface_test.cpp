// What must not change highlight points: where the mesh is, how its vertices are shared; and what they do
// about bad input.
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/highlights/highlight_search.h"

namespace offing::highlights {
namespace {

using test::ExampleSurface;
using test::RandomVectors;
using HighlightSurfaceTest = HighlightSearch;

// A sheet with a front and a back and without normals, whose front is the larger at one corner: fails if a
// vertex has no normal, or one of rounding.
TEST_F(HighlightSurfaceTest, NormalsThatCancelAreThoseOfTheLargestFace) {
  ExampleSurface sheet;
  sheet.mesh.positions_m = {
      {0.1, 0.3, 0.0}, {1.1, 0.2, 0.0}, {1.3, 1.1, 0.0}, {0.2, 0.9, 0.0}, {5.0, 5.0, 5.0}};
  sheet.mesh.faces = {{2, 1, 0}, {0, 1, 2}, {0, 2, 3}, {3, 2, 0}};
  constexpr std::size_t count = 5;
  sheet.curvatures = {.k_max_per_m = std::vector<double>(count, 1.0),
                      .k_min_per_m = std::vector<double>(count, 1.0),
                      .e_max = std::vector<glm::dvec3>(count, {1.0, 0.0, 0.0}),
                      .e_min = std::vector<glm::dvec3>(count, {0.0, 1.0, 0.0}),
                      .area_m2 = std::vector<double>(count, 1.0),
                      .confidence = std::vector<double>(count, 1.0)};
  const HighlightSurface shape = surface(sheet);
  for (std::size_t vertex = 0; vertex < 4; ++vertex)
    EXPECT_EQ(shape.mesh().normals[vertex], glm::dvec3(0.0, 0.0, vertex == 3 ? 1.0 : -1.0)) << vertex;
  EXPECT_EQ(shape.mesh().normals[4], glm::dvec3(0.0)) << "of no face";
  // The same where a file has normals of no length.
  sheet.mesh.normals.assign(count, glm::dvec3(0.0));
  EXPECT_EQ(surface(sheet).mesh().normals[3], glm::dvec3(0.0, 0.0, 1.0));
}

// Rigid motion of mesh, eye and lights together must change nothing but the axes: weights within 1e-4,
// curvatures (so sizes) within 1e-4. Here the mesh stands elsewhere and eye and lights are brought into its
// axes.
TEST_F(HighlightSurfaceTest, RigidMotionLeavesWeightsAndCurvaturesAlone) {
  const ExampleSurface example = test::bumpy_sphere(4);
  const HighlightSurface shape = surface(example);
  RandomVectors random(9);
  for (int i = 0; i < 30; ++i) {
    const Lighting lighting{place(4.0 * random.direction()),
                            {place(5.0 * random.direction()), direction(random.direction())}};
    const RigidMotion motion{random.rotation(), 100.0 * random.direction()};
    Lighting moved = lighting;
    for (Source* source : {&moved.eye, &moved.lights[0], &moved.lights[1]}) {
      source->vector = motion.rotation * source->vector;
      if (source->kind == Source::Kind::place) source->vector += motion.translation_m;
    }
    const auto expected = search_.find(shape, lighting);
    const auto back = search_.find(shape, in_mesh_axes(moved, motion));
    const HighlightSurface there = surface(test::moved(example, motion.rotation, motion.translation_m));
    const auto elsewhere = search_.find(there, moved);
    for (const auto* points : {&back, &elsewhere}) {
      ASSERT_EQ(points->size(), expected.size());
      for (std::size_t j = 0; j < expected.size(); ++j) {
        const HighlightPoint &p = (*points)[j], &q = expected[j];
        // Where the field is flat, the last bits of it move a point far; a point at an edge may change its
        // face.
        if (std::abs(q.k_max_per_m * q.k_min_per_m) < 0.3 || p.face != q.face) continue;
        EXPECT_LE(glm::distance(p.weights, q.weights), 1e-4);
        EXPECT_NEAR(p.k_max_per_m, q.k_max_per_m, 1e-4 * std::abs(q.k_max_per_m) + 1e-5);
        EXPECT_NEAR(p.k_min_per_m, q.k_min_per_m, 1e-4 * std::abs(q.k_max_per_m) + 1e-5);
      }
    }
  }
}

// A turn by 360 degrees and a way there and back: the same points within 1e-5 of the diagonal.
TEST_F(HighlightSurfaceTest, RoundTripsChangeNothing) {
  const HighlightSurface shape = surface(test::bumpy_sphere(4));
  RandomVectors random(10);
  const Lighting lighting{place(4.0 * random.direction()), {place(5.0 * random.direction())}};
  const auto expected = search_.find(shape, lighting);
  RigidMotion motion;
  const glm::dmat3 turn = random.rotation();
  const glm::dvec3 way_m(12.0, -7.0, 3.0);
  motion.rotation = glm::transpose(turn) * (turn * motion.rotation);
  motion.translation_m += way_m;
  motion.translation_m -= way_m;
  const auto points = search_.find(shape, in_mesh_axes(lighting, motion));
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LE(glm::distance(points[i].position_m, expected[i].position_m), 1e-5 * shape.diagonal_m());
  }
}

// Copies of vertices along a seam must not open the surface. Fails if faces know each other by indices only.
TEST_F(HighlightSurfaceTest, SeamsDoNotMatter) {
  const ExampleSurface whole = test::bumpy_sphere(3);
  ExampleSurface torn = whole;
  torn.mesh = {};
  torn.curvatures = {};
  for (const TriangleIndices& face : whole.mesh.faces) {
    TriangleIndices own{};
    for (std::size_t i = 0; i < 3; ++i) {
      own[i] = static_cast<std::uint32_t>(torn.mesh.positions_m.size());
      torn.mesh.positions_m.push_back(whole.mesh.positions_m[face[i]]);
      torn.curvatures.k_max_per_m.push_back(whole.curvatures.k_max_per_m[face[i]]);
      torn.curvatures.k_min_per_m.push_back(whole.curvatures.k_min_per_m[face[i]]);
      torn.curvatures.e_max.push_back(whole.curvatures.e_max[face[i]]);
      torn.curvatures.e_min.push_back(whole.curvatures.e_min[face[i]]);
    }
    torn.mesh.faces.push_back(own);
  }
  ExampleSurface bare = whole;
  bare.mesh.normals.clear();  // both get the normals of their faces
  const HighlightSurface torn_surface = surface(torn), whole_surface = surface(bare);
  RandomVectors random(11);
  for (int i = 0; i < 50; ++i) {
    const Lighting lighting{direction(random.direction()), {direction(random.direction())}};
    int sum = 0;
    const auto points = search_.find(torn_surface, lighting);
    for (const HighlightPoint& point : points) sum += point.orientation;
    EXPECT_EQ(sum, 1);
    EXPECT_EQ(points.size(), search_.find(whole_surface, lighting).size());
  }
}

TEST_F(HighlightSurfaceTest, SmoothingLeavesFewerHighlightsOnANoisyScan) {
  ExampleSurface scan = test::ellipsoid(5, {1.0, 0.8, 0.6});
  scan.mesh.normals.clear();
  RandomVectors random(12);
  for (glm::dvec3& p : scan.mesh.positions_m) p *= 1.0 + 0.06 * (random.uniform() - 0.5);
  const Lighting lighting{direction({0.3, 0.2, 1.0}), {direction({-0.4, 1.0, 0.5})}};
  const std::size_t rough = search_.find(surface(scan), lighting).size();
  const std::size_t smooth = search_.find(surface(scan, {.smoothing_rounds = 20}), lighting).size();
  EXPECT_GE(rough, 5u);
  EXPECT_EQ(smooth, 1u);
}

TEST_F(HighlightSurfaceTest, BadInputIsNamed) {
  const ExampleSurface good = test::ellipsoid(1, glm::dvec3(1.0));
  const auto expect_error = [&](const auto& spoil, const char* part) {
    ExampleSurface bad = good;
    spoil(bad);
    try {
      surface(bad);
      ADD_FAILURE() << "no error with " << part;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(part));
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_FALSE(error.hint().empty());
    }
  };
  expect_error([](ExampleSurface& s) { s.mesh.faces[3][1] = 1000; }, "face 3");
  expect_error([](ExampleSurface& s) { s.mesh.positions_m[2].y = std::nan(""); }, "positions: vertex 2");
  expect_error([](ExampleSurface& s) { s.curvatures.k_min_per_m[1] = INFINITY; }, "k_min: vertex 1");
  expect_error([](ExampleSurface& s) { s.curvatures.e_max.pop_back(); }, "e_max");
  expect_error([](ExampleSurface& s) { s.mesh.normals.pop_back(); }, "normals");
  expect_error([](ExampleSurface& s) { s.mesh.positions_m.clear(); }, "vertices");
  const HighlightSurface shape = surface(good);
  EXPECT_THROW(search_.find(shape, {direction(glm::dvec3(0.0)), {direction({1.0, 0.0, 0.0})}}), Error);
  EXPECT_THROW(search_.find(shape, {direction({1.0, 0.0, 0.0}), {place({NAN, 0.0, 0.0})}}), Error);
  EXPECT_TRUE(search_.find(shape, {direction({1.0, 0.0, 0.0}), {}}).empty());
  ExampleSurface bare = good;
  bare.mesh.faces.clear();
  EXPECT_TRUE(
      search_.find(surface(bare), {direction({1.0, 0.0, 0.0}), {direction({1.0, 0.0, 0.0})}}).empty());
}

}  // namespace
}  // namespace offing::highlights
