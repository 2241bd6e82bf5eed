// Queries against the water that OpenGL draws: at each pixel the place that its ray meets, and the water
// there.
#include "tests/present/passes/drawn_water.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/surface/projected_grid.h"
#include "present/passes/water/water_surface.h"
#include "tests/ocean/query/queried_sea.h"

namespace offing::present {
namespace {

using test::drawn_beside_queried;
using test::DrawnWater;

constexpr double time_s = 42.0;
constexpr int side_px = 32;  // 1024 pixels, all compared

/// The sea of the queries' tests, without waves that are shorter than this.
world::WorldParameters sea_of_waves_from(double shortest_m) {
  const ocean::HybridSea hybrid = ocean::hybrid_sea(ocl::Device::open(), 512);
  world::WorldParameters parameters{.spectrum = hybrid.spectrum, .ocean = hybrid.ocean.parameters()};
  if (shortest_m == 0.0) return parameters;
  const double k_max_radpm = 2.0 * std::numbers::pi / shortest_m;
  std::vector<ocean::Cascade>& cascades = parameters.ocean.cascades;
  std::erase_if(cascades, [&](const ocean::Cascade& cascade) { return cascade.k_min_radpm >= k_max_radpm; });
  cascades.back().k_max_radpm = std::min(cascades.back().k_max_radpm, k_max_radpm);
  return parameters;
}

/// A beach of 1 : 10 whose waterline runs 30 m beside the eye: 3 m of water below it.
world::TerrainParameters beach_about(const glm::dvec3& eye_m) {
  HeightMap map;
  map.columns = map.rows = 64;
  map.spacing_x_m = map.spacing_z_m = 10.0;
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      map.heights_m.push_back(static_cast<float>(-3.0 + 0.1 * (315.0 - 10.0 * column)));
    }
  }
  world::TerrainParameters terrain;
  terrain.map = std::make_shared<const HeightMap>(std::move(map));
  terrain.origin_x_m = eye_m.x - 315.0;
  terrain.origin_z_m = eye_m.z - 315.0;
  return terrain;
}

class DrawnWaterTest : public testing::Test {
 protected:
  struct Stage {
    Stage(const world::WorldParameters& parameters, GridCells grid_cells)
        : world(device, parameters), cells(grid_cells) {}

    GlContext context = GlContext::headless();
    ocl::Device device = ocl::Device::open();
    world::World world;
    GridCells cells;
    Transfer transfer{context, device, std::nullopt};
    WaterMaps maps;
    WaterSurface surface{context.capabilities(), cells};
  };

  /// Leaves no stage, and the case skipped, where there is no OpenGL.
  void prepare(const world::WorldParameters& parameters, GridCells cells) {
    try {
      stage_ = std::make_unique<Stage>(parameters, cells);
    } catch (const Error& error) {
      GTEST_SKIP() << "no OpenGL here: " << error.what();
    }
    stage_->world.at(time_s, camera_.eye_m.y);
    stage_->maps.prepare(stage_->world, stage_->transfer);
  }

  /// The longest side of a cell at rest; rows lie as water_shape.frag has them.
  double longest_cell_m() const {
    const auto grid = ocean::ProjectedGrid::for_camera(camera_, stage_->world.reach());
    const auto label_m = [&](int column, int row) {
      const double rest = 1.0 - static_cast<double>(row) / stage_->cells.rows;
      return grid->label_m({static_cast<double>(column) / stage_->cells.columns, 1.0 - rest * rest});
    };
    double longest_m = 0.0;
    for (int row = 0; row < stage_->cells.rows; ++row) {
      for (int column = 0; column < stage_->cells.columns; ++column) {
        const glm::dvec2 corner_m = label_m(column, row);
        longest_m = std::max({longest_m, glm::distance(corner_m, label_m(column + 1, row)),
                              glm::distance(corner_m, label_m(column, row + 1))});
      }
    }
    return longest_m;
  }

  /// Of the water of all pixels.
  DrawnWater compare() {
    EXPECT_TRUE(stage_->surface.draw(stage_->world, stage_->maps, camera_, Fill::solid));
    const DrawnWater drawn = drawn_beside_queried(stage_->world, stage_->surface, camera_);
    EXPECT_EQ(drawn.count, static_cast<std::size_t>(side_px) * side_px) << "a hole";
    return drawn;
  }

  std::unique_ptr<Stage> stage_;
  Camera camera_{.eye_m = {60e3 + 300.0, 20.0, -80e3 - 70.0}, .width_px = side_px, .height_px = side_px};
};

