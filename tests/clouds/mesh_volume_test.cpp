// Clouds in the shape of meshes (C14): inside where the surface winds around, whatever faults it has.
#include "host/clouds/shape/mesh_volume.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/clouds/shape/mesh_inside.h"
#include "host/mesh_shapes/shape.h"
#include "tests/clouds/volume_cells.h"
#include "tests/ocl/expect_error.h"

namespace offing::clouds {
namespace {

/// A cube's twelve faces, corners on whole and half metres, so that lines of cells meet vertices and edges.
TriangleMesh cube(const glm::dvec3& low_m, double side_m) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions_m.push_back(low_m + side_m * glm::dvec3(i & 1, (i >> 1) & 1, i >> 2));
  }
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.positions_m.size());
  mesh.positions_m.insert(mesh.positions_m.end(), other.positions_m.begin(), other.positions_m.end());
  for (TriangleIndices face : other.faces) {
    for (std::uint32_t& vertex : face) vertex += first;
    mesh.faces.push_back(face);
  }
}

int count_inside(const TriangleMesh& mesh, double cell_m, const glm::dvec3& corner_m = glm::dvec3(-8.0)) {
  const int side = static_cast<int>(24.0 / cell_m);
  int count = 0;
  for (const std::uint8_t inside : cells_inside(mesh, corner_m, cell_m, {side, side, side})) count += inside;
  return count;
}

// Fails if a line through an edge or a vertex crosses none of its faces or several: the corners of these
// cubes lie on lines of cells, and each has exactly as many cells as its volume.
TEST(MeshInsideTest, LinesThroughEdgesCrossOneFace) {
  EXPECT_EQ(count_inside(cube(glm::dvec3(0.0), 6.0), 1.0), 216);
  EXPECT_EQ(count_inside(cube(glm::dvec3(0.5), 6.0), 1.0), 216);
  EXPECT_EQ(count_inside(cube(glm::dvec3(0.5, 0.25, 0.0), 6.0), 0.5), 1728);
}

TEST(MeshInsideTest, FaultsLeaveNoHollowsAndNoRays) {
  TriangleMesh overlapping = cube(glm::dvec3(0.1), 6.0);
  append(overlapping, cube(glm::dvec3(3.1, 0.1, 0.1), 6.0));
  EXPECT_EQ(count_inside(overlapping, 1.0), 216 + 108);
  TriangleMesh holed = cube(glm::dvec3(0.1), 6.0);
  holed.faces.erase(holed.faces.begin());
  EXPECT_EQ(count_inside(holed, 1.0), 216);
  TriangleMesh turned = cube(glm::dvec3(0.1), 6.0);
  std::swap(turned.faces[5][0], turned.faces[5][1]);
  EXPECT_EQ(count_inside(turned, 1.0), 216);
  TriangleMesh inverted = cube(glm::dvec3(0.1), 6.0);
  for (TriangleIndices& face : inverted.faces) std::swap(face[0], face[1]);
  EXPECT_EQ(count_inside(inverted, 1.0), 216);
}

// Fails if thickness and fluff are not where they are said to be: half a cell right, of density 1.5 cells
// over both, 0.05.
TEST(MeshVolumeTest, DensityRisesFromFluffToThickness) {
  const TriangleMesh mesh = cube(glm::dvec3(0.0), 40.0);
  const CloudVolume volume = mesh_volume(mesh, {.cell_m = 0.5, .thickness_m = 10.0, .fluff_m = 5.0});
  for (double out_m = -18.0; out_m <= 8.0; out_m += 0.5) {
    const double share = std::clamp((5.0 - out_m) / 15.0, 0.0, 1.0);
    const double expected = share * share * (3.0 - 2.0 * share);
    EXPECT_NEAR(density_at(volume, {20.2, 20.2, 40.0 + out_m}), expected, 0.05) << out_m;
    EXPECT_NEAR(density_at(volume, {-out_m, 20.2, 20.2}), expected, 0.05) << out_m;
    // Out of an edge, the nearest place is on it.
    if (out_m > 0.0) {
      EXPECT_NEAR(density_at(volume, {40.0 + 0.6 * out_m, 40.0 + 0.8 * out_m, 20.2}), expected, 0.08)
          << out_m;
    }
  }
}

// Fails if the volume of a round body is wrong: all that is inside, nothing else. Cells of a 20th of the
// radius count it to 1 %.
TEST(MeshVolumeTest, HoldsTheVolumeOfTheMesh) {
  const TriangleMesh ball = mesh_shapes::make_sphere(1.0, 4).mesh;
  const CloudVolume volume = mesh_volume(ball, {.cell_m = 0.05, .thickness_m = 0.01, .fluff_m = 0.01});
  double sum = 0.0;
  for_cells(volume, [&](const glm::dvec3&, float density) { sum += density > 0.5f ? 1.0 : 0.0; });
  EXPECT_NEAR(sum * std::pow(0.05, 3), 4.0 / 3.0 * std::numbers::pi, 0.05);
}

TEST(MeshVolumeTest, RefusesWhatEnclosesNothing) {
  TriangleMesh flat;
  flat.positions_m = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  flat.faces = {{0, 1, 2}};
  offing::test::expect_error(ErrorKind::bad_input, "enclose no cell", [&] { mesh_volume(flat, {.cell_m = 0.1}); });
  offing::test::expect_error(ErrorKind::bad_input, "enclose no cell", [&] { mesh_volume({}, {}); });
  flat.faces = {{0, 1, 7}};
  offing::test::expect_error(ErrorKind::bad_input, "found 7", [&] { mesh_volume(flat, {}); });
  offing::test::expect_error(ErrorKind::bad_input, "cell_m 0.01",
                     [] { mesh_volume(cube(glm::dvec3(0.0), 500.0), {.cell_m = 0.01}); });
}

}  // namespace
}  // namespace offing::clouds
