#include "host/highlights/projectors/projector.h"

#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/highlights/curvature/diffused_curvature.h"
#include "host/highlights/search/surface_place.h"
#include "host/mesh_shapes/shape.h"
#include "tests/highlights/example_surfaces.h"

namespace offing::highlights {
namespace {

/// Of no account where a cap is given.
HighlightSurface far_plane() {
  return {ocl::Device::open(),
          {.positions_m = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}},
           .normals = {},
           .faces = {{0, 1, 2}}},
          {.k_max_per_m = {0.0, 0.0, 0.0},
           .k_min_per_m = {0.0, 0.0, 0.0},
           .e_max = {3, {1.0, 0.0, 0.0}},
           .e_min = {3, {0.0, 1.0, 0.0}},
           .area_m2 = {0.0, 0.0, 0.0},
           .confidence = {0.0, 0.0, 0.0}}};
}

HighlightPoint tilted_point() {
  test::RandomVectors random(7);
  const glm::dmat3 axes = random.rotation();
  HighlightPoint point;
  point.position_m = {3.0, -2.0, 5.0};
  point.e_max = axes[0];
  point.normal = axes[2];
  point.k_max_per_m = 4.0;
  point.k_min_per_m = -0.5;
  return point;
}

// Fails if a texture were mirrored (H4: right x up = normal), turned, or not where the point is (H7).
TEST(ProjectorTest, AxesAreRightHandedAndTheBoxIsMinusOneToOne) {
  const HighlightPoint point = tilted_point();
  const Projector projector = projector_at(far_plane(), point, {.threshold = 0.8, .cap_radius_m = 10.0});
  EXPECT_LE(glm::distance(glm::cross(projector.right, projector.up), projector.normal), 1e-15);
  EXPECT_EQ(projector.normal, point.normal);
  const glm::dmat4 matrix = projection_of(projector);
  const auto q = [&](const glm::dvec3& p) { return glm::dvec3(matrix * glm::dvec4(p, 1.0)); };
  EXPECT_LE(glm::length(q(point.position_m)), 1e-14);
  const glm::dvec3 corner =
      point.position_m + 0.5 * projector.width_m * projector.right - 0.5 * projector.height_m * projector.up;
  EXPECT_LE(glm::distance(q(corner), glm::dvec3(1.0, -1.0, 0.0)), 1e-13);
  EXPECT_GT(q(point.position_m + projector.normal).z, 0.0);
  EXPECT_EQ(texture_place({-1.0, 1.0, 0.0}), glm::dvec2(0.0, 0.0));
  EXPECT_EQ(texture_place({1.0, -1.0, 0.0}), glm::dvec2(1.0, 1.0));
}

// H5 by hand: threshold 0.8 leaves sqrt(1 - 0.64) = 0.6. Fails if half and full widths are mixed up, if
// hollows are not as wide as humps, or if flat places are not capped.
TEST(ProjectorTest, WidthsAreThoseOfTheCurvatureUpToTheCap) {
  const Projector projector =
      projector_at(far_plane(), tilted_point(), {.threshold = 0.8, .cap_radius_m = 10.0});
  EXPECT_NEAR(projector.width_m, 2.0 / 4.0 * 0.6, 1e-15);
  EXPECT_NEAR(projector.height_m, 2.0 / 0.5 * 0.6, 1e-15);
  EXPECT_NEAR(width_m(0.0, {.threshold = 0.8, .cap_radius_m = 0.7}), 1.4, 1e-15);
  EXPECT_NEAR(width_m(1e-9, {.threshold = 0.8, .cap_radius_m = 0.7}), 1.4, 1e-15);
}

// Euler: k_max along e_max, k_min across, their mean at 45 degrees.
TEST(ProjectorTest, CurvatureTurnsAsEulerSays) {
  const HighlightPoint point = tilted_point();
  const glm::dvec3 e_min = glm::cross(point.normal, point.e_max);
  EXPECT_NEAR(curvature_along(point, point.e_max), 4.0, 1e-14);
  EXPECT_NEAR(curvature_along(point, e_min), -0.5, 1e-14);
  EXPECT_NEAR(curvature_along(point, glm::normalize(point.e_max + e_min)), 1.75, 1e-14);
}

TEST(ProjectorTest, SizesOutOfRangeAreErrors) {
  for (const HighlightSize& size : {HighlightSize{.threshold = 1.0, .cap_radius_m = 1.0},
                                    HighlightSize{.threshold = -0.1, .cap_radius_m = 1.0},
                                    HighlightSize{.threshold = 0.5, .cap_radius_m = -1.0},
                                    HighlightSize{.threshold = 0.5, .cap_radius_m = std::nan("")}}) {
    EXPECT_THROW(projector_at(far_plane(), tilted_point(), size), Error);
  }
}

/// A mesh as a file brings it: its curvatures are made on the device.
HighlightSurface measured(TriangleMesh mesh) {
  const ocl::Device device = ocl::Device::open();
  VertexCurvatures curvatures = diffused_curvatures(device, mesh);
  return {device, std::move(mesh), std::move(curvatures)};
}

