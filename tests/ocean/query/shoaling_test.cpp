// What is left of waves over shoals, against linear theory worked out another way.
#include "host/ocean/query/shoaling.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/query/depth_map.h"
#include "tests/ocl/expect_error.h"

namespace offing::ocean {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double gravity_mps2 = 9.81;

double omega_radps(double k_radpm, double depth_m) {
  return std::sqrt(gravity_mps2 * k_radpm * std::tanh(std::min(k_radpm * depth_m, 40.0)));
}

/// The wavenumber of a frequency by bisection, which shares nothing with Dispersion's Newton steps.
double bisected_wavenumber_radpm(double omega, double depth_m) {
  double low = 0.0, high = 1e6;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (omega_radps(middle, depth_m) < omega ? low : high) = middle;
  }
  return low;
}

/// d omega / d k by a central difference.
double group_speed_mps(double k_radpm, double depth_m) {
  const double step = 1e-4 * k_radpm;
  return (omega_radps(k_radpm + step, depth_m) - omega_radps(k_radpm - step, depth_m)) / (2.0 * step);
}

double significant_height_m(const SeaBands& bands, const std::array<double, SHOAL_BANDS>& shares) {
  double variance_m2 = 0.0;
  for (std::size_t i = 0; i < SHOAL_BANDS; ++i) {
    variance_m2 += bands.bands[i].variance_m2 * shares[i] * shares[i];
  }
  return 4.0 * std::sqrt(variance_m2);
}

/// A sea with waves in two cascades and two bands of Gerstner waves.
SeaBands storm_bands() {
  SeaBands bands;
  bands.bands[0] = {.variance_m2 = 0.3, .wavenumber_radpm = 0.2};
  bands.bands[1] = {.variance_m2 = 0.05, .wavenumber_radpm = 1.5};
  bands.bands[4] = {.variance_m2 = 0.6, .wavenumber_radpm = 0.05};
  bands.bands[7] = {.variance_m2 = 0.2, .wavenumber_radpm = 0.1};
  return bands;
}

// Fails if shoaling is not that of conserved flux at a frequency that stays. The difference's own error is
// (1e-4 k)^2 / 6 times the third derivative of omega, of the order of omega / k^3: 1e-9. Measured 1.3e-9,
// gate 1e-7.
TEST(Shoaling, CoefficientIsThatOfConservedFlux) {
  for (const double sea_depth_m : {25.0, std::numeric_limits<double>::infinity()}) {
    for (const double k : {0.03, 0.3, 3.0}) {
      const double omega = omega_radps(k, sea_depth_m);
      for (const double depth_m : {0.05, 0.4, 2.0, 9.0, 24.0}) {
        const double there = bisected_wavenumber_radpm(omega, depth_m);
        const double expected = std::sqrt(group_speed_mps(k, sea_depth_m) / group_speed_mps(there, depth_m));
        EXPECT_NEAR(shoaling_coefficient({.depth_m = sea_depth_m}, k, depth_m), expected, 1e-7)
            << k << " " << depth_m;
      }
    }
  }
}

// Fails if energy is lost or gained on the way up a gentle slope before waves break: with a millimetre of a
// wave of 100 m the flux, share^2 cg, is that of the open sea down to 2 m. The table is linear between its
// rows, 1 / 255 of the root of the depth apart: off by an eighth of that squared times the second derivative,
// at 2 m 45 (of 0.45 s^-1/2): 9e-5, and breaking takes less. Measured 1.5e-4 of the flux, gate 4e-4.
TEST(Shoaling, KeepsTheFluxBeforeWavesBreak) {
  const double k = two_pi / 100.0, omega = omega_radps(k, 1e9), flux = group_speed_mps(k, 1e9);
  SeaBands bands;
  bands.bands[0] = {.variance_m2 = 1e-8, .wavenumber_radpm = k};
  const ShoalTable table({}, bands);
  double worst = 0.0;
  for (double depth_m = 2.0; depth_m < 150.0; depth_m *= 1.01) {
    const double share = table.at(depth_m)[0];
    const double there = bisected_wavenumber_radpm(omega, depth_m);
    worst = std::max(worst, std::abs(share * share * group_speed_mps(there, depth_m) / flux - 1.0));
  }
  RecordProperty("worst_e6", static_cast<int>(1e6 * worst));
  EXPECT_LT(worst, 4e-4);
}

