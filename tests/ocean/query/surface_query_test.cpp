// Queries: the water at points of the world (ocean/surface_query.cl), against closed forms, the composed
// surface and the same in double precision on the host.
#include "host/ocean/query/surface_query.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include "host/ocean/surface/ocean.h"
#include "tests/ocean/query/queried_sea.h"
#include "tests/ocean/surface/single_wave.h"
#include "tests/ocl/expect_error.h"

namespace offing::ocean {
namespace {

using Accuracy = WaterQuery::Accuracy;
using Fields = WaterQuery::Fields;
using std::numbers::pi;

class SurfaceQueryTest : public testing::Test {
 protected:
  // One wave of the cascades, so that samples between texels keep the proportions of its fields.
  static Ocean single_wave_sea(const ocl::Device& device, double amplitude_m, double choppiness,
                               double depth_m) {
    const OceanParameters parameters{
        .size = 64, .cascades = {{40.0, 0.0, 1.0}}, .seed = 5, .choppiness = choppiness};
    const SingleWave wave{.patch_length_m = 40.0,
                          .column = 1,
                          .row = 2,
                          .amplitude_m = amplitude_m,
                          .dispersion = {.depth_m = depth_m}};
    return {device, single_wave_spectrum(wave, parameters), parameters};
  }
  static double single_wavenumber_radpm() { return 2.0 * pi / 40.0 * std::sqrt(5.0); }