// Fails if a boat would float beside the drawn water: from 20 m straight above, cells of at most 5 cm, all
// waves. What is left is the flatness of cells, an eighth of curvature times their square (0.3 mm at 1 /m),
// and OpenGL's 8 bits of place between texels: of the first cascade's, 0.7 m apart at slopes of 0.3, 1 mm.
// Measured 0.1 mm, promised 1 cm.
TEST_F(DrawnWaterTest, OfSmallCellsIsWhereQueriesSay) {
  camera_.pitch_rad = -0.5 * std::numbers::pi;
  camera_.vertical_field_of_view_rad = 0.2;
  prepare(sea_of_waves_from(0.0), {.columns = 512, .rows = 1024});
  if (!stage_) return;
  ASSERT_LE(longest_cell_m(), 0.05);
  const DrawnWater found = compare();
  RecordProperty("rms_mm", std::to_string(1e3 * found.off_m()));
  EXPECT_LT(found.off_m(), 0.01);
  EXPECT_GT(found.height_m(), 0.1) << "there is nothing to compare";
}

// The same on the grid that is drawn by default, whose cells are no longer than 2 m here: of a sea of the
// waves that it resolves, those of four cells and more. Measured 0.14 % of Hs, promised 3 %.
TEST_F(DrawnWaterTest, OfTheDefaultGridIsWhereQueriesSay) {
  constexpr double largest_cell_m = 2.0;
  camera_.pitch_rad = -0.5;
  camera_.vertical_field_of_view_rad = 0.6;
  prepare(sea_of_waves_from(4.0 * largest_cell_m), {});
  if (!stage_) return;
  ASSERT_LE(longest_cell_m(), largest_cell_m);
  const DrawnWater found = compare();
  const double hs_m = ocean::integrate_sea_state(stage_->world.parameters().spectrum).hs_m;
  RecordProperty("rms_percent_of_hs", std::to_string(100.0 * found.off_m() / hs_m));
  EXPECT_LT(found.off_m(), 0.03 * hs_m);
  EXPECT_GT(found.height_m(), 0.1 * hs_m) << "there is nothing to compare";
}

// The same over a beach: fails if the drawn water and the queried shoal otherwise, by depths, shares or
// bands. Heights change by the share's change within a cell besides, which is linear. Measured 0.1 mm.
TEST_F(DrawnWaterTest, OverABeachIsWhereQueriesSay) {
  camera_.pitch_rad = -0.5 * std::numbers::pi;
  camera_.vertical_field_of_view_rad = 0.2;
  world::WorldParameters parameters = sea_of_waves_from(0.0);
  parameters.terrain = beach_about(camera_.eye_m);
  prepare(parameters, {.columns = 512, .rows = 1024});
  if (!stage_) return;
  ASSERT_NE(stage_->world.shoals(), nullptr);
  const DrawnWater found = compare();
  RecordProperty("rms_um", static_cast<int>(1e6 * found.off_m()));
  EXPECT_LT(found.off_m(), 0.01);
  EXPECT_GT(found.height_m(), 0.1) << "there is nothing to compare";
}

// And from farther away, the waterline in sight. Fails too if waves are drawn over land: but for the cells
// that the waterline crosses, whose vertices in the water stand in 0.28 m at most, 0.25 m high at six
// deviations, the water there is that of the swash (Swash::level_m()). Gate 0.1 m. The swash is taken at
// places and not at their labels.
TEST_F(DrawnWaterTest, OfABeachFromAfarIsWhereQueriesSay) {
  constexpr double largest_cell_m = 2.0;
  camera_.pitch_rad = -0.5;
  camera_.yaw_rad = -0.7;
  camera_.vertical_field_of_view_rad = 0.6;
  world::WorldParameters parameters = sea_of_waves_from(4.0 * largest_cell_m);
  parameters.terrain = beach_about(camera_.eye_m);
  prepare(parameters, {});
  if (!stage_) return;
  const DrawnWater found = compare();
  const double hs_m = ocean::integrate_sea_state(stage_->world.parameters().spectrum).hs_m;
  RecordProperty("rms_percent_of_hs", std::to_string(100.0 * found.off_m() / hs_m));
  EXPECT_LT(found.off_m(), 0.03 * hs_m);
  EXPECT_GT(found.height_m(), 0.05) << "there is nothing to compare";
  RecordProperty("over_land_mm", static_cast<int>(1e3 * found.over_land_m));
  EXPECT_LT(found.over_land_m, 0.1);
  EXPECT_GT(found.land_count, 20u) << "no land is in sight";
}

}  // namespace
}  // namespace offing::present
