#include "host/ocean/spectrum/spreading.h"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

constexpr double gravity_mps2 = 9.81;
constexpr SpreadingModel all_models[] = {SpreadingModel::cosine_2s, SpreadingModel::mitsuyasu,
                                         SpreadingModel::hasselmann, SpreadingModel::donelan_banner,
                                         SpreadingModel::phillips_cosine};

/// Integral of D e^(i n theta) over a turn by the rectangle rule.
std::complex<double> circular_moment(const DirectionalDensity& density, int order) {
  constexpr int count = 2880;
  std::complex<double> sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double theta_rad = 2.0 * pi * i / count;
    sum += density(theta_rad) * std::polar(1.0, order * theta_rad);
  }
  return sum * (2.0 * pi / count);
}

DirectionalDensity spreading_at(const SpreadingParameters& parameters, double ratio_to_peak,
                                double wind_speed_mps = 10.0) {
  const double omega_peak_radps = 1.0;
  return make_spreading(parameters, omega_peak_radps, wind_speed_mps, gravity_mps2)(ratio_to_peak);
}

TEST(Spreading, NormaliserOfCosine2s) {
  EXPECT_NEAR(cosine_2s_normaliser(0.0), 0.159155, 5e-7);
  EXPECT_NEAR(cosine_2s_normaliser(1.0), 0.318310, 5e-7);
  EXPECT_NEAR(cosine_2s_normaliser(10.0), 0.903278, 5e-7);
  EXPECT_NEAR(cosine_2s_normaliser(25.0), 1.417544, 5e-7);
  // sqrt(s / pi) / 2 (1 + 1 / 8s ...) where Gamma itself has long overflowed.
  EXPECT_NEAR(cosine_2s_normaliser(1000.0), 0.5 * std::sqrt(1000.0 / pi) * (1.0 + 1.0 / 8000.0), 1e-6);
}

/// Integral of D over a turn. Opposite the mean direction D may have a cusp |x|^2s: with x = pi v^4 on either
/// side the integrand is smooth in v, and midpoints are right to 1e-6 for the narrowest spreading.
double integral_over_turn(const DirectionalDensity& density, double direction_rad) {
  constexpr int count = 4000;
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double v = (i + 0.5) / count;
    const double from_opposite_rad = pi * std::pow(v, 4.0);
    const double weight_rad = 4.0 * pi * std::pow(v, 3.0) / count;
    sum += weight_rad * (density(direction_rad + pi - from_opposite_rad) +
                         density(direction_rad - pi + from_opposite_rad));
  }
  return sum;
}

// Gate 2e-6: the test's own error; a normaliser without its swell factor is off by percents.
TEST(Spreading, IntegratesToOneAtEveryFrequency) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const SpreadingModel model : all_models) {
    for (int i = 0; i < 60; ++i) {
      SpreadingParameters parameters;
      parameters.model = model;
      parameters.direction_rad = 20.0 * unit(random) - 10.0;
      parameters.exponent_s = std::pow(1000.0, unit(random)) - 1.0;
      parameters.swell = i % 3 == 0 ? 0.0 : unit(random);
      const double ratio = std::pow(10.0, 4.0 * unit(random) - 2.0);
      const double wind_mps = 1.0 + 40.0 * unit(random);
      const DirectionalDensity density = spreading_at(parameters, ratio, wind_mps);
      EXPECT_NEAR(integral_over_turn(density, parameters.direction_rad), 1.0, 2e-6)
          << "model " << static_cast<int>(model) << " ratio " << ratio << " swell " << parameters.swell;
    }
  }
}

// Fails if an angle is not reduced to a turn, or measured from the wrong side.
TEST(Spreading, PointsAlongItsDirection) {
  for (const SpreadingModel model : {SpreadingModel::cosine_2s, SpreadingModel::mitsuyasu,
                                     SpreadingModel::hasselmann, SpreadingModel::donelan_banner}) {
    for (const double direction_rad : {-3.0, 0.4, 2.0, 7.5}) {
      SpreadingParameters parameters;
      parameters.model = model;
      parameters.direction_rad = direction_rad;
      const std::complex<double> moment = circular_moment(spreading_at(parameters, 1.3), 1);
      EXPECT_NEAR(std::remainder(std::arg(moment) - direction_rad, 2.0 * pi), 0.0, 1e-9);
    }
  }
}

/// s of a cos^2s spreading from its first moment, s / (s + 1).
double exponent_of(const DirectionalDensity& density) {
  const double r1 = std::abs(circular_moment(density, 1));
  return r1 / (1.0 - r1);
}