  ocl::Device device_ = ocl::Device::open();
};

// Fails if labels are not inverted, or if a sample is of the label instead of the point: where a Gerstner
// wave's point X moves to x = X - A sin p, its height is A cos p and its slope -kA sin p / (1 - kA cos p). At
// kA = 0.85 the two differ by metres. The cascade is a micrometre high. Height is off by slope times
// residual, at most tan 60 deg times the tolerance of 1e-4 m, and rounding: gate 2e-4 m; slopes by their
// derivative, up to kA k / (1 - kA)^3 = 8 /m, times that of the label: 1e-4 / 0.15 m, gate 6e-3.
TEST_F(SurfaceQueryTest, FindsTheLabelsOfASteepGerstner) {
  Ocean sea = single_wave_sea(device_, 1e-6, 0.0, std::numeric_limits<double>::infinity());
  const double k = 2.0 * pi / 150.0, amplitude_m = 0.85 / k, time_s = 7.0;
  const double omega_radps = std::sqrt(9.81 * k);
  sea.set_gerstner_waves({.waves = {{.amplitude_m = amplitude_m,
                                     .wavenumber_radpm = k,
                                     .direction_rad = 0.6,
                                     .omega_radps = omega_radps,
                                     .phase_rad = 0.3}}});
  sea.at(time_s);
  std::vector<WaterPoint> points;
  std::vector<double> phases;
  for (int i = 0; i < 1000; ++i) {
    const WaterPoint label{-200.0 + 0.7 * i, 30.0 - 0.45 * i};
    const double cosine = std::cos(0.6), sine = std::sin(0.6);
    const double phase = k * (cosine * label.x_m + sine * label.z_m) - omega_radps * time_s + 0.3;
    phases.push_back(phase);
    points.push_back({label.x_m - amplitude_m * cosine * std::sin(phase),
                      label.z_m - amplitude_m * sine * std::sin(phase)});
  }
  const std::vector<WaterSample> samples = sea.sample(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double slope = -0.85 * std::sin(phases[i]) / (1.0 - 0.85 * std::cos(phases[i]));
    ASSERT_NEAR(samples[i].height_m, amplitude_m * std::cos(phases[i]), 2e-4) << i;
    ASSERT_NEAR(samples[i].slope_x, slope * std::cos(0.6), 6e-3) << i;
    ASSERT_NEAR(samples[i].slope_z, slope * std::sin(0.6), 6e-3) << i;
    ASSERT_LE(samples[i].residual_m, 1e-4) << i;
    const auto normal = normal_of(samples[i]);
    ASSERT_NEAR(normal[1], 1.0 / std::hypot(slope, 1.0), 4e-3) << i;
    ASSERT_NEAR(normal[0], -slope * std::cos(0.6) * normal[1], 6e-3) << i;
  }
}

// Fails if velocity or pressure of a cascade's wave are not those of linear theory: with h the height that is
// sampled beside them, horizontal velocity w h cosh k(D-d) / sinh kD along K, pressure rho g (d - h + h cosh
// k(D-d) / cosh kD); 0 at the surface; the vertical velocity, a quarter of a period away, makes with them the
// ellipse of a particle. Rounding of maps and frequencies: gates 1e-4 of the largest values.
TEST_F(SurfaceQueryTest, CascadesFlowAsAiryWaves) {
  const double k = single_wavenumber_radpm();
  for (const double bed_m : {3.0, std::numeric_limits<double>::infinity()}) {
    const Dispersion dispersion{.depth_m = bed_m};
    const double omega_radps = dispersion.omega_radps(k);
    Ocean sea = single_wave_sea(device_, 0.5, 0.0, bed_m);
    sea.at(11.0);
    for (const double depth_m : {0.0, 0.7, 2.5}) {
      const WaterQuery query{.depth_m = depth_m, .density_kgpm3 = 1000.0, .accuracy = Accuracy::exact};
      const auto over_sinh = [&](double sign) {
        return std::exp(-k * depth_m) * (1.0 + sign * std::exp(-2.0 * k * (bed_m - depth_m))) /
               (1.0 - std::exp(-2.0 * k * bed_m));
      };
      const double horizontal = over_sinh(1.0), vertical = over_sinh(-1.0);
      const double pressure = horizontal * std::tanh(k * bed_m);
      double amplitude_m = 0.0;
      const std::vector<WaterSample> samples = sea.sample(scattered_points(200, 300.0), query);
      for (const WaterSample& sample : samples) amplitude_m = std::max(amplitude_m, 1.0 * sample.height_m);
      ASSERT_NEAR(amplitude_m, 0.5, 0.02);
      const double speed_mps = omega_radps * amplitude_m;
      for (const WaterSample& sample : samples) {
        const double along_mps = omega_radps * horizontal * sample.height_m;
        EXPECT_NEAR(sample.velocity_x_mps, along_mps / std::sqrt(5.0), 1e-4 * speed_mps);
        EXPECT_NEAR(sample.velocity_z_mps, along_mps * 2.0 / std::sqrt(5.0), 1e-4 * speed_mps);
        EXPECT_NEAR(sample.pressure_pa, 9810.0 * (depth_m - sample.height_m + pressure * sample.height_m),
                    1e-4 * 9810.0 * (amplitude_m + depth_m));
        // dh/dt = -w/k dh/dX for a wave along +K; without choppiness slopes at labels are those in space.
        const double along_slope = (sample.slope_x + 2.0 * sample.slope_z) / std::sqrt(5.0);
        EXPECT_NEAR(sample.velocity_y_mps, -omega_radps / k * along_slope * vertical, 1e-3 * speed_mps);
      }
    }
  }
}

// The same for a Gerstner wave, in a sea whose cascade is a micrometre high; without choppiness its label is
// the point. Gates 1e-5 of the largest values and the cascade's share.
TEST_F(SurfaceQueryTest, GerstnerWavesFlowAsAiryWaves) {
  for (const double bed_m : {6.0, std::numeric_limits<double>::infinity()}) {
    const Dispersion dispersion{.depth_m = bed_m};
    Ocean sea = single_wave_sea(device_, 1e-6, 0.0, bed_m);
    sea.set_gerstner_waves(
        {.waves = {make_swell({.amplitude_m = 0.8, .wavelength_m = 30.0, .direction_rad = 2.0}, dispersion)},
         .choppiness = 0.0,
         .dispersion = dispersion});
    const double k = 2.0 * pi / 30.0, omega_radps = dispersion.omega_radps(k), time_s = 20.0;
    sea.at(time_s);
    const std::vector<WaterPoint> points = scattered_points(200, 300.0);
    for (const double depth_m : {0.0, 1.3, 5.5}) {
      const std::vector<WaterSample> samples = sea.sample(points, {.depth_m = depth_m});
      const double whole = -std::expm1(-2.0 * k * bed_m), decay = std::exp(-k * depth_m);
      const double above_bed = std::exp(-2.0 * k * (bed_m - depth_m));
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double phase =
            k * (std::cos(2.0) * points[i].x_m + std::sin(2.0) * points[i].z_m) - omega_radps * time_s;
        const double speed_mps = omega_radps * 0.8;
        const double along_mps = speed_mps * decay * (1.0 + above_bed) / whole * std::cos(phase);
        const double head_m = 0.8 * decay * (1.0 + above_bed) / (2.0 - whole) * std::cos(phase);
        EXPECT_NEAR(samples[i].height_m, 0.8 * std::cos(phase), 2e-5);
        EXPECT_NEAR(samples[i].velocity_x_mps, along_mps * std::cos(2.0), 2e-5);
        EXPECT_NEAR(samples[i].velocity_z_mps, along_mps * std::sin(2.0), 2e-5);
        EXPECT_NEAR(samples[i].velocity_y_mps,
                    speed_mps * decay * (1.0 - above_bed) / whole * std::sin(phase), 2e-5);
        EXPECT_NEAR(samples[i].pressure_pa, 1025.0 * 9.81 * (depth_m + head_m - 0.8 * std::cos(phase)),
                    1025.0 * 9.81 * 4e-5);
      }
    }
  }
}

// Fails if a query is not of the surface that is composed: points of a grid of labels are moved as
// read_composed() says, and asked for where they are then. All layers are in. Heights are off by the
// displaced slope (below 1.5) times the residual, and by the composed label's own rounding: 0.008 texels at
// most, 0.6 mm of these waves. Gate 1 mm.
TEST_F(SurfaceQueryTest, IsTheComposedSurface) {
  HybridSea hybrid = hybrid_sea(device_, 256);
  GerstnerSea with_drop = hybrid.ocean.parameters().gerstner_waves;
  with_drop.raindrops = {{.x_m = 8.0, .z_m = 20.0, .time_s = 19.0, .amplitude_m = 0.3, .wavelength_m = 6.0}};
  hybrid.ocean.set_gerstner_waves(with_drop);
  hybrid.ocean.at(20.0);
  const SampleGrid grid{.origin_x_m = -31.7,
                        .origin_z_m = 12.3,
                        .spacing_x_m = 0.83,
                        .spacing_z_m = 1.21,
                        .columns = 60,
                        .rows = 40};
  const ComposedFields composed = hybrid.ocean.read_composed(grid);
  std::vector<WaterPoint> points;
  for (int i = 0; i < grid.rows * grid.columns; ++i) {
    points.push_back({grid.origin_x_m + i % grid.columns * grid.spacing_x_m + composed.displacement_x[i],
                      grid.origin_z_m + i / grid.columns * grid.spacing_z_m + composed.displacement_z[i]});
  }
  ASSERT_GT(*std::min_element(composed.jacobian.begin(), composed.jacobian.end()), 0.0f)
      << "a folded sea has points with several heights";
  const std::vector<WaterSample> samples = hybrid.ocean.sample(points, {.accuracy = Accuracy::frame_maps});
  double worst_m = 0.0, squares = 0.0, all_squares = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    worst_m = std::max<double>(worst_m, std::abs(samples[i].height_m - composed.displacement_y[i]));
    all_squares += std::pow(composed.slope_x[i], 2) + std::pow(composed.slope_z[i], 2);
    squares += std::pow(samples[i].slope_x - composed.slope_x[i], 2) +
               std::pow(samples[i].slope_z - composed.slope_z[i], 2);
  }
  EXPECT_LT(worst_m, 1e-3);
  // A label's rounding is spread evenly over 0.008 texels either way, 0.0046 RMS, and slopes of neighbouring
  // texels differ by at most twice the slopes' RMS.
  EXPECT_LT(std::sqrt(squares / all_squares), 2.0 * 0.0046);
  RecordProperty("slope_difference_of_rms", std::to_string(std::sqrt(squares / all_squares)));
  RecordProperty("worst_mm", std::to_string(1e3 * worst_m));
}