// Fails if waves stand higher than they can in shallow water, or at a waterline or on land at all. The bound
// is strict but for the table: its shares are over those of the deepest depth, where breaking has taken 3e-4
// already, and between its rows they lie on a chord of a curve that bends upward near 0, by an eighth of the
// steps' square times the second derivative 2 breaking_share deepest: 0.3 mm here.
TEST(Shoaling, BreaksByTheDepth) {
  const ShoalTable table({}, storm_bands());
  for (const double depth_m : {-1e9, -3.0, -1e-6, 0.0}) {
    for (const double share : table.at(depth_m)) EXPECT_EQ(share, 0.0);
  }
  const double chord_m = 0.25 * breaking_share * table.deepest_m() / 255.0 / 255.0;
  for (double depth_m = 1e-3; depth_m < table.deepest_m(); depth_m *= 1.02) {
    EXPECT_LE(significant_height_m(table.bands(), table.at(depth_m)),
              1.0003 * (breaking_share * depth_m + chord_m));
  }
  // Where the sea would be five times as high as it can be, it is as high as it can be to 1 / (4 5^4).
  const double shallow_m = 4.29 / breaking_share / 5.0;
  EXPECT_GT(significant_height_m(table.bands(), table.at(shallow_m)), 0.99 * breaking_share * shallow_m);
}

// Fails if a step or a ring of higher water would show: the height changes by no more than breaking_share of
// the change of depth, and falls steadily from the place where waves break to the shore. In the table's first
// rows chords of the root are up to 9 % steeper 1 cm and more below the waterline: gate 15 %.
TEST(Shoaling, FallsSteadilyToTheShore) {
  const ShoalTable table({}, storm_bands());
  double before_m = 0.0;
  const double breaks_at_m = significant_height_m(table.bands(), table.at(1e9)) / breaking_share;
  for (double depth_m = 0.0; depth_m < 1.2 * table.deepest_m(); depth_m += 0.01) {
    const double height_m = significant_height_m(table.bands(), table.at(depth_m));
    if (depth_m < breaks_at_m) {
      EXPECT_GE(height_m, before_m);
    }
    EXPECT_LE(std::abs(height_m - before_m), 1.15 * 0.01 * breaking_share) << depth_m;
    before_m = height_m;
  }
}

// Fails if the open sea is not left as it is, or a sea is taken to be deeper than it is.
TEST(Shoaling, LeavesTheOpenSea) {
  for (const double sea_depth_m : {5.0, std::numeric_limits<double>::infinity()}) {
    const ShoalTable table({.depth_m = sea_depth_m}, storm_bands());
    EXPECT_LE(table.deepest_m(), sea_depth_m);
    EXPECT_LE(table.deepest_m(), two_pi / 0.05 + 1e-9);
    for (const double depth_m : {table.deepest_m(), 1e4}) {
      for (const double share : table.at(depth_m)) EXPECT_NEAR(share, 1.0, 1e-7);
    }
    EXPECT_GE(table.largest_share(), 1.0);
  }
}

// Fails if a band is not as long as the mean of its energy, or a wave is counted in two or none.
TEST(Shoaling, BandsHoldAllWaves) {
  std::vector<float> modes(16 * 16);
  modes[1] = 3.0f, modes[15] = 1.0f, modes[4 * 16] = 4.0f;  // n = 1, -1 along x; 4 along z
  const ShoalingBand band = band_of_modes(modes, 16, two_pi);
  EXPECT_DOUBLE_EQ(band.variance_m2, 8.0);
  EXPECT_DOUBLE_EQ(band.wavenumber_radpm, (3.0 + 1.0 + 4.0 * 4.0) / 8.0);

  std::vector<GerstnerWave> waves;
  double variance_m2 = 0.0;
  for (int i = 0; i < 20; ++i) {
    waves.push_back({.amplitude_m = 0.1 + 0.01 * i, .wavenumber_radpm = 0.02 * std::pow(1.15, i)});
    variance_m2 += 0.5 * waves.back().amplitude_m * waves.back().amplitude_m;
  }
  const SeaBands bands = shoaling_bands(std::array{band}, waves);
  EXPECT_EQ(bands.bands[0].variance_m2, 8.0);
  EXPECT_EQ(bands.bands[1].variance_m2, 0.0);
  double sum_m2 = 0.0, before_radpm = 0.0;
  for (std::size_t i = SHOAL_FIRST_GERSTNER; i < SHOAL_BANDS; ++i) {
    sum_m2 += bands.bands[i].variance_m2;
    EXPECT_GT(bands.bands[i].wavenumber_radpm, before_radpm);
    before_radpm = bands.bands[i].wavenumber_radpm;
  }
  EXPECT_NEAR(sum_m2, variance_m2, 1e-12);
  EXPECT_EQ(bands.gerstner_band(0.0), 0);
  EXPECT_EQ(bands.gerstner_band(1e3), 3);
  // Waves of one length are one band.
  const std::vector<GerstnerWave> alike(3, {.amplitude_m = 1.0, .wavenumber_radpm = 0.1});
  const SeaBands one = shoaling_bands({}, alike);
  EXPECT_EQ(one.gerstner_band(0.1), 0);
  EXPECT_DOUBLE_EQ(one.bands[SHOAL_FIRST_GERSTNER].variance_m2, 1.5);
}