// s at and around the peak from the papers' own constants. U10 omega_peak / g = 1.2 here.
TEST(Spreading, ExponentsOfMitsuyasuAndHasselmann) {
  const double wind_mps = 1.2 * gravity_mps2;
  SpreadingParameters parameters;
  parameters.model = SpreadingModel::mitsuyasu;
  const double peak = 11.5 * std::pow(1.2, -2.5);
  EXPECT_NEAR(exponent_of(spreading_at(parameters, 1.0, wind_mps)), peak, 1e-6);
  EXPECT_NEAR(exponent_of(spreading_at(parameters, 0.8, wind_mps)), peak * std::pow(0.8, 5.0), 1e-6);
  EXPECT_NEAR(exponent_of(spreading_at(parameters, 2.0, wind_mps)), peak * std::pow(2.0, -2.5), 1e-6);
  parameters.model = SpreadingModel::hasselmann;
  EXPECT_NEAR(exponent_of(spreading_at(parameters, 1.0, wind_mps)), 6.97, 1e-6);
  EXPECT_NEAR(exponent_of(spreading_at(parameters, 0.5, wind_mps)), 6.97 * std::pow(0.5, 4.06), 1e-6);
  EXPECT_NEAR(exponent_of(spreading_at(parameters, 2.0, wind_mps)), 9.77 * std::pow(2.0, -2.33 - 1.45 * 0.03),
              1e-6);
  // The wind of the spreading takes precedence over the spectrum's.
  parameters.wind_speed_mps = wind_mps;
  EXPECT_NEAR(exponent_of(spreading_at(parameters, 2.0, 30.0)), 9.77 * std::pow(2.0, -2.33 - 1.45 * 0.03),
              1e-6);
}

TEST(Spreading, DonelanBannerIsASquaredHyperbolicSecant) {
  SpreadingParameters parameters;
  parameters.model = SpreadingModel::donelan_banner;
  const auto shape = [&](double ratio, double angle_rad) {
    const DirectionalDensity density = spreading_at(parameters, ratio);
    return density(angle_rad) / density(0.0);
  };
  const auto secant2 = [](double x) { return 1.0 / (std::cosh(x) * std::cosh(x)); };
  EXPECT_NEAR(shape(1.0, 0.5), secant2(2.28 * 0.5), 1e-12);
  EXPECT_NEAR(shape(0.8, 0.5), secant2(2.61 * std::pow(0.8, 1.3) * 0.5), 1e-12);
  EXPECT_NEAR(shape(0.1, 0.5), shape(0.56, 0.5), 1e-12);
  // Far above the peak beta falls to 10^-0.4.
  EXPECT_NEAR(shape(1e4, 0.5), secant2(0.39811 * 0.5), 1e-4);
}

TEST(Spreading, PhillipsCosineIsTheSameAlongAndAgainst) {
  SpreadingParameters parameters;
  parameters.model = SpreadingModel::phillips_cosine;
  parameters.direction_rad = 0.7;
  const DirectionalDensity density = spreading_at(parameters, 1.0);
  EXPECT_NEAR(density(0.7), 1.0 / pi, 1e-12);
  EXPECT_NEAR(density(0.7 + pi), 1.0 / pi, 1e-12);
  EXPECT_NEAR(density(0.7 + 0.5 * pi), 0.0, 1e-12);
}

// Horvath's swell adds s = 16 tanh(omega_peak / omega) xi^2 to a cos^2s: at the peak, xi = 0.5, 3.0464.
TEST(Spreading, SwellNarrowsLongWaves) {
  SpreadingParameters parameters;
  parameters.model = SpreadingModel::cosine_2s;
  parameters.exponent_s = 5.0;
  parameters.swell = 0.5;
  EXPECT_NEAR(exponent_of(spreading_at(parameters, 1.0)), 5.0 + 4.0 * std::tanh(1.0), 1e-6);
  for (const SpreadingModel model : all_models) {
    parameters.model = model;
    parameters.swell = 0.0;
    const double plain = circular_moment(spreading_at(parameters, 0.9), 1).real();
    parameters.swell = 1.0;
    EXPECT_GT(circular_moment(spreading_at(parameters, 0.9), 1).real(), plain + 0.01);
  }
}

// A slow wind under a fast swell asks for exponents far beyond any data: the density must stay a number.
TEST(Spreading, ExtremeWaveAgesStayFinite) {
  for (const SpreadingModel model : all_models) {
    for (const double wind_mps : {0.1, 100.0}) {
      for (const double ratio : {1e-6, 1.0, 1e6}) {
        SpreadingParameters parameters;
        parameters.model = model;
        parameters.swell = 1.0;
        const DirectionalDensity density = spreading_at(parameters, ratio, wind_mps);
        for (const double angle_rad : {0.0, 1.0, pi, -pi}) {
          EXPECT_TRUE(std::isfinite(density(angle_rad)));
          EXPECT_GE(density(angle_rad), 0.0);
        }
      }
    }
  }
}

TEST(Spreading, RejectsValuesOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect_rejected = [](SpreadingParameters parameters, const std::string& name) {
    try {
      make_spreading(parameters, 1.0, 10.0, gravity_mps2);
      ADD_FAILURE() << name << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
      EXPECT_FALSE(error.hint().empty());
    }
  };
  SpreadingParameters parameters;
  parameters.exponent_s = -0.1;
  expect_rejected(parameters, "exponent_s");
  parameters = {};
  parameters.swell = 1.1;
  expect_rejected(parameters, "swell");
  parameters = {};
  parameters.direction_rad = nan;
  expect_rejected(parameters, "direction_rad");
  parameters = {};
  parameters.wind_speed_mps = 0.0;
  expect_rejected(parameters, "wind_speed_mps");
}

}  // namespace
}  // namespace offing::ocean