// Fails if the search stops early, or gives up where crests are steep: all residuals keep the tolerance in a
// storm whose crests are about to fold; where it folds (choppiness 2.5) most points still have a label within
// tolerance, and the others say how far they are off, and are finite. Places 32 m from a tile's middle are
// floats 4e-6 m apart.
TEST_F(SurfaceQueryTest, ResidualsKeepTheTolerance) {
  HybridSea hybrid = hybrid_sea(device_, 256);
  hybrid.ocean.at(5.0);
  for (const Accuracy accuracy : {Accuracy::maps, Accuracy::frame_maps}) {
    for (const double tolerance_m : {1e-5, 1e-4, 1e-2}) {
      for (const WaterSample& sample : hybrid.ocean.sample(
               scattered_points(20000, 2000.0), {.tolerance_m = tolerance_m, .accuracy = accuracy}))
        ASSERT_LE(sample.residual_m, 1.1 * tolerance_m + 4e-6);
    }
  }
  HybridSea folded = hybrid_sea(device_, 256, 2.5);
  folded.ocean.at(5.0);
  int missed = 0;
  for (const WaterSample& sample : folded.ocean.sample(scattered_points(20000, 2000.0))) {
    ASSERT_TRUE(std::isfinite(sample.height_m) && std::isfinite(sample.residual_m));
    missed += sample.residual_m > 1e-4 ? 1 : 0;
  }
  RecordProperty("missed_of_20000_where_folded", missed);
  EXPECT_LT(missed, 200);
}

