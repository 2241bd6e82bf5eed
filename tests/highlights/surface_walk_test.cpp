#include "host/highlights/search/surface_walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/highlights/search/tangent_axes.h"
#include "tests/highlights/example_surfaces.h"

namespace offing::highlights {
namespace {

using std::numbers::pi;

class SurfaceWalkTest : public testing::Test {
 protected:
  HighlightSurface surface(const test::ExampleSurface& example) const {
    return {device_, example.mesh, example.curvatures};
  }
  static SurfacePlace random_place(const HighlightSurface& shape, test::RandomVectors& random) {
    const double a = std::sqrt(random.uniform()), b = random.uniform();
    const double faces = static_cast<double>(shape.mesh().faces.size());
    return {static_cast<std::uint32_t>(random.uniform() * faces), {1.0 - a, a * (1.0 - b), a * b}};
  }
  static glm::dvec3 random_tangent(const HighlightSurface& shape, const SurfacePlace& place,
                                   test::RandomVectors& random) {
    const TangentAxes axes = tangent_axes(normal_at(shape, place));
    const double angle = 2.0 * pi * random.uniform();
    return std::cos(angle) * axes.right + std::sin(angle) * axes.up;
  }

  ocl::Device device_ = ocl::Device::open();
};

// On a sphere straight ways are great circles: sixteen chords of L / 16 turn by 2 asin(L / 32) each. Bound:
// faces lie up to 7e-5 below this sphere, and their interpolated normals are off by 2e-4 at either end.
// Measured 4.1e-4. Gate 1e-3: one face is 0.024 wide.
TEST_F(SurfaceWalkTest, WaysOnASphereAreGreatCircles) {
  const HighlightSurface shape = surface(test::ellipsoid(6, glm::dvec3(1.0)));
  test::RandomVectors random(3);
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    const SurfacePlace from = random_place(shape, random);
    const glm::dvec3 start = glm::normalize(position_at(shape, from));
    const glm::dvec3 way = random_tangent(shape, from, random);
    const double length_m = 3.0 * random.uniform();
    const SurfaceWalk walk = walk_over(shape, from, way, length_m);
    const double angle = 32.0 * std::asin(length_m / 32.0);
    const glm::dvec3 end = glm::normalize(position_at(shape, walk.place));
    worst = std::max(worst, glm::distance(end, std::cos(angle) * start + std::sin(angle) * way));
    worst =
        std::max(worst, glm::distance(walk.rotation * way, -std::sin(angle) * start + std::cos(angle) * way));
  }
  EXPECT_LE(worst, 1e-3);
}

// There and back again: each step is the same line from both ends, found to 1e-12 of the diagonal. Bound on
// smooth surfaces 16 x 1e-12 each way, grown by what neighbouring ways part: 1e-10. Measured 2e-13. Gate
// 1e-5, what artists are promised. Fails if a way bends at vertices, or depends on where it came from.
TEST_F(SurfaceWalkTest, WaysLeadBack) {
  for (const test::ExampleSurface& example :
       {test::ellipsoid(4, {1.0, 0.5, 0.75}), test::torus(40, 20, 1.0, 0.4), test::bumpy_sphere(5)}) {
    const HighlightSurface shape = surface(example);
    test::RandomVectors random(5);
    double worst = 0.0;
    for (int i = 0; i < 300; ++i) {
      const SurfacePlace from = random_place(shape, random);
      const glm::dvec3 way = random_tangent(shape, from, random);
      const double length_m = 0.5 * random.uniform();
      const SurfaceWalk there = walk_over(shape, from, way, length_m);
      const SurfaceWalk back = walk_over(shape, there.place, -(there.rotation * way), length_m);
      worst = std::max(worst, glm::distance(position_at(shape, back.place), position_at(shape, from)));
      worst = std::max(worst, glm::distance(back.rotation * (there.rotation * way), way));
      EXPECT_LE(glm::distance(there.rotation * normal_at(shape, from), normal_at(shape, there.place)), 1e-12);
    }
    EXPECT_LE(worst, 1e-5 * shape.diagonal_m()) << example.mesh.faces.size();
  }
}

// A small change of direction or length moves the end by as little: no jump beside vertices. On this torus
// ways part by less than a factor of 3 over their length (K >= -1 / (0.4 x 0.6)), so that 1e-4 rad of a way
// of 0.8 m moves its end by less than 2.4e-4 m. Measured 1.2e-4. A way that bent at vertices would leap by
// 0.8 m times their share of curvature, about 0.01 m.
TEST_F(SurfaceWalkTest, EndsMoveContinuously) {
  const HighlightSurface shape = surface(test::torus(40, 20, 1.0, 0.4));
  test::RandomVectors random(9);
  double worst_turned = 0.0, worst_longer = 0.0;
  for (int i = 0; i < 20; ++i) {
    const SurfacePlace from = random_place(shape, random);
    const TangentAxes axes = tangent_axes(normal_at(shape, from));
    const auto end = [&](double angle, double length_m) {
      const glm::dvec3 way = std::cos(angle) * axes.right + std::sin(angle) * axes.up;
      return position_at(shape, walk_over(shape, from, way, length_m).place);
    };
    const double first = 2.0 * pi * random.uniform();
    for (int step = 0; step < 200; ++step) {
      const double angle = first + 1e-4 * step, length_m = 0.8 + 1e-4 * step;
      worst_turned = std::max(worst_turned, glm::distance(end(angle, 0.8), end(angle + 1e-4, 0.8)));
      worst_longer = std::max(worst_longer, glm::distance(end(first, length_m), end(first, length_m + 1e-4)));
    }
  }
  EXPECT_LE(worst_turned, 2.4e-4);
  EXPECT_LE(worst_longer, 2.4e-4);
}

// A flat sheet with vertices and edges right on the way: fails if a line that goes through a vertex, along an
// edge, or from one is lost, or if a way leaves a sheet at its border.
TEST_F(SurfaceWalkTest, LinesThroughVerticesAndAlongEdgesGoOn) {
  constexpr std::uint32_t cells = 6;
  test::ExampleSurface sheet;
  for (std::uint32_t y = 0; y <= cells; ++y) {
    for (std::uint32_t x = 0; x <= cells; ++x) sheet.mesh.positions_m.emplace_back(x, y, 0.0);
  }
  for (std::uint32_t y = 0; y < cells; ++y) {
    for (std::uint32_t x = 0; x < cells; ++x) {
      const std::uint32_t a = y * (cells + 1) + x;
      sheet.mesh.faces.push_back({a, a + 1, a + cells + 2});
      sheet.mesh.faces.push_back({a, a + cells + 2, a + cells + 1});
    }
  }
  const std::size_t count = sheet.mesh.positions_m.size();
  sheet.curvatures = {.k_max_per_m = std::vector<double>(count, 0.0),
                      .k_min_per_m = std::vector<double>(count, 0.0),
                      .e_max = std::vector<glm::dvec3>(count, {1.0, 0.0, 0.0}),
                      .e_min = std::vector<glm::dvec3>(count, {0.0, 1.0, 0.0}),
                      .area_m2 = std::vector<double>(count, 1.0),
                      .confidence = std::vector<double>(count, 0.0)};
  const HighlightSurface shape = surface(sheet);
  const glm::dvec3 middle(3.0, 3.0, 0.0);
  for (int eighth = 0; eighth < 8; ++eighth) {
    const glm::dvec3 way(std::cos(0.25 * pi * eighth), std::sin(0.25 * pi * eighth), 0.0);
    for (std::uint32_t face = 0; face < shape.mesh().faces.size(); ++face) {
      const SurfacePlace from = place_of_face_near(shape, face, middle);
      if (position_at(shape, from) != middle) continue;  // every face around the vertex serves as start
      const glm::dvec3 end = position_at(shape, walk_over(shape, from, way, 2.5).place);
      EXPECT_LE(glm::distance(end, middle + 2.5 * way), 1e-12) << eighth << " " << face;
    }
    const SurfacePlace start = nearest_place(shape, middle);
    const glm::dvec3 far = position_at(shape, walk_over(shape, start, way, 30.0).place);
    const glm::dvec3 border = middle + 3.0 * glm::normalize(way) / std::max(std::abs(way.x), std::abs(way.y));
    EXPECT_LE(glm::distance(far, border), 1e-12) << eighth;
  }
}

// A second reference for places: the nearest of many samples is no nearer. Fails if the nearest place is on
// the wrong face, or its weights are those of another corner.
TEST_F(SurfaceWalkTest, NearestPlacesAreNearest) {
  const HighlightSurface shape = surface(test::bumpy_sphere(3));
  test::RandomVectors random(13);
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 point = 1.5 * random.uniform() * random.direction();
    const SurfacePlace place = nearest_place(shape, point);
    const double found_m = glm::distance(position_at(shape, place), point);
    EXPECT_NEAR(place.weights.x + place.weights.y + place.weights.z, 1.0, 1e-14);
    for (int sample = 0; sample < 3000; ++sample)
      EXPECT_LE(found_m, glm::distance(position_at(shape, random_place(shape, random)), point) + 1e-12);
    // On that face the samples come near it.
    double least_m = 1e9;
    for (int sample = 0; sample < 500; ++sample) {
      SurfacePlace other = random_place(shape, random);
      other.face = place.face;
      least_m = std::min(least_m, glm::distance(position_at(shape, other), point));
    }
    EXPECT_LE(least_m - found_m, 0.03);
  }
}

TEST_F(SurfaceWalkTest, NoFacesAreAnError) {
  test::ExampleSurface example = test::ellipsoid(1, glm::dvec3(1.0));
  example.mesh.faces.clear();
  const HighlightSurface shape = surface(example);
  EXPECT_THROW(nearest_place(shape, {}), Error);
}

}  // namespace
}  // namespace offing::highlights
