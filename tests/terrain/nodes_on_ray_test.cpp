#include "host/terrain/cast/nodes_on_ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/terrain/generate/fractal_terrain.h"

namespace offing::terrain {
namespace {

constexpr int posts = 100;  // not a power of two, and padded

struct Terrain {
  std::vector<float> heights_m;
  PostGrid grid{
      .columns = posts, .rows = posts, .spacing_x_m = 20.0, .spacing_z_m = 20.0, .origin_x_m = 50.0};
};

Terrain made_terrain() {
  Terrain terrain;
  RowMakers makers({.posts = posts, .side_m = 20.0 * (posts - 1), .relief_m = 300.0, .longest_m = 800.0});
  for (int first = 0; first < posts; first += makers.rows_at_once()) {
    const auto rows = makers.make(first);
    terrain.heights_m.insert(terrain.heights_m.end(), rows.begin(), rows.end());
  }
  return terrain;
}

// Fails if a node is missing or out of order, a maximum is not that of its posts, one is passed over that the
// ray dips into, or the last cell is not the one that the ray hits.
TEST(NodesOnRayTest, LeadToTheHit) {
  const Terrain terrain = made_terrain();
  HeightField field(ocl::Device::open(), terrain.grid, terrain.heights_m);
  for (const auto& toward :
       std::array<glm::dvec3, 4>{{{1.0, -0.25, 0.3}, {0.4, -0.5, 0.9}, {0.0, -1.0, 0.0}, {1.0, -0.1, 0.0}}}) {
    const Ray ray{.origin_m = {300.0, field.highest_m() + 40.0, 420.0}, .direction = glm::normalize(toward)};
    const terrain::RayHit hit = field.cast(std::span(&ray, 1)).front();
    ASSERT_EQ(hit.kind, TERRAIN_SURFACE);
    const std::vector<RayNode> nodes = nodes_on_ray(field, ray, hit.distance_m);
    ASSERT_FALSE(nodes.empty());
    EXPECT_EQ(nodes.front().level, field.pyramid().layout().top_level);
    for (const RayNode& node : nodes) {
      float highest_m = -1e9f;
      for (int z = node.first_z; z <= std::min(node.first_z + node.side_cells, posts - 1); ++z)
        for (int x = node.first_x; x <= std::min(node.first_x + node.side_cells, posts - 1); ++x)
          highest_m = std::max(highest_m, terrain.heights_m[static_cast<std::size_t>(z * posts + x)]);
      EXPECT_EQ(node.maximum_m, highest_m) << node.level;
    }
    // Of the cells none is met twice, and the last one is that of the hit, or its neighbour where it is hit
    // at their border.
    const auto last =
        std::find_if(nodes.rbegin(), nodes.rend(), [](const RayNode& n) { return n.level == 0; });
    ASSERT_NE(last, nodes.rend());
    EXPECT_FALSE(last->is_passed_over);
    EXPECT_LE(std::abs(last->first_x - hit.cell_x) + std::abs(last->first_z - hit.cell_z), 1);
    // A node that is gone into is followed by one of the level below, within it.
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      if (nodes[i].is_passed_over || nodes[i].level == 0) continue;
      EXPECT_EQ(nodes[i + 1].level, nodes[i].level - 1);
      EXPECT_GE(nodes[i + 1].first_x, nodes[i].first_x);
      EXPECT_LT(nodes[i + 1].first_x, nodes[i].first_x + nodes[i].side_cells);
    }
  }
}

// Fails if a ray high above the ground looks into a node.
TEST(NodesOnRayTest, PassOverWhatIsFarBelow) {
  const Terrain terrain = made_terrain();
  HeightField field(ocl::Device::open(), terrain.grid, terrain.heights_m);
  const Ray ray{.origin_m = {60.0, field.highest_m() + 1.0, 500.0}, .direction = {1.0, 0.0, 0.0}};
  const std::vector<RayNode> nodes = nodes_on_ray(field, ray, 5000.0);
  ASSERT_FALSE(nodes.empty());
  for (const RayNode& node : nodes) EXPECT_TRUE(node.is_passed_over);
}

}  // namespace
}  // namespace offing::terrain