DepthMap plane(double by_x, double by_z) {
  DepthMap map{.columns = 20,
               .rows = 15,
               .origin_x_m = -40.0,
               .origin_z_m = 7.0,
               .spacing_x_m = 5.0,
               .spacing_z_m = 8.0,
               .depths_m = {}};
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      map.depths_m.push_back(static_cast<float>(3.0 + by_x * 5.0 * column + by_z * 8.0 * row));
    }
  }
  return map;
}

// Fails if depths are read at another place, or a step stands at the map's edge.
TEST(DepthMap, IsBilinearAndGoesOnBeyondItsEdge) {
  const DepthMap map = plane(0.1, -0.03);
  EXPECT_NEAR(map.depth_m(-40.0, 7.0), 3.0, 1e-6);
  EXPECT_NEAR(map.depth_m(13.1, 52.7), 3.0 + 0.1 * 53.1 - 0.03 * 45.7, 1e-5);
  const double edge_m = 3.0 + 0.1 * 95.0 - 0.03 * 45.7;
  EXPECT_NEAR(map.depth_m(55.0, 52.7), edge_m, 1e-5);
  EXPECT_NEAR(map.depth_m(59.0, 52.7), edge_m + 4.0 * SHOAL_STEEPEST, 1e-5);
  EXPECT_NEAR(map.depth_m(-43.0, 3.0), 3.0 + 5.0 * SHOAL_STEEPEST, 1e-5);
  EXPECT_EQ(map.shallowest_m(), *std::min_element(map.depths_m.begin(), map.depths_m.end()));
}

// Fails if a cliff stays one, a gentle bed is changed, or the limited bed lies below the true one.
TEST(DepthMap, LimitsSlopes) {
  DepthMap gentle = plane(0.2, 0.3);
  const DepthMap as_it_was = gentle;
  limit_slopes(gentle);
  EXPECT_EQ(gentle.depths_m, as_it_was.depths_m);
  DepthMap cliff = plane(0.0, 0.0);
  const std::size_t rock = 7 * 20 + 9;
  cliff.depths_m[rock] = -2.0f;
  limit_slopes(cliff);
  EXPECT_EQ(cliff.depths_m[rock], -2.0f);
  EXPECT_FLOAT_EQ(cliff.depths_m[rock + 1], -2.0f + 2.5f);
  EXPECT_FLOAT_EQ(cliff.depths_m[rock + 20], -2.0f + 4.0f);
  EXPECT_FLOAT_EQ(cliff.depths_m[rock - 20 - 1], std::min(3.0f, -2.0f + 0.5f * std::hypot(5.0f, 8.0f)));
  EXPECT_FLOAT_EQ(cliff.depths_m[rock - 3], 3.0f);
}

// Fails if a map that cannot be read is taken.
TEST(DepthMap, RefusesWhatIsNoMap) {
  DepthMap map = plane(0.1, 0.1);
  map.depths_m.pop_back();
  test::expect_error(ErrorKind::bad_input, "expected 15 x 20 depths", [&] { require_valid_depths(map); });
  map = plane(0.1, 0.1);
  map.depths_m[5] = std::numeric_limits<float>::quiet_NaN();
  test::expect_error(ErrorKind::bad_input, "finite", [&] { require_valid_depths(map); });
  map = plane(0.1, 0.1);
  map.columns = 1;
  test::expect_error(ErrorKind::bad_input, "columns", [&] { require_valid_depths(map); });
}

}  // namespace
}  // namespace offing::ocean