/// The highlights of a light and an eye far away.
std::vector<HighlightPoint> points_of(const HighlightSurface& surface, const glm::dvec3& half_vector) {
  HighlightFinder search(surface.device());
  return search.find(surface,
                     {{Source::Kind::direction, half_vector}, {{Source::Kind::direction, half_vector}}});
}

// Theory: 2 sqrt(1 - 0.95^2) = 0.6245 m on a unit sphere. Fails if the size depends on the triangles: three
// mean edges make 0.62, 0.45, 0.23, 0.11 and 0.06 m of it.
TEST(ProjectorTest, DefaultSizesDoNotDependOnTriangles) {
  for (int level = 1; level <= 5; ++level) {
    // Scenes know the curvatures of spheres; those of the device are too coarse below 1,280 faces.
    const mesh_shapes::Shape shape = mesh_shapes::make_sphere(1.0, level);
    const HighlightSurface sphere =
        level < 3 ? HighlightSurface(ocl::Device::open(), shape.mesh, *shape.truth) : measured(shape.mesh);
    const std::vector<HighlightPoint> points = points_of(sphere, {0.3, 0.5, 0.8});
    ASSERT_EQ(points.size(), 1u);
    const Projector projector = projector_at(sphere, points[0], {});
    EXPECT_NEAR(projector.width_m, 0.6245, 0.02 * 0.6245) << level;
    EXPECT_NEAR(projector.height_m, 0.6245, 0.02 * 0.6245) << level;
    // The paper's rule is an option.
    const HighlightSize printed = with_cap({.flat_limit = FlatLimit::mean_edges}, sphere);
    EXPECT_EQ(printed.cap_radius_m, 3.0 * sphere.mean_edge_m());
  }
}

// Widths of the exact curvatures, on meshes of two finenesses. Fails if the limit of flat places narrows what
// bends evenly, or if curvatures are wrong.
TEST(ProjectorTest, DefaultSizesFollowTheCurvature) {
  const auto expect_widths = [](const HighlightSurface& surface, const test::ExampleSurface& exact) {
    const HighlightSurface truth(surface.device(), exact.mesh, exact.curvatures);
    for (const glm::dvec3& half_vector : {glm::dvec3(0.3, 0.5, 0.8), glm::dvec3(0.9, 0.2, -0.4)}) {
      const std::vector<HighlightPoint> expected = points_of(truth, half_vector);
      const std::vector<HighlightPoint> points = points_of(surface, half_vector);
      ASSERT_EQ(points.size(), expected.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Projector projector = projector_at(surface, points[i], {});
        const double width = width_m(expected[i].k_max_per_m, {}),
                     height = width_m(expected[i].k_min_per_m, {});
        EXPECT_NEAR(projector.width_m, width, 0.03 * width);
        EXPECT_NEAR(projector.height_m, height, 0.03 * height);
      }
    }
  };
  for (const int finer : {0, 1}) {
    const test::ExampleSurface ellipsoid = test::ellipsoid(5 + finer, {1.0, 0.75, 0.6});
    expect_widths(measured(ellipsoid.mesh), ellipsoid);
    const test::ExampleSurface torus = test::torus(120 << finer, 60 << finer, 1.0, 0.4);
    expect_widths(measured(torus.mesh), torus);
  }
}

// A cylinder is flat along its axis: the width ends where its side does. Fails if a flat place has no end, or
// if the end depends on triangles.
TEST(ProjectorTest, FlatPlacesEndWhereTheSurfaceTurnsAway) {
  for (const int cells : {12, 48}) {
    const HighlightSurface can = measured(mesh_shapes::make_cylinder(1.0, 2.0, {cells, 4 * cells}).mesh);
    HighlightPoint point;
    double nearest_m = 1e9;
    for (std::uint32_t face = 0; face < can.mesh().faces.size(); ++face) {
      const glm::dvec3 place_m = place_on(can, face, glm::dvec3(1.0 / 3.0));
      const double distance_m = glm::distance(place_m, glm::dvec3(0.0, 0.4, 1.0));
      if (distance_m >= nearest_m) continue;
      nearest_m = distance_m;
      point.face = face;
      point.position_m = place_m;
    }
    point.weights = glm::dvec3(1.0 / 3.0);
    point.normal = normal_at(can, {point.face, point.weights});
    point.k_max_per_m = 1.0;
    // Up to the edge; and down by a quarter of the diagonal. Normals turn within the last ring of cells.
    const double expected_m = 1.0 - point.position_m.y + 0.25 * can.diagonal_m();
    EXPECT_NEAR(width_along(can, point, {0.0, 1.0, 0.0}, {}), expected_m, 2.0 / cells);
    EXPECT_NEAR(width_along(can, point, point.e_max, {}), 0.6245, 1e-6);
  }
}

}  // namespace
}  // namespace offing::highlights
