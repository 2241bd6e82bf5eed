// Wakes as layers of the composed sea: what is drawn, what queries answer, and what the window holds.
#include <cmath>

#include <gtest/gtest.h>

#include "host/ocean/wakes/wake_maps.h"
#include "tests/ocean/query/queried_sea.h"

namespace offing::ocean {
namespace {

// Two windows of different size and method, that overlap, around a place; both with a hull that has moved for
// 2 s.
class TwoWakes {
 public:
  TwoWakes(const ocl::Device& device, const WaterPoint& place) {
    windows_.emplace_back(device, WakeParameters{.cells = 64, .length_m = 64.0});
    windows_.emplace_back(device,
                          WakeParameters{.method = WakeMethod::verlet, .cells = 32, .length_m = 48.0});
    const auto forcing_at = [&](double time_s) {
      return WakeForcing{
          .centre = {place.x_m + time_s, place.z_m},
          .hulls = {{.x_m = place.x_m + 4.0 * time_s, .z_m = place.z_m, .length_m = 9.0, .beam_m = 4.0}}};
    };
    for (WakeWindow& window : windows_) {
      window.reset(0.0, place);
      window.advance_to(2.0, forcing_at);
    }
    auto maps = std::make_shared<WakeMaps>(device);
    maps->at(windows_, 2.003);
    maps_ = std::move(maps);
  }

  std::shared_ptr<const WakeMaps> maps() const { return maps_; }
  WakeWindow& window(std::size_t i) { return windows_[i]; }