// Fails if a wave shorter than asked still counts, or a longer one does not: the filtered sea is that whose
// cascades and Gerstner waves end there, bit for bit; Q stays that of the whole sea.
TEST_F(SurfaceQueryTest, LeavesShortWavesOut) {
  HybridSea hybrid = hybrid_sea(device_, 128);
  const double shortest_m = 60.0;
  GerstnerSea gerstner_waves = hybrid.ocean.parameters().gerstner_waves;
  ASSERT_FALSE(horizontal_scale(gerstner_waves).is_limited);
  OceanParameters long_parameters = hybrid.ocean.parameters();
  for (Cascade& cascade : long_parameters.cascades) {
    cascade.k_max_radpm = std::min(cascade.k_max_radpm, 2.0 * pi / shortest_m);
    cascade.k_min_radpm = std::min(cascade.k_min_radpm, cascade.k_max_radpm);
  }
  std::vector<GerstnerWave>& long_waves = long_parameters.gerstner_waves.waves;
  std::erase_if(long_waves,
                [&](const GerstnerWave& wave) { return wave.wavenumber_radpm > 2.0 * pi / shortest_m; });
  ASSERT_LT(long_waves.size(), gerstner_waves.waves.size());
  ASSERT_FALSE(long_waves.empty());
  Ocean long_sea(device_, hybrid.spectrum, long_parameters);
  gerstner_waves.raindrops = {{.x_m = 1.0, .time_s = 30.0, .amplitude_m = 1.0, .wavelength_m = 5.0}};
  hybrid.ocean.set_gerstner_waves(gerstner_waves);
  const std::vector<WaterPoint> points = scattered_points(500, 400.0);
  for (const double time_s : {31.0, 35.0}) {
    hybrid.ocean.at(time_s);
    long_sea.at(time_s);
    for (const double depth_m : {0.0, 4.0}) {
      const auto filtered = hybrid.ocean.sample(
          points, {.depth_m = depth_m, .min_wavelength_m = shortest_m, .accuracy = Accuracy::frame_maps});
      const auto expected = long_sea.sample(points, {.depth_m = depth_m, .accuracy = Accuracy::frame_maps});
      for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_FLOAT_EQ(filtered[i].height_m, expected[i].height_m);
        ASSERT_NEAR(filtered[i].slope_x, expected[i].slope_x, 1e-6);
        ASSERT_NEAR(filtered[i].velocity_y_mps, expected[i].velocity_y_mps, 1e-6);
        ASSERT_NEAR(filtered[i].pressure_pa, expected[i].pressure_pa, 0.02);
      }
    }
  }
  // And a filter below all waves changes nothing.
  gerstner_waves.raindrops.clear();
  hybrid.ocean.set_gerstner_waves(gerstner_waves);
  const auto all = hybrid.ocean.sample(points);
  const auto same = hybrid.ocean.sample(points, {.min_wavelength_m = 0.01});
  EXPECT_EQ(std::memcmp(all.data(), same.data(), all.size() * sizeof(WaterSample)), 0);
}

