// Queries over a sloping bed: against the open sea's waves in closed form, and the same in double precision.
#include "host/ocean/query/shoals.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "tests/ocean/query/queried_sea.h"

namespace offing::ocean {
namespace {

/// A bed that is level along z and sinks by `slope` along x, 0 m deep at x = 0, of land and 600 m of sea.
std::shared_ptr<const DepthMap> beach(double slope) {
  DepthMap map{.columns = 81,
               .rows = 41,
               .origin_x_m = -200.0,
               .origin_z_m = -400.0,
               .spacing_x_m = 10.0,
               .spacing_z_m = 20.0,
               .depths_m = {}};
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      map.depths_m.push_back(static_cast<float>(std::max(slope * (10.0 * column - 200.0), -5.0)));
    }
  }
  return std::make_shared<const DepthMap>(std::move(map));
}

/// Everywhere so deep.
std::shared_ptr<const DepthMap> flat(double depth_m) {
  DepthMap map{.columns = 2,
               .rows = 2,
               .origin_x_m = -1e4,
               .origin_z_m = -1e4,
               .spacing_x_m = 2e4,
               .spacing_z_m = 2e4,
               .depths_m = {}};
  map.depths_m.assign(4, static_cast<float>(depth_m));
  return std::make_shared<const DepthMap>(std::move(map));
}

class ShoalsTest : public testing::Test {
 protected:
  static ShoalTable table_of(const HybridSea& sea) {
    std::vector<ShoalingBand> cascades;
    const OceanParameters& parameters = sea.ocean.parameters();
    for (std::size_t i = 0; i < parameters.cascades.size(); ++i) {
      cascades.push_back(band_of_modes(sea.ocean.mode_variance(static_cast<int>(i)), parameters.size,
                                       parameters.cascades[i].patch_length_m));
    }
    return {sea.spectrum.dispersion, shoaling_bands(cascades, parameters.gerstner_waves.waves)};
  }
  void lay(HybridSea& sea, std::shared_ptr<const DepthMap> bed) const {
    sea.ocean.set_shoals(std::make_shared<const Shoals>(device_, std::move(bed), table_of(sea)));
  }

  ocl::Device device_ = ocl::Device::open();
};

// Fails if a band of Gerstner waves is scaled by another's share, or a field is not scaled: over a level bed,
// without choppiness, each Gerstner wave is what its band's share leaves; velocity and pressure like the
// height. All waves of the sea but the cascades and one band are taken out in turn. Rounding: gate 2e-6 of
// the largest.
TEST_F(ShoalsTest, ScaleEachBandByItsShare) {
  HybridSea sea = hybrid_sea(device_, 64, 0.0);
  const std::vector<WaterPoint> points = scattered_points(200, 500.0);
  const ShoalTable table = table_of(sea);
  const std::array<double, SHOAL_BANDS> shares = table.at(3.0);
  ASSERT_LT(shares[0], 0.9);
  ASSERT_NE(shares[0], shares[SHOAL_FIRST_GERSTNER]);
  const GerstnerSea all = sea.ocean.parameters().gerstner_waves;
  for (int band = 0; band < 4; ++band) {
    GerstnerSea alone = all;
    std::erase_if(alone.waves, [&](const GerstnerWave& wave) {
      return table.bands().gerstner_band(wave.wavenumber_radpm) != band;
    });
    sea.ocean.at(30.0);
    const auto sampled_with = [&](const GerstnerSea& gerstner_waves) {
      sea.ocean.set_gerstner_waves(gerstner_waves);
      return sea.ocean.sample(points);
    };
    sea.ocean.set_shoals(nullptr);
    const auto cascades = sampled_with({}), open = sampled_with(alone);
    sea.ocean.set_shoals(std::make_shared<const Shoals>(device_, flat(3.0), table));
    const auto less = sampled_with({}), found = sampled_with(alone);
    const double share = shares[static_cast<std::size_t>(SHOAL_FIRST_GERSTNER + band)];
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(found[i].height_m - less[i].height_m, share * (open[i].height_m - cascades[i].height_m),
                  1e-5);
      EXPECT_NEAR(found[i].slope_x - less[i].slope_x, share * (open[i].slope_x - cascades[i].slope_x), 1e-6);
      EXPECT_NEAR(found[i].velocity_y_mps - less[i].velocity_y_mps,
                  share * (open[i].velocity_y_mps - cascades[i].velocity_y_mps), 1e-5);
    }
  }
}