 private:
  std::vector<WakeWindow> windows_;
  std::shared_ptr<const WakeMaps> maps_;
};

// Fails if a composed sea has other wakes than the windows, or has them in another place: on the samples of
// the first window, in its half that the second does not reach, heights differ by those of the window, within
// the rounding of heights of some metres.
TEST(WakeCompositionTest, ComposedSeasHaveTheHeightsOfWindows) {
  const ocl::Device device = ocl::Device::open();
  HybridSea sea = hybrid_sea(device, 64);
  sea.ocean.at(2.003);
  for (const WaterPoint& place : {WaterPoint{}, {4e5, -3e6}}) {
    TwoWakes wakes(device, place);
    const WakeFields fields = wakes.window(0).read(2.003);
    const SampleGrid grid{.origin_x_m = fields.origin_x_m,
                          .origin_z_m = fields.origin_z_m,
                          .spacing_x_m = fields.cell_m,
                          .spacing_z_m = fields.cell_m,
                          .columns = 64,
                          .rows = 64};
    sea.ocean.set_wakes(nullptr);
    const ComposedFields calm = sea.ocean.read_composed(grid);
    sea.ocean.set_wakes(wakes.maps());
    const ComposedFields composed = sea.ocean.read_composed(grid);
    const std::vector<WakeMaps::Instant> instants = wakes.maps()->read();
    double most_m = 0.0;
    for (std::size_t i = 0; i < fields.height_m.size(); ++i) {
      const double x_m = grid.origin_x_m + static_cast<double>(i % 64) * grid.spacing_x_m;
      const double z_m = grid.origin_z_m + static_cast<double>(i / 64) * grid.spacing_z_m;
      const double expected_m = fields.height_m[i] + instants[1].at(x_m, z_m)[0];
      ASSERT_NEAR(composed.displacement_y[i] - calm.displacement_y[i], expected_m, 1e-5) << i;
      most_m = std::max(most_m, std::abs(expected_m));
    }
    EXPECT_GT(most_m, 0.1);
  }
}

// Fails if the foam of a sea is not that of its waves and of a window together, on the window's samples.
TEST(WakeCompositionTest, ComposedSeasHaveTheFoamOfWindows) {
  const ocl::Device device = ocl::Device::open();
  HybridSea sea = hybrid_sea(device, 64);
  sea.ocean.at(2.0);
  std::vector<WakeWindow> windows;
  windows.emplace_back(device, WakeParameters{.cells = 64, .length_m = 64.0});
  windows[0].reset(0.0, {});
  windows[0].advance_to(2.0, [](double time_s) {
    return WakeForcing{
        .hulls = {{.x_m = 8.0 * time_s - 8.0, .length_m = 9.0, .beam_m = 4.0, .draught_m = 1.0}}};
  });
  const auto maps = std::make_shared<WakeMaps>(device);
  maps->at(windows, 2.0);
  const WakeFields fields = windows[0].read(2.0);
  const SampleGrid grid{.origin_x_m = fields.origin_x_m,
                        .origin_z_m = fields.origin_z_m,
                        .spacing_x_m = fields.cell_m,
                        .spacing_z_m = fields.cell_m,
                        .columns = 64,
                        .rows = 64};
  const std::vector<float> calm = sea.ocean.read_composed_foam(grid);
  sea.ocean.set_wakes(maps);
  const std::vector<float> foam = sea.ocean.read_composed_foam(grid);
  float most = 0.0f;
  for (std::size_t i = 0; i < foam.size(); ++i) {
    ASSERT_NEAR(foam[i], 1.0 - (1.0 - calm[i]) * (1.0 - fields.foam[i]), 1e-4) << i;
    most = std::max(most, fields.foam[i]);
  }
  EXPECT_GT(most, 0.5f);
}

// Fails if queries answer another sea than the one that is composed, or that a host has of it: at points of
// which a third lie in the windows. Tolerances are those of surface_query_test.cpp: 1e-4 m is the query's
// own.
TEST(WakeCompositionTest, QueriesSeeTheWakes) {
  const ocl::Device device = ocl::Device::open();
  HybridSea sea = hybrid_sea(device, 64);
  sea.ocean.at(2.003);
  for (const WaterPoint& place : {WaterPoint{}, {4e5, -3e6}}) {
    TwoWakes wakes(device, place);
    sea.ocean.set_wakes(wakes.maps());
    std::vector<WaterPoint> points = scattered_points(500, 100.0);
    for (WaterPoint& point : points) point = {point.x_m + place.x_m, point.z_m + place.z_m};
    const WaterQuery query{.depth_m = 0.7, .tolerance_m = 1e-5, .accuracy = WaterQuery::Accuracy::frame_maps};
    const std::vector<WaterSample> samples = sea.ocean.sample(points, query);
    const SurfaceInstant instant = sea.ocean.instant(query);
    sea.ocean.set_wakes(nullptr);
    const std::vector<WaterSample> calm = sea.ocean.sample(points, query);
    int changed = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const WaterSample expected = instant.at(points[i]);
      ASSERT_NEAR(samples[i].height_m, expected.height_m, 5e-4) << i;
      ASSERT_NEAR(samples[i].slope_x, expected.slope_x, 5e-3) << i;
      ASSERT_NEAR(samples[i].velocity_y_mps, expected.velocity_y_mps, 5e-3) << i;
      ASSERT_NEAR(samples[i].pressure_pa, expected.pressure_pa, 10.0) << i;
      changed += std::abs(samples[i].height_m - calm[i].height_m) > 1e-3 ? 1 : 0;
    }
    EXPECT_GT(changed, 100);
  }
}

// Fails if a map has a step at its window's edge: heights and slopes of its outermost samples are 0.
TEST(WakeCompositionTest, MapsEndInNothing) {
  const ocl::Device device = ocl::Device::open();
  WakeWindow window(device, {.cells = 32, .length_m = 16.0});
  window.reset(0.0, {});
  window.advance_to(1.0, [](double) { return WakeForcing{.hulls = {{.length_m = 6.0, .beam_m = 6.0}}}; });
  const WakeFields fields = window.read(1.0);
  double inside_m = 0.0;
  for (int i = 0; i < 32; ++i) {
    for (const int at : {i, 31 * 32 + i, 32 * i, 32 * i + 31}) {
      ASSERT_EQ(fields.height_m[static_cast<std::size_t>(at)], 0.0f);
      ASSERT_EQ(fields.slope_x[static_cast<std::size_t>(at)], 0.0f);
      ASSERT_EQ(fields.foam[static_cast<std::size_t>(at)], 0.0f);
    }
    inside_m = std::max(
        inside_m, std::abs(static_cast<double>(fields.height_m[static_cast<std::size_t>(16 * 32 + i)])));
  }
  EXPECT_GT(inside_m, 0.01);
}

}  // namespace
}  // namespace offing::ocean
