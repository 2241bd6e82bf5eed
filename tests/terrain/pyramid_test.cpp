#include "host/terrain/field/pyramid.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/terrain/example_maps.h"

namespace offing {
namespace {

using terrain::Pyramid;
using terrain::PyramidLayout;

float highest_post(const test::HeightMap& map, int level, int x, int z) {
  float highest_m = -std::numeric_limits<float>::max();
  for (int row = z << level; row <= std::min((z + 1) << level, map.grid.rows - 1); ++row) {
    for (int column = x << level; column <= std::min((x + 1) << level, map.grid.columns - 1); ++column) {
      highest_m = std::max(highest_m, map.at(column, row));
    }
  }
  return highest_m;
}

// Every node of every level against all of its posts, borders included. Fails if a maximum is lower, which
// makes holes, or higher, which costs steps; by a single bit.
TEST(PyramidTest, MaximaAreTheHighestPostsOfTheirPatches) {
  const ocl::Device device = ocl::Device::open();
  for (const test::HeightMap& map : test::example_maps()) {
    const ocl::Buffer<float> heights_m(device, map.heights_m, "heights");
    const Pyramid pyramid(device, map.grid, heights_m);
    const PyramidLayout& layout = pyramid.layout();
    const std::vector<float> maxima_m = pyramid.maxima_m().read();
    for (int level = 1; level <= layout.top_level; ++level) {
      for (int z = 0; z < layout.nodes_z(level); ++z) {
        for (int x = 0; x < layout.nodes_x(level); ++x) {
          const bool is_on_map = x << level < map.grid.columns - 1 && z << level < map.grid.rows - 1;
          const float expected_m =
              is_on_map ? highest_post(map, level, x, z) : -std::numeric_limits<float>::max();
          ASSERT_EQ(maxima_m[layout.begin(level) + static_cast<std::size_t>(z * layout.nodes_x(level) + x)],
                    expected_m)
              << map.name << ", level " << level << ", node (" << x << ", " << z << ")";
        }
      }
    }
  }
}

// The bound that users plan memory by; and nodes few enough at the top for a walk that starts there.
TEST(PyramidTest, TakesAtMostFourTenthsOfTheHeightMap) {
  for (const int posts : {65, 257, 300, 1000, 1025, 1201, 2050, 3601, 4097, 10801, 32768}) {
    const PyramidLayout layout = PyramidLayout::of({.columns = posts, .rows = posts});
    EXPECT_LE(static_cast<double>(layout.node_count()), 0.4 * posts * posts) << posts;
    EXPECT_LE(layout.nodes_x(layout.top_level), 32) << posts;
    EXPECT_GE(layout.padded_x, posts - 1) << posts;
  }
}

}  // namespace
}  // namespace offing