// Fails if a sample depends on its neighbours in the batch, on the call before, or on whether points and
// samples stay on the device.
TEST_F(SurfaceQueryTest, EachPointIsAnsweredByItself) {
  HybridSea hybrid = hybrid_sea(device_, 128);
  hybrid.ocean.at(9.0);
  const std::vector<WaterPoint> points = scattered_points(1003, 3000.0);
  const auto expect_same = [](const WaterSample* found, const WaterSample* expected, std::size_t count) {
    EXPECT_EQ(std::memcmp(found, expected, count * sizeof(WaterSample)), 0);
  };
  for (const Accuracy accuracy : {Accuracy::exact, Accuracy::maps, Accuracy::frame_maps}) {
    const WaterQuery query{.accuracy = accuracy};
    const std::vector<WaterSample> together = hybrid.ocean.sample(points, query);
    for (const std::size_t i : {0u, 1u, 500u, 1002u}) {
      const auto alone = hybrid.ocean.sample(std::span(points).subspan(i, 1), query);
      expect_same(alone.data(), &together[i], 1);
    }
    hybrid.ocean.at(10.0);
    hybrid.ocean.at(9.0);
    expect_same(hybrid.ocean.sample(points, query).data(), together.data(), points.size());
  }
  const std::vector<WaterSample> together = hybrid.ocean.sample(points);

  std::vector<SurfaceQueryPoint> packed(points.size());
  std::transform(points.begin(), points.end(), packed.begin(), device_point);
  const ocl::Buffer<SurfaceQueryPoint> device_points(device_, packed, "points");
  ocl::Buffer<WaterSample> device_samples(device_, points.size(), "samples");
  hybrid.ocean.sample(device_points, points.size(), device_samples);
  expect_same(device_samples.read().data(), together.data(), points.size());
}

// Fails if bad questions are answered, or good ones at the edges are not.
TEST_F(SurfaceQueryTest, RefusesBadQuestions) {
  Ocean sea = single_wave_sea(device_, 0.5, 1.0, 8.0);
  EXPECT_TRUE(sea.sample(std::vector<WaterPoint>{}).empty());
  const std::vector<WaterPoint> one(1);
  EXPECT_EQ(sea.sample(one).size(), 1u);
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double place_m : {nan, infinity, -infinity, 2.1e7}) {
    test::expect_error(ErrorKind::bad_input, "point.x_m", [&] {
      sea.sample(std::vector<WaterPoint>{{}, {place_m, 0.0}});
    });
    test::expect_error(ErrorKind::bad_input, "point.z_m", [&] { sea.instant().at({0.0, place_m}); });
  }
  for (const double depth_m : {-0.1, 8.1, nan})
    test::expect_error(ErrorKind::bad_input, "depth_m", [&] { sea.sample(one, {.depth_m = depth_m}); });
  test::expect_error(ErrorKind::bad_input, "min_wavelength_m",
                     [&] { sea.sample(one, {.min_wavelength_m = nan}); });
  test::expect_error(ErrorKind::bad_input, "tolerance_m", [&] { sea.sample(one, {.tolerance_m = 0.0}); });
  test::expect_error(ErrorKind::bad_input, "gerstner.amplitude_m",
                     [&] { sea.set_gerstner_waves({.waves = {{.amplitude_m = nan}}}); });
  std::vector<WaterSample> two(2);
  test::expect_error(ErrorKind::bad_usage, "expected a sample for each of 1 points, found 2",
                     [&] { sea.sample(one, two); });
  const ocl::Buffer<SurfaceQueryPoint> points(device_, 3, "points");
  ocl::Buffer<WaterSample> samples(device_, 2, "samples");
  test::expect_error(ErrorKind::bad_usage, "buffers of 3", [&] { sea.sample(points, 3, samples); });
}

// Fails if a point that a kernel wrote badly brings the device down, or its neighbours into disorder.
TEST_F(SurfaceQueryTest, PointsOnTheDeviceThatAreNotFiniteSayThatThemselves) {
  Ocean sea = single_wave_sea(device_, 0.5, 1.0, 8.0);
  std::vector<SurfaceQueryPoint> packed(40, device_point({3.0, 4.0}));
  packed[7].x_m = std::numeric_limits<float>::quiet_NaN();
  packed[8].z_m = std::numeric_limits<float>::infinity();
  packed[9] = {.tile_x = 2147483647, .tile_z = -2147483647 - 1, .x_m = 0.0f, .z_m = 0.0f};
  const ocl::Buffer<SurfaceQueryPoint> points(device_, packed, "points");
  ocl::Buffer<WaterSample> samples(device_, packed.size(), "samples");
  sea.sample(points, packed.size(), samples);
  const std::vector<WaterSample> found = samples.read();
  EXPECT_FALSE(std::isfinite(found[7].residual_m));
  EXPECT_FALSE(std::isfinite(found[8].residual_m));
  EXPECT_TRUE(std::isfinite(found[9].height_m));
  for (const std::size_t i : {6u, 10u, 39u}) EXPECT_EQ(found[i].height_m, found[0].height_m);
}

}  // namespace
}  // namespace offing::ocean
