#include "host/cli/pictures/preview_surface.h"

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/cli/pictures/test_sea.h"

namespace offing::cli {
namespace {

// Fails if a sample's place is off, rows and columns are mixed up, or the patch does not repeat.
TEST(PreviewSurface, ReturnsSamplesAndRepeats) {
  ocean::SurfaceFields fields = calm_sea(16);
  fields.displacement_y[3 * 16 + 5] = 1.0f;
  const PreviewSurface surface = surface_of(fields, 32.0);  // spacing 2 m
  EXPECT_FLOAT_EQ(surface.displacement(10.0, 6.0, 0.1f)[1], 1.0f);
  EXPECT_FLOAT_EQ(surface.displacement(11.0, 6.0, 0.1f)[1], 0.5f);
  EXPECT_FLOAT_EQ(surface.displacement(6.0, 10.0, 0.1f)[1], 0.0f);
  EXPECT_FLOAT_EQ(surface.displacement(10.0 - 32.0, 6.0 + 3 * 32.0, 0.1f)[1], 1.0f);
}

// Fails if the slope is that at labels instead of the displaced surface's, dy/dX = (dy/dx) / (dX/dx).
// Bound: bilinear error of the fields, (k spacing)^2 / 8 = 3e-4 relative at 128 samples a wave; gate 1e-3 of
// max slope.
TEST(PreviewSurface, SlopeIsThatOfTheDisplacedWave) {
  const double length_m = 64.0, k = 2.0 * std::numbers::pi / length_m, a = 0.3 / k;
  const PreviewSurface surface = surface_of(one_wave(128, length_m, 1, a), length_m);
  for (double x = 0.25; x < length_m; x += 3.7) {
    const double expected = -a * k * std::sin(k * x) / (1.0 - a * k * std::cos(k * x));
    EXPECT_NEAR(surface.sample(x, 5.0, 0.01f).slope_x, expected, 1e-3 * 0.43) << x;
  }
}

// Fails if averaging loses or invents roughness: at every scale mean square of the mean slope + mean hidden
// variance is the mean square of all samples. Holds exactly at texel centres; gate 1e-5 relative, rounding of
// 64^2 sums (measured 2e-7).
TEST(PreviewSurface, RoughnessIsKeptAtEveryScale) {
  const ocean::SurfaceFields fields = noisy_slopes(64, 0.2f);
  const PreviewSurface surface = surface_of(fields, 64.0);
  double total = 0.0;
  for (const float slope : fields.slope_x) total += double{slope} * slope / (64.0 * 64.0);
  for (int texel_m = 1; texel_m <= 64; texel_m *= 2) {
    double sum = 0.0;
    int count = 0;
    for (int z = 0; z < 64; z += texel_m) {
      for (int x = 0; x < 64; x += texel_m, ++count) {
        const double center = 0.5 * (texel_m - 1);
        const SurfaceSample sample = surface.sample(x + center, z + center, static_cast<float>(texel_m));
        sum += double{sample.slope_x} * sample.slope_x + sample.variance_xx;
      }
    }
    EXPECT_NEAR(sum / count, total, 1e-5 * total) << texel_m;
  }
}

// Fails if a footprint beyond the patch still shows waves (they would alias), or elevation statistics are
// off.
TEST(PreviewSurface, FarWaterIsSmoothButRough) {
  const double length_m = 64.0, k = 2.0 * std::numbers::pi * 4 / length_m, a = 0.2 / k;
  const PreviewSurface surface = surface_of(one_wave(128, length_m, 4, a), length_m);
  const SurfaceSample far = surface.sample(3.0, 1.0, 500.0f);
  EXPECT_NEAR(far.slope_x, 0.0, 1e-6);
  EXPECT_NEAR(far.displacement_y, 0.0, 1e-6);
  EXPECT_NEAR(far.variance_xx, 0.5 * 0.2 * 0.2, 1e-5);
  EXPECT_NEAR(surface.elevation_deviation_m(), a / std::sqrt(2.0), 1e-5 * a);
  EXPECT_NEAR(surface.largest_shift_m(), a, 1e-3 * a);
}

// Fails if fields beyond 1024 samples are cut instead of averaged: the mean of each 2 x 2 block must come
// back.
TEST(PreviewSurface, LargeFieldsAreAveragedDown) {
  ocean::SurfaceFields fields = calm_sea(2048);
  fields.displacement_y[0] = 4.0f;
  fields.slope_x[0] = 4.0f;
  const PreviewSurface surface = surface_of(fields, 2048.0);
  const SurfaceSample sample = surface.sample(0.5, 0.5, 0.1f);  // the centre of the first block
  EXPECT_FLOAT_EQ(sample.displacement_y, 1.0f);
  EXPECT_FLOAT_EQ(sample.variance_xx, 3.0f);  // mean of 16, 0, 0, 0 less 1
}

// Fails if foam does not follow its ramp, c = (onset - J) / width, or given foam is lost.
// Gate 1e-3: the ramp's corners are rounded over 0.001.
TEST(PreviewSurface, FoamFollowsTheJacobian) {
  ocean::SurfaceFields fields = calm_sea(16);
  for (float& gradient : fields.gradient_xx) gradient = -0.7f;
  EXPECT_NEAR(surface_of(fields, 16.0).sample(1.0, 1.0, 0.1f).foam, 0.5,
              1e-3);  // onset 0.6, width 0.6, J 0.3
  const ocean::SurfaceFields calm = calm_sea(16);
  EXPECT_NEAR(surface_of(calm, 16.0).sample(1.0, 1.0, 0.1f).foam, 0.0, 1e-3);
  const std::vector<float> foam(std::size_t{16} * 16, 0.25f);
  const PreviewCascade cascade{16.0, &calm, foam};
  EXPECT_NEAR(PreviewSurface({&cascade, 1}, {}).sample(1.0, 1.0, 0.1f).foam, 0.25, 1e-3);
}

// Fails if fields of the wrong length reach the renderer, which reads them without checks.
TEST(PreviewSurface, BadInputIsRefused) {
  ocean::SurfaceFields fields = calm_sea(16);
  EXPECT_THROW(surface_of(fields, 0.0), Error);
  EXPECT_THROW(surface_of(calm_sea(12), 16.0), Error);
  fields.slope_z.pop_back();
  EXPECT_THROW(surface_of(fields, 16.0), Error);
  EXPECT_THROW(PreviewSurface({}, {}), Error);
}

// Fails if Gerstner waves are missing from the picture, stand elsewhere than in queries, alias in the
// distance or leave no roughness there. Near: rounding, 1e-6 of A. Far: all variance of slopes is hidden.
TEST(PreviewSurface, GerstnerWavesJoinTheCascades) {
  const ocean::SurfaceFields fields = calm_sea(16);
  const PreviewCascade cascade{32.0, &fields, {}};
  const ocean::TrochoidInstant waves({.waves = {{.amplitude_m = 1.2,
                                                 .wavenumber_radpm = 0.1,
                                                 .direction_rad = 0.5,
                                                 .omega_radps = 0.99,
                                                 .phase_rad = 2.0}},
                                      .choppiness = 0.8},
                                     7.0);
  const PreviewSurface surface({&cascade, 1}, {}, waves);
  for (const double x_m : {0.0, 33.3, 1e5}) {
    const ocean::TrochoidValues expected = waves.at(x_m, -20.0);
    const SurfaceSample near = surface.sample(x_m, -20.0, 0.1f);
    EXPECT_NEAR(near.displacement_x, expected.displacement_x_m, 1e-6);
    EXPECT_NEAR(near.displacement_y, expected.displacement_y_m, 1e-6);
    EXPECT_NEAR(near.displacement_z, expected.displacement_z_m, 1e-6);
    const double fxx = 1.0 + expected.gradient_xx, fxz = expected.gradient_xz,
                 fzz = 1.0 + expected.gradient_zz;
    EXPECT_NEAR(near.slope_x, (fzz * expected.slope_x - fxz * expected.slope_z) / (fxx * fzz - fxz * fxz),
                1e-6);
    EXPECT_NEAR(near.variance_xx, 0.0, 1e-9);
    const SurfaceSample far = surface.sample(x_m, -20.0, 200.0f);
    EXPECT_EQ(far.displacement_y, 0.0f);
    EXPECT_NEAR(far.variance_xx + far.variance_zz, 0.5 * 0.12 * 0.12, 1e-8);
  }
  EXPECT_NEAR(surface.largest_shift_m(), 0.96f, 1e-6f);
  EXPECT_NEAR(surface.elevation_deviation_m(), 1.2f / std::sqrt(2.0f), 1e-6f);
}

}  // namespace
}  // namespace offing::cli
