#include "host/io/meshes/polygon_triangles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace offing::meshes {
namespace {

using Points = std::vector<glm::dvec3>;

std::vector<TriangleIndices> cut(const Points& points) {
  std::vector<std::uint32_t> corners(points.size());
  std::iota(corners.begin(), corners.end(), 0u);
  std::vector<TriangleIndices> faces;
  EXPECT_TRUE(PolygonCutter(points).cut(corners, faces));
  return faces;
}

glm::dvec3 doubled_area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::cross(b - a, c - a);
}

/// Twice the area of a plane polygon, along its normal (Newell).
glm::dvec3 doubled_area(const Points& points) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += glm::cross(points[i], points[(i + 1) % points.size()]);
  return sum;
}

/// Fails unless there are n - 2 triangles, each edge of the polygon is in one and each other edge in two, and
/// the triangles add up to the polygon without one lying over another: all turn the way of the polygon.
void expect_cover(const Points& points, const std::vector<TriangleIndices>& faces) {
  ASSERT_EQ(faces.size(), points.size() - 2);
  const glm::dvec3 whole = doubled_area(points);
  std::map<std::set<std::uint32_t>, int> uses;
  double sum = 0.0;
  for (const TriangleIndices& face : faces) {
    const glm::dvec3 part = doubled_area(points[face[0]], points[face[1]], points[face[2]]);
    // Corners on a line give triangles without an area, with rounding to either side.
    EXPECT_GE(glm::dot(part, glm::normalize(whole)), -1e-12);
    sum += glm::length(part);
    for (std::size_t i = 0; i < 3; ++i) ++uses[{face[i], face[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : uses) {
    const std::uint32_t low = *edge.begin(), high = *edge.rbegin();
    const bool is_border = high - low == 1 || (low == 0 && high + 1 == points.size());
    EXPECT_EQ(count, is_border ? 1 : 2) << low << ' ' << high;
  }
  // Bound: sums of up to 200 areas of about 1, each rounded a few times.
  EXPECT_NEAR(sum, glm::length(whole), 1e-12 * static_cast<double>(points.size()));
}

/// Polygons seen from anywhere: `rotation` turns the plane.
Points turned(Points points, double angle) {
  for (glm::dvec3& p : points) {
    p = {p.x * std::cos(angle) + p.z * std::sin(angle), p.y, -p.x * std::sin(angle) + p.z * std::cos(angle)};
    p = {p.x, p.y * std::cos(angle) - p.z * std::sin(angle), p.y * std::sin(angle) + p.z * std::cos(angle)};
  }
  return points;
}

// Fails if a star-shaped polygon, concave almost everywhere, is covered twice, left open or turned over, from
// whichever side it is seen and whichever axis its normal is nearest to.
TEST(PolygonTriangles, ConcavePolygonsAreCovered) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> radius(0.1, 1.0);
    const std::size_t count = 4 + random() % 40;
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
      points.emplace_back(radius(random) * glm::dvec3(std::cos(angle), std::sin(angle), 0.0));
    }
    if (seed % 2 == 1) std::reverse(points.begin(), points.end());
    points = turned(points, 0.1 * seed);
    expect_cover(points, cut(points));
  }
}

// Fails if a comb, whose ears are few, or a spiral is cut across its gaps.
TEST(PolygonTriangles, CombsAndSpirals) {
  Points comb;
  for (int tooth = 0; tooth < 30; ++tooth) {
    comb.emplace_back(tooth, 0.0, 0.0);
    comb.emplace_back(tooth + 0.5, 9.0, 0.0);
  }
  comb.emplace_back(30.0, 0.0, 0.0);
  comb.emplace_back(30.0, -1.0, 0.0);
  comb.emplace_back(0.0, -1.0, 0.0);
  for (glm::dvec3& p : comb) p /= 30.0;
  expect_cover(comb, cut(comb));
  Points spiral;
  for (int i = 0; i < 100; ++i)
    spiral.push_back(0.01 * (i + 10) * glm::dvec3(std::cos(0.2 * i), 0.0, std::sin(0.2 * i)));
  for (int i = 99; i >= 0; --i)
    spiral.push_back(0.01 * (i + 18) * glm::dvec3(std::cos(0.2 * i), 0.0, std::sin(0.2 * i)));
  expect_cover(spiral, cut(spiral));
}

// Fails if a convex polygon is not the fan that is promised, or if corners on a line make triangles of no
// area where others are possible.
TEST(PolygonTriangles, ConvexPolygonsAreFans) {
  const Points square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(cut(square), (std::vector<TriangleIndices>{{0, 1, 2}, {0, 2, 3}}));
  const Points with_middles = {{0.5, 0, 0}, {1, 0, 0}, {1, 0.5, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
  for (const TriangleIndices& face : cut(with_middles)) {
    EXPECT_GT(doubled_area(with_middles[face[0]], with_middles[face[1]], with_middles[face[2]]).z, 0.1);
  }
}

// Fails if a hole that is joined by a cut, along which the polygon runs twice, is covered.
TEST(PolygonTriangles, HolesStayOpen) {
  const Points ring = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 0},
                       {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}};
  double sum = 0.0;
  for (const TriangleIndices& face : cut(ring)) {
    const double part = doubled_area(ring[face[0]], ring[face[1]], ring[face[2]]).z;
    EXPECT_GE(part, 0.0);
    sum += part;
  }
  EXPECT_DOUBLE_EQ(sum, 2.0 * (9.0 - 1.0));
}

// Fails if a polygon that is no polygon is lost, never ends, or names other corners: all on a line, all at
// one place, crossing itself.
TEST(PolygonTriangles, OddPolygonsAreKept) {
  const std::vector<Points> odd = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}},
                                   Points(7, glm::dvec3(1, 2, 3)),
                                   {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
                                   {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {2, -1, 0}, {4, 3, 0}}};
  for (const Points& points : odd) {
    const std::vector<TriangleIndices> faces = cut(points);
    EXPECT_EQ(faces.size(), points.size() - 2);
    std::set<std::uint32_t> corners;
    for (const TriangleIndices& face : faces) corners.insert(face.begin(), face.end());
    EXPECT_EQ(corners.size(), points.size());
  }
}

// Fails if a polygon that takes n^2 steps is not given up, or leaves triangles behind; or if one is that
// takes no more than 10 n^2.
TEST(PolygonTriangles, StepsAreLimited) {
  Points points;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> within(0.0, 1.0);
  for (int i = 0; i < 2000; ++i) points.emplace_back(within(random), within(random), 0.0);
  std::vector<std::uint32_t> corners(points.size());
  std::iota(corners.begin(), corners.end(), 0u);
  std::vector<TriangleIndices> faces;
  EXPECT_FALSE(PolygonCutter(points, 100'000).cut(corners, faces));
  EXPECT_TRUE(faces.empty());
  EXPECT_TRUE(PolygonCutter(points, 40'000'000).cut(corners, faces));
  EXPECT_EQ(faces.size(), points.size() - 2);
}

}  // namespace
}  // namespace offing::meshes
