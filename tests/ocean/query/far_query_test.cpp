// Queries far from the origin of the world: ocean/surface_query.cl against the host's double precision.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/ocean/surface/ocean.h"
#include "tests/ocean/query/queried_sea.h"

namespace offing::ocean {
namespace {

// Fails if device and host disagree by a millimetre, here or 100 km away, where a float of the coordinate
// alone would be off by 8 mm and phases of waves by more. Bound: residuals of both, 1e-4 m each times slopes
// of the displaced surface of about 1, and 2^-24 of places and heights; measured 0.02 mm. Or if the surface
// alone comes with a velocity or a pressure.
TEST(FarQuery, DeviceAndHostAgreeAlsoFarAway) {
  HybridSea hybrid = hybrid_sea(ocl::Device::open(), 256);
  hybrid.ocean.at(321.7);
  for (WaterQuery query : {WaterQuery{}, WaterQuery{.depth_m = 2.0}, WaterQuery{.min_wavelength_m = 9.0},
                           WaterQuery{.fields = WaterQuery::Fields::surface}}) {
    query.accuracy = WaterQuery::Accuracy::frame_maps;
    const SurfaceInstant instant = hybrid.ocean.instant(query);
    for (const WaterPoint& centre :
         {WaterPoint{}, WaterPoint{1e5, -1e5}, WaterPoint{-farthest_point_m + 1e3, 12345.6}}) {
      std::vector<WaterPoint> points = scattered_points(2000, 900.0);
      for (WaterPoint& point : points) point = {point.x_m + centre.x_m, point.z_m + centre.z_m};
      const std::vector<WaterSample> samples = hybrid.ocean.sample(points, query);
      double worst_m = 0.0, worst_mps = 0.0, worst_pa = 0.0, residual_m = 0.0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const WaterSample host = instant.at(points[i]);
        const auto difference = [&](float WaterSample::*field) {
          return std::abs(1.0 * samples[i].*field - host.*field);
        };
        worst_m = std::max(worst_m, difference(&WaterSample::height_m));
        worst_mps =
            std::max({worst_mps, difference(&WaterSample::velocity_x_mps),
                      difference(&WaterSample::velocity_y_mps), difference(&WaterSample::velocity_z_mps)});
        worst_pa = std::max(worst_pa, difference(&WaterSample::pressure_pa));
        residual_m = std::max<double>({residual_m, samples[i].residual_m, host.residual_m});
        if (query.fields == WaterQuery::Fields::surface) {
          EXPECT_EQ(samples[i].velocity_x_mps, 0.0f);
          EXPECT_EQ(samples[i].velocity_y_mps, 0.0f);
          EXPECT_EQ(samples[i].velocity_z_mps, 0.0f);
          EXPECT_EQ(samples[i].pressure_pa, 0.0f);
        }
      }
      EXPECT_LT(worst_m, 1e-3);
      EXPECT_LT(worst_mps, 1e-3);
      EXPECT_LT(worst_pa, 10.0) << "a millimetre of water";
      EXPECT_LE(residual_m, 1.1e-4) << "the tolerance, and rounding of the far label's place";
      testing::Test::RecordProperty("worst_mm_at_" + std::to_string(centre.x_m),
                                    std::to_string(1e3 * worst_m));
    }
  }
}

// Fails if a wave's phase from tile to tile is rounded to 2^-32 turns: at the farthest points, 312500 tiles
// along x and z, half of that a tile would be 7e-5 turns and move a wave of 20 m by up to 9 mm. No wave of
// the cascades is as long as asked, and without choppiness labels are points. Bound: floats of turns within a
// tile (half a turn at most: 3e-8 turns, 4e-6 m) and of the cosine (2e-6, 4e-5 m); measured 0.005 mm. Gate
// 1e-4 m.
TEST(FarQuery, FindsHighWavesAtTheFarthestPoints) {
  HybridSea hybrid = hybrid_sea(ocl::Device::open(), 64);
  hybrid.ocean.at(0.0);
  double worst_m = 0.0;
  for (int i = 0; i < 12; ++i) {
    const double direction_rad = 0.1 + 0.5 * i, wavelength_m = 130.0 + 7.7 * i;
    const Swell swell{.amplitude_m = 20.0, .wavelength_m = wavelength_m, .direction_rad = direction_rad};
    const GerstnerWave wave = make_swell(swell, hybrid.spectrum.dispersion);
    hybrid.ocean.set_gerstner_waves({.waves = {wave}, .choppiness = 0.0});
    std::vector<WaterPoint> points = scattered_points(100, 900.0);
    for (WaterPoint& point : points) {
      point.x_m += ((i & 1) != 0 ? 1.0 : -1.0) * (farthest_point_m - 1e3);
      point.z_m += ((i & 2) != 0 ? 1.0 : -1.0) * (farthest_point_m - 1e3);
    }
    const std::vector<WaterSample> samples =
        hybrid.ocean.sample(points, {.min_wavelength_m = 120.0, .fields = WaterQuery::Fields::surface});
    const double k = wave.wavenumber_radpm;
    for (std::size_t j = 0; j < points.size(); ++j) {
      const double phase =
          k * (std::cos(direction_rad) * points[j].x_m + std::sin(direction_rad) * points[j].z_m);
      worst_m = std::max(worst_m, std::abs(samples[j].height_m - 20.0 * std::cos(phase)));
    }
  }
  testing::Test::RecordProperty("worst_mm", std::to_string(1e3 * worst_m));
  EXPECT_LT(worst_m, 1e-4);
}

// Fails if heights jitter far from the origin: along a line in steps of a millimetre, 141 km away, the device
// is off the host's double precision by the same from point to point. Both miss their labels by 1e-5 m at
// most, times slopes of about 1, and floats of heights of a few metres are 2.4e-7 m apart: bound 2e-5 m from
// point to point, gate 3e-5 m. In float the place itself would move in steps of 8 mm.
TEST(FarQuery, DoesNotJitterFarAway) {
  HybridSea hybrid = hybrid_sea(ocl::Device::open(), 256);
  hybrid.ocean.at(3.0);
  const WaterQuery query{.tolerance_m = 1e-5, .accuracy = WaterQuery::Accuracy::frame_maps};
  const SurfaceInstant instant = hybrid.ocean.instant(query);
  std::vector<WaterPoint> points;
  for (int i = 0; i < 4000; ++i) points.push_back({1e5 + 1e-3 * i, 1e5 - 7e-4 * i});
  const std::vector<WaterSample> samples = hybrid.ocean.sample(points, query);
  double worst_m = 0.0, off_before_m = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double off_m = 1.0 * samples[i].height_m - instant.at(points[i]).height_m;
    if (i > 0) worst_m = std::max(worst_m, std::abs(off_m - off_before_m));
    off_before_m = off_m;
  }
  EXPECT_LT(worst_m, 3e-5);
  testing::Test::RecordProperty("worst_mm", std::to_string(1e3 * worst_m));
}

}  // namespace
}  // namespace offing::ocean
