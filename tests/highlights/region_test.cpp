#include "host/highlights/projectors/region.h"

#include <algorithm>
#include <set>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/highlights/example_surfaces.h"

namespace offing::highlights {
namespace {

class RegionTest : public testing::Test {
 protected:
  HighlightSurface surface(const test::ExampleSurface& example, const SurfaceOptions& options = {}) const {
    return {device_, example.mesh, example.curvatures, options};
  }
  static std::vector<std::uint32_t> region(const HighlightSurface& shape, const Projector& projector,
                                           std::uint32_t seed) {
    RegionSearch search(shape);
    std::vector<std::uint32_t> faces;
    search.find(projector, seed, faces);
    return faces;
  }

  ocl::Device device_ = ocl::Device::open();
};

// Two parallel squares of 8 x 8 cells, 1 m apart, whose vertices lie `gap_m` apart along x in the lower one's
// middle.
test::ExampleSurface sheet(int cells, double gap_m) {
  test::ExampleSurface result;
  const auto add = [&](double x0) {
    const auto first = static_cast<std::uint32_t>(result.mesh.positions_m.size());
    const auto row = static_cast<std::uint32_t>(cells + 1);
    for (int y = 0; y <= cells; ++y) {
      for (int x = 0; x <= cells; ++x) result.mesh.positions_m.emplace_back(x0 + x, y, 0.0);
    }
    for (std::uint32_t y = 0; y + 1 < row; ++y) {
      for (std::uint32_t x = 0; x + 1 < row; ++x) {
        const std::uint32_t a = first + y * row + x;
        result.mesh.faces.push_back({a, a + 1, a + row + 1});
        result.mesh.faces.push_back({a, a + row + 1, a + row});
      }
    }
  };
  add(0.0);
  add(cells + gap_m);
  const std::size_t count = result.mesh.positions_m.size();
  result.curvatures = {.k_max_per_m = std::vector<double>(count, 0.0),
                       .k_min_per_m = std::vector<double>(count, 0.0),
                       .e_max = std::vector<glm::dvec3>(count, {1.0, 0.0, 0.0}),
                       .e_min = std::vector<glm::dvec3>(count, {0.0, 1.0, 0.0}),
                       .area_m2 = std::vector<double>(count, 1.0),
                       .confidence = std::vector<double>(count, 1.0)};
  return result;
}

// A box of 2 x 1 cells inside a sheet, whose sides lie a quarter into cells: it reaches 3 x 2 cells, of which
// corner triangles on the far side of their diagonal drop out. Fails if faces are judged by their boxes, or
// whole cells.
TEST_F(RegionTest, FacesAreThoseThatReachIntoTheBox) {
  const HighlightSurface shape = surface(sheet(8, 1.0));
  const Projector projector{.centre_m = {3.25, 3.75, 0.0}, .width_m = 2.0, .height_m = 1.0};
  const std::vector<std::uint32_t> faces = region(shape, projector, 2 * (3 * 8 + 3));
  std::set<std::uint32_t> expected;
  for (std::uint32_t f = 0; f < shape.mesh().faces.size() / 2; ++f) {
    // A triangle here is x - x0 >= y - y0 or <= of its cell: it meets the box if a corner of their overlap is
    // inside.
    const std::uint32_t cell = f / 2;
    const double x0 = cell % 8, y0 = cell / 8;
    const double left = std::max(x0, 2.25), right = std::min(x0 + 1.0, 4.25);
    const double low = std::max(y0, 3.25), high = std::min(y0 + 1.0, 4.25);
    if (left > right || low > high) continue;
    const bool is_lower = f % 2 == 0;
    if (is_lower ? right - x0 >= low - y0 : left - x0 <= high - y0) expected.insert(f);
  }
  EXPECT_THAT(faces, testing::UnorderedElementsAreArray(expected));
  EXPECT_EQ(faces.front(), 2u * (3 * 8 + 3));
}

// Fails if the search leaks to what only lies in the box, or stops at a border where another component
// touches.
TEST_F(RegionTest, ComponentsAreJoinedWhereTheyTouch) {
  const Projector projector{.centre_m = {8.0, 4.0, 0.0}, .width_m = 3.0, .height_m = 3.0};
  const std::uint32_t seed = 2 * (4 * 8 + 7), half = 2 * 8 * 8;
  for (const auto& [gap_m, is_joined] : {std::pair{0.0, true}, {1e-7, true}, {0.01, false}}) {
    const HighlightSurface shape = surface(sheet(8, gap_m));
    const std::vector<std::uint32_t> faces = region(shape, projector, seed);
    EXPECT_EQ(std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) { return f >= half; }), is_joined)
        << gap_m;
  }
}

