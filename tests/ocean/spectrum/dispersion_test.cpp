#include "host/ocean/spectrum/dispersion.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace offing::ocean {
namespace {

using std::numbers::pi;

// l of clean sea water: sigma 0.0747 N/m, rho 1025 kg/m^3.
constexpr double sea_water_capillary_m = 2.7264e-3;

TEST(Dispersion, DeepWaterIsTheSquareRootOfGravityTimesWavenumber) {
  const Dispersion deep;
  EXPECT_DOUBLE_EQ(deep.omega_radps(0.1), std::sqrt(0.981));
  EXPECT_DOUBLE_EQ(deep.wavenumber_radpm(std::sqrt(0.981)), 0.1);
}

// Fails if depth enters anywhere but in tanh(kD): the textbook 10 s wave on 10 m of water is 92.4 m long,
// from q tanh q = omega^2 D / g = 0.4024, q = 0.6803, solved by hand.
TEST(Dispersion, TenSecondWaveOnTenMetres) {
  const Dispersion shelf{.depth_m = 10.0};
  EXPECT_NEAR(2.0 * pi / shelf.wavenumber_radpm(2.0 * pi / 10.0), 92.37, 0.05);
}

// omega = k sqrt(g D) (1 - (kD)^2 / 6 + ...): the next term is 19 (kD)^4 / 360.
TEST(Dispersion, ShallowWaterIsNotDispersive) {
  const Dispersion shallow{.depth_m = 2.0};
  const double k_radpm = 0.01;
  const double kd = k_radpm * 2.0;
  EXPECT_NEAR(shallow.omega_radps(k_radpm) / (k_radpm * std::sqrt(9.81 * 2.0)), 1.0 - kd * kd / 6.0, 1e-8);
}

// The slowest wave of sea water: 0.2313 m/s at 1.713 cm (k l = 1, c^2 = 2 g l). Fails if the capillary term
// lacks a factor.
TEST(Dispersion, CapillaryMinimum) {
  const Dispersion ripples{.capillary_length_m = sea_water_capillary_m};
  double slowest_mps = std::numeric_limits<double>::infinity();
  double slowest_length_m = 0.0;
  for (double length_m = 0.005; length_m < 0.05; length_m += 1e-6) {
    const double k_radpm = 2.0 * pi / length_m;
    const double speed_mps = ripples.omega_radps(k_radpm) / k_radpm;
    if (speed_mps < slowest_mps) {
      slowest_mps = speed_mps;
      slowest_length_m = length_m;
    }
  }
  EXPECT_NEAR(slowest_mps, 0.2313, 5e-5);
  EXPECT_NEAR(slowest_length_m, 0.01713, 1e-5);
}

/// Random water: depth 0.1 m ... 10 km or infinite, with and without capillarity.
Dispersion random_water(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Dispersion water;
  if (unit(random) < 0.7) {
    water.depth_m = std::pow(10.0, -1.0 + 5.0 * unit(random));
  }
  if (unit(random) < 0.5) {
    water.capillary_length_m = sea_water_capillary_m;
  }
  return water;
}

// Gate 1e-12 is the promise; omega itself carries a few ulp, of which shallow water passes on all and deep
// half.
TEST(Dispersion, WavenumberInvertsOmega) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-7.0, 5.0);
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const Dispersion water = random_water(random);
    const double k_radpm = std::pow(10.0, exponent(random));
    worst = std::max(worst, std::abs(water.wavenumber_radpm(water.omega_radps(k_radpm)) / k_radpm - 1.0));
  }
  EXPECT_LT(worst, 1e-12);
}

// Central difference in ln k with step 1e-4: its error is step^2 / 6 times a third derivative of order 1,
// 2e-9, plus rounding of 1e-16 / 1e-4.
TEST(Dispersion, GroupSpeedIsTheDerivativeOfOmega) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> exponent(-5.0, 4.0);
  for (int i = 0; i < 2000; ++i) {
    const Dispersion water = random_water(random);
    const double k_radpm = std::pow(10.0, exponent(random));
    const double up = water.omega_radps(k_radpm * std::exp(1e-4));
    const double down = water.omega_radps(k_radpm * std::exp(-1e-4));
    EXPECT_NEAR(water.group_speed_mps(k_radpm) * k_radpm / ((up - down) / 2e-4), 1.0, 1e-7);
  }
}

// sinh overflows for kD > 710 and inf * 0 is not a number: both must be clamped away.
TEST(Dispersion, ExtremesStayFinite) {
  for (const double depth_m : {0.1, 1e4, std::numeric_limits<double>::infinity()}) {
    const Dispersion water{.depth_m = depth_m};
    EXPECT_EQ(water.omega_radps(0.0), 0.0);
    EXPECT_EQ(water.wavenumber_radpm(0.0), 0.0);
    for (const double k_radpm : {1e-12, 1e-3, 1e6, 1e9}) {
      EXPECT_TRUE(std::isfinite(water.omega_radps(k_radpm)));
      EXPECT_TRUE(std::isfinite(water.group_speed_mps(k_radpm)));
      EXPECT_GT(water.group_speed_mps(k_radpm), 0.0);
    }
  }
}

}  // namespace
}  // namespace offing::ocean