// Fails if a cascade is scaled by another's share. At the samples of the first cascade's grid its height is
// known; the rest of the open sea's is the second one's. Over a level bed, without choppiness, both are what
// their shares leave. Rounding, of heights below 4 m: 2e-6 m.
TEST_F(ShoalsTest, ScaleEachCascadeByItsShare) {
  HybridSea sea = hybrid_sea(device_, 64, 0.0);
  const ShoalTable table = table_of(sea);
  ASSERT_EQ(sea.ocean.parameters().cascades.size(), 2u);
  const double cell_m = sea.ocean.parameters().cascades[0].patch_length_m / 64.0;
  std::vector<WaterPoint> points;
  for (int i = 0; i < 64 * 64; i += 37) points.push_back({i % 64 * cell_m, i / 64 * cell_m});
  sea.ocean.set_gerstner_waves({});
  sea.ocean.at(30.0);
  const SurfaceFields first = sea.ocean.read_surface(0);
  const WaterQuery query{.accuracy = WaterQuery::Accuracy::frame_maps};
  const auto open = sea.ocean.sample(points, query);
  for (const double depth_m : {1.0, 3.0, 8.0}) {
    const std::array<double, SHOAL_BANDS> shares = table.at(depth_m);
    ASSERT_GT(std::abs(shares[0] - shares[1]), 0.005);
    sea.ocean.set_shoals(std::make_shared<const Shoals>(device_, flat(depth_m), table));
    const auto found = sea.ocean.sample(points, query);
    double worst_m = 0.0, most_short_m = 0.0, most_long_m = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double long_m = first.displacement_y[37 * i], short_m = open[i].height_m - long_m;
      worst_m = std::max(worst_m, std::abs(found[i].height_m - shares[0] * long_m - shares[1] * short_m));
      most_short_m = std::max(most_short_m, std::abs(short_m));
      most_long_m = std::max(most_long_m, std::abs(long_m));
    }
    EXPECT_GT(std::min(most_short_m, most_long_m), 0.05) << "nothing to scale";
    EXPECT_LT(worst_m, 1e-5) << depth_m;
  }
}

// Fails if queries differ from the same in double precision, on land, at the waterline, on a beach, a steep
// bed, beyond the map and in the open sea, alone or in the batch. Both end within the tolerance of 1e-4 m at
// slopes below 1 of the point: heights within 2e-4 m. Measured 0.1 mm.
TEST_F(ShoalsTest, QueriesAreThoseOfTheReference) {
  for (const double slope : {0.02, 0.1, 0.5}) {
    HybridSea sea = hybrid_sea(device_, 128);
    lay(sea, beach(slope));
    sea.ocean.at(11.0);
    const WaterQuery query{.depth_m = 0.0, .tolerance_m = 1e-5, .accuracy = WaterQuery::Accuracy::frame_maps};
    const SurfaceInstant reference = sea.ocean.instant(query);
    std::vector<WaterPoint> points = scattered_points(300, 1600.0);
    points.push_back({0.0, 0.0});
    const std::vector<WaterSample> samples = sea.ocean.sample(points, query);
    double worst_m = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const WaterSample expected = reference.at(points[i]);
      worst_m = std::max<double>(worst_m, std::abs(samples[i].height_m - expected.height_m));
      EXPECT_LE(samples[i].residual_m, 1e-4);
      EXPECT_NEAR(samples[i].slope_x, expected.slope_x, 2e-3);
      EXPECT_NEAR(samples[i].velocity_x_mps, expected.velocity_x_mps, 2e-3);
      EXPECT_NEAR(samples[i].pressure_pa, expected.pressure_pa, 5.0);
    }
    RecordProperty("worst_nm_at_" + std::to_string(static_cast<int>(100.0 * slope)),
                   static_cast<int>(1e9 * worst_m));
    EXPECT_LT(worst_m, 2e-4) << slope;
  }
}

// Fails if waves run up the land or a trough bares the bed: six standard deviations are 0.89 of the depth
// that a label has, and from there they move the water by no more than that sideways, where it is still half
// as deep or more. On land the water is level, exactly.
TEST_F(ShoalsTest, NoWaveRunsThroughRock) {
  for (const double slope : {0.05, 0.5}) {
    HybridSea sea = hybrid_sea(device_, 128);
    lay(sea, beach(slope));
    for (const double time_s : {3.0, 40.0, 77.0}) {
      sea.ocean.at(time_s);
      std::vector<WaterPoint> points = scattered_points(3000, 300.0);
      const std::vector<WaterSample> samples = sea.ocean.sample(points);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double depth_m = slope * points[i].x_m;
        if (depth_m <= 0.0) {
          ASSERT_EQ(samples[i].height_m, 0.0f);
          ASSERT_EQ(samples[i].slope_x, 0.0f);
          ASSERT_EQ(samples[i].velocity_x_mps, 0.0f);
        } else {
          ASSERT_GT(samples[i].height_m, -depth_m) << points[i].x_m;
        }
        ASSERT_LE(samples[i].residual_m, 1.1e-4f);
      }
    }
  }
}

// Fails if a sea without shoals is another than before, or one far from them.
TEST_F(ShoalsTest, LeaveTheOpenSea) {
  HybridSea sea = hybrid_sea(device_, 128);
  sea.ocean.at(5.0);
  const std::vector<WaterPoint> points = scattered_points(200, 500.0);
  const auto open = sea.ocean.sample(points);
  lay(sea, flat(1e4));
  const auto deep = sea.ocean.sample(points);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(deep[i].height_m, open[i].height_m, 2e-5);
  lay(sea, flat(2.0));
  EXPECT_NE(sea.ocean.sample(points)[0].height_m, open[0].height_m);
  sea.ocean.set_shoals(nullptr);
  const auto again = sea.ocean.sample(points);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(again[i].height_m, open[i].height_m);
}

}  // namespace
}  // namespace offing::ocean