// Fails if the far side of a sphere gets the texture too: a box wider than the sphere reaches all of its
// faces.
TEST_F(RegionTest, FacesLookTheProjectorsWay) {
  const HighlightSurface shape = surface(test::ellipsoid(3, glm::dvec3(1.0)));
  const Projector projector{.centre_m = {0.0, 0.0, 1.0}, .width_m = 4.0, .height_m = 4.0};
  std::uint32_t seed = 0;
  for (std::uint32_t f = 0; f < shape.face_normals().size(); ++f) {
    if (shape.face_normals()[f].z > shape.face_normals()[seed].z) seed = f;
  }
  const std::vector<std::uint32_t> faces = region(shape, projector, seed);
  for (const std::uint32_t f : faces) EXPECT_GT(shape.face_normals()[f].z, 0.0);
  EXPECT_EQ(faces.size(), shape.mesh().faces.size() / 2);
}

// Some faces of a sheet are there twice, with the same vertices in another order or with copies of them, and
// once turned over. Fails if a highlight is drawn twice where they lie, or not at all.
TEST_F(RegionTest, FacesThatLieOnOthersAreLeftOut) {
  test::ExampleSurface example = sheet(8, 1.0);
  const Projector projector{.centre_m = {3.25, 3.75, 0.0}, .width_m = 2.0, .height_m = 1.0};
  const std::vector<std::uint32_t> once = region(surface(example), projector, 54);
  TriangleMesh& mesh = example.mesh;
  const auto count = static_cast<std::uint32_t>(mesh.faces.size());
  for (std::uint32_t face = 40; face < 80; ++face) {
    const TriangleIndices corners = mesh.faces[face];
    mesh.faces.push_back({corners[0], corners[2], corners[1]});
    mesh.faces.push_back({corners[1], corners[2], corners[0]});
  }
  const std::vector<std::uint32_t> found = region(surface(example), projector, 54);
  EXPECT_EQ(found.size(), once.size());
  // From a copy as well, which takes the place of the first.
  std::vector<std::uint32_t> from_copy = region(surface(example), projector, count + 2 * (54 - 40) + 1);
  EXPECT_EQ(from_copy.size(), once.size());
  for (std::uint32_t& face : from_copy) face = face < count ? face : 40 + (face - count) / 2;
  EXPECT_THAT(from_copy, testing::UnorderedElementsAreArray(once));
}

// A second search must not remember the first.
TEST_F(RegionTest, SearchesDoNotDisturbEachOther) {
  const HighlightSurface shape = surface(sheet(8, 1.0));
  RegionSearch search(shape);
  std::vector<std::uint32_t> both;
  const Projector projector{.centre_m = {3.25, 3.75, 0.0}, .width_m = 2.0, .height_m = 1.0};
  search.find(projector, 54, both);
  const std::size_t first = both.size();
  search.find(projector, 54, both);
  ASSERT_EQ(both.size(), 2 * first);
  EXPECT_TRUE(std::equal(both.begin(), both.begin() + static_cast<std::ptrdiff_t>(first),
                         both.begin() + static_cast<std::ptrdiff_t>(first)));
}

}  // namespace
}  // namespace offing::highlights
