#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/spectrum_parameters.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

constexpr double gravity_mps2 = 9.81;

SpectrumParameters model(SpectrumModel kind, double wind_speed_mps) {
  SpectrumParameters parameters;
  parameters.model = kind;
  parameters.wind_speed_mps = wind_speed_mps;
  return parameters;
}

double hs_m(const SpectrumParameters& parameters) {
  return integrate_sea_state(make_sea_spectrum(parameters)).hs_m;
}

// Pierson-Moskowitz is a g^2 omega^-5 exp(-B omega^-4), whose moments are Gamma functions: the integral over
// omega of omega^-n exp(-b omega^-4) is b^(-(n-1)/4) Gamma((n-1)/4) / 4. Gates 1e-5, the promise of
// integrate_sea_state(); Tm02 loses the tail of m2 above omega_max, 1.25 / (180^2 sqrt(1.25 pi)) = 2e-5 of
// it, half in the period.
TEST(SpectrumModels, PiersonMoskowitzInClosedForm) {
  const SeaSpectrum spectrum = make_sea_spectrum(model(SpectrumModel::pierson_moskowitz, 10.0));
  const SeaState state = integrate_sea_state(spectrum);
  const double b = 0.74 * std::pow(gravity_mps2 / 10.0, 4.0);
  const double m0 = 0.0081 * gravity_mps2 * gravity_mps2 / (4.0 * b);
  EXPECT_NEAR(state.m0_m2 / m0, 1.0, 1e-5);
  EXPECT_NEAR(state.tm01_s / (2.0 * pi / (std::pow(b, 0.25) * std::tgamma(0.75))), 1.0, 1e-5);
  EXPECT_NEAR(state.tm02_s / (2.0 * pi * std::pow(pi * b, -0.25)), 1.0, 3e-5);
  EXPECT_NEAR(state.tp_s / (2.0 * pi * std::tgamma(4.75) / std::tgamma(4.5) * std::pow(4.0 * b, -0.25)), 1.0,
              1e-5);
  EXPECT_NEAR(state.hs_m, 2.133, 0.001);
  EXPECT_NEAR(2.0 * pi / spectrum.omega_peak_radps, 7.30, 0.005);
  EXPECT_NEAR(state.tp_s, 6.96, 0.005);
  EXPECT_NEAR(state.hs_m, 0.20925 * 100.0 / gravity_mps2, 1e-4);
  EXPECT_NEAR(spectrum.omega_peak_radps, 0.8772 * gravity_mps2 / 10.0, 1e-4);
}

// Reference values within 1 %; they are met to all their digits.
TEST(SpectrumModels, Jonswap) {
  SpectrumParameters parameters = model(SpectrumModel::jonswap, 17.0);
  parameters.fetch_m = 300e3;
  EXPECT_NEAR(hs_m(parameters), 6.3103, 1e-3);
  EXPECT_NEAR(make_sea_spectrum(parameters).omega_peak_radps, 0.5857, 1e-4);
  parameters = model(SpectrumModel::jonswap, 10.0);
  parameters.fetch_m = 100e3;
  EXPECT_NEAR(hs_m(parameters), 2.1386, 1e-3);
  EXPECT_NEAR(make_sea_spectrum(parameters).omega_peak_radps, 1.00817, 1e-5);
  const double enhanced = hs_m(parameters);
  parameters.gamma = 1.0;
  const double plain = hs_m(parameters);
  EXPECT_NEAR(enhanced * enhanced / (plain * plain), 1.5249, 1e-3);
}

TEST(SpectrumModels, TmaInFourDepths) {
  SpectrumParameters parameters = model(SpectrumModel::tma, 15.0);
  parameters.fetch_m = 100e3;
  const double depths_m[] = {10.0, 20.0, 50.0, 1000.0};
  const double thompson_vincent_m[] = {2.195, 2.724, 3.050, 3.064};
  const double kitaigorodskii_m[] = {2.175, 2.709, 3.046, 3.064};
  for (int i = 0; i < 4; ++i) {
    parameters.dispersion.depth_m = depths_m[i];
    parameters.depth_factor = DepthFactor::thompson_vincent;
    EXPECT_NEAR(hs_m(parameters), thompson_vincent_m[i], 1e-3);
    parameters.depth_factor = DepthFactor::kitaigorodskii;
    EXPECT_NEAR(hs_m(parameters), kitaigorodskii_m[i], 1e-3);
  }
  parameters.dispersion.depth_m = std::numeric_limits<double>::infinity();
  const double deep_m = hs_m(parameters);
  parameters.model = SpectrumModel::jonswap;
  EXPECT_EQ(deep_m, hs_m(parameters));
}

// The exact factor in closed form is tanh^2(kD) / (1 + 2kD / sinh 2kD); an error in dk/domega shows here.
TEST(SpectrumModels, KitaigorodskiiInClosedForm) {
  SpectrumParameters parameters = model(SpectrumModel::tma, 15.0);
  parameters.dispersion.depth_m = 12.0;
  parameters.depth_factor = DepthFactor::kitaigorodskii;
  const SeaSpectrum shallow = make_sea_spectrum(parameters);
  parameters.model = SpectrumModel::jonswap;
  const SeaSpectrum deep = make_sea_spectrum(parameters);
  for (const double omega_radps : {0.4, 0.7, 1.0, 2.0}) {
    const double kd = 12.0 * parameters.dispersion.wavenumber_radpm(omega_radps);
    const double factor = std::pow(std::tanh(kd), 2.0) / (1.0 + 2.0 * kd / std::sinh(2.0 * kd));
    EXPECT_NEAR(shallow.energy(omega_radps) / deep.energy(omega_radps), factor, 1e-9);
  }
}

// The default constant gives Hs = 2 sqrt(alpha) U^2 / g = 0.18 U^2 / g; a constant of one's own scales m0.
TEST(SpectrumModels, PhillipsHeight) {
  SpectrumParameters parameters = model(SpectrumModel::phillips, 12.0);
  EXPECT_NEAR(hs_m(parameters) / (0.18 * 144.0 / gravity_mps2), 1.0, 1e-5);
  parameters.phillips_constant = 4.0 * 0.0081 / (2.0 * pi);
  EXPECT_NEAR(hs_m(parameters) / (0.36 * 144.0 / gravity_mps2), 1.0, 1e-5);
}

// P(K) = S (d omega / d k) / k must be the paper's A e^(-1 / (kL)^2) / k^4 |cos|^2 e^(-k^2 l^2), with the
// upwind factor behind the wind: fails if energy and spreading split the factors inconsistently.
TEST(SpectrumModels, PhillipsIsThePapersDensityOverTheWavenumberPlane) {
  SpectrumParameters parameters = model(SpectrumModel::phillips, 8.0);
  parameters.phillips_constant = 3e-3;
  parameters.phillips_cutoff_m = 0.05;
  parameters.phillips_upwind = 0.3;
  parameters.spreading.direction_rad = 2.5;
  const double length_m = 64.0 / gravity_mps2;
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const double depth_m : {5.0, std::numeric_limits<double>::infinity()}) {
    parameters.dispersion.depth_m = depth_m;
    const SeaSpectrum spectrum = make_sea_spectrum(parameters);
    for (int i = 0; i < 200; ++i) {
      const double k_radpm = std::pow(10.0, 2.0 * unit(random) - 1.0);
      const double theta_rad = 2.0 * pi * unit(random);
      const double cosine = std::cos(theta_rad - 2.5);
      const double expected = 3e-3 * std::exp(-std::pow(k_radpm * length_m, -2.0)) / std::pow(k_radpm, 4.0) *
                              cosine * cosine * std::exp(-std::pow(0.05 * k_radpm, 2.0)) *
                              (cosine < 0.0 ? 0.3 : 1.0);
      const double omega_radps = spectrum.dispersion.omega_radps(k_radpm);
      const double found =
          spectrum.density(omega_radps, theta_rad) * spectrum.dispersion.group_speed_mps(k_radpm) / k_radpm;
      EXPECT_NEAR(found, expected, 1e-9 * expected + 1e-300);
    }
  }
}

// Waves along the wind keep their variance when those against it are damped.
TEST(SpectrumModels, PhillipsUpwindDampingLowersTheEnergy) {
  SpectrumParameters parameters = model(SpectrumModel::phillips, 10.0);
  parameters.spreading.direction_rad = 1.0;
  const SeaState symmetric = integrate_sea_state(make_sea_spectrum(parameters));
  EXPECT_EQ(symmetric.mean_direction_rad, 0.0);
  parameters.phillips_upwind = 0.25;
  const SeaState damped = integrate_sea_state(make_sea_spectrum(parameters));
  EXPECT_NEAR(damped.m0_m2 / symmetric.m0_m2, 0.625, 1e-9);
  // Two kinks of D, where the wind's side ends, leave 1e-7 in the sum over directions.
  EXPECT_NEAR(damped.mean_direction_rad, 1.0, 1e-6);
}

// Mean square slope of a band: A pi / 2 (E1(1 / (k2 L)^2) - E1(1 / (k1 L)^2)), E1 the exponential integral.
TEST(SpectrumModels, PhillipsSlopeOfABand) {
  const SeaSpectrum spectrum = make_sea_spectrum(model(SpectrumModel::phillips, 10.0));
  const double length_m = 100.0 / gravity_mps2;
  const auto e1 = [](double x) { return -std::expint(-x); };
  const double k_min_radpm = 0.05, k_max_radpm = 6.0;
  const double expected =
      0.0081 / 4.0 *
      (e1(std::pow(k_max_radpm * length_m, -2.0)) - e1(std::pow(k_min_radpm * length_m, -2.0)));
  EXPECT_NEAR(integrate_sea_state(spectrum, k_min_radpm, k_max_radpm).mss / expected, 1.0, 1e-5);
}

TEST(SpectrumModels, SwellHasItsHeightPeriodAndDirection) {
  SpectrumParameters parameters = model(SpectrumModel::swell, 10.0);
  parameters.swell_hs_m = 2.5;
  parameters.swell_period_s = 14.0;
  parameters.spreading.direction_rad = 4.0;
  const SeaState state = integrate_sea_state(make_sea_spectrum(parameters));
  EXPECT_NEAR(state.hs_m, 2.5, 1e-5);
  EXPECT_NEAR(state.tm01_s, 14.0, 1e-3);
  // f^2 on average is f0^2 + sigma^2.
  EXPECT_NEAR(state.tm02_s, 1.0 / std::hypot(1.0 / 14.0, 0.005), 1e-3);
  EXPECT_NEAR(state.mean_direction_rad, 4.0, 1e-6);
  // Even a Gaussian so wide that it is cut at zero keeps its height.
  parameters.swell_bandwidth_hz = 0.4 / 14.0;
  EXPECT_NEAR(hs_m(parameters), 2.5, 1e-4);
}

// Bands that meet hold the whole, whatever kinks lie in them.
TEST(SpectrumModels, BandsAddUp) {
  for (const SpectrumModel kind : {SpectrumModel::phillips, SpectrumModel::pierson_moskowitz,
                                   SpectrumModel::jonswap, SpectrumModel::tma, SpectrumModel::swell}) {
    SpectrumParameters parameters = model(kind, 12.0);
    parameters.dispersion.depth_m = 30.0;
    const SeaSpectrum spectrum = make_sea_spectrum(parameters);
    const double whole = integrate_sea_state(spectrum).m0_m2;
    double sum = 0.0;
    double k_min_radpm = 0.0;
    for (const double k_max_radpm : {0.01, 0.03, 0.07, 0.4, 5.0, std::numeric_limits<double>::infinity()}) {
      sum += integrate_sea_state(spectrum, k_min_radpm, k_max_radpm).m0_m2;
      k_min_radpm = k_max_radpm;
    }
    EXPECT_NEAR(sum / whole, 1.0, 1e-6) << static_cast<int>(kind);
    EXPECT_EQ(integrate_sea_state(spectrum, 1e7, 1e8).hs_m, 0.0);
  }
}

// What lies outside the stated bounds is at most 2e-9 of m0, by trapezoidal sums over a decade on either
// side.
TEST(SpectrumModels, BoundsLeaveNothingOut) {
  for (const SpectrumModel kind : {SpectrumModel::phillips, SpectrumModel::pierson_moskowitz,
                                   SpectrumModel::jonswap, SpectrumModel::tma}) {
    SpectrumParameters parameters = model(kind, 12.0);
    parameters.dispersion.depth_m = 1000.0;
    const SeaSpectrum spectrum = make_sea_spectrum(parameters);
    double outside = 0.0;
    const double step = 1e-3;
    for (double decade = step; decade < 2.3; decade += step) {
      for (const double omega_radps :
           {spectrum.omega_min_radps * std::exp(-decade), spectrum.omega_max_radps * std::exp(decade)}) {
        outside += spectrum.energy(omega_radps) * omega_radps * step;
      }
    }
    EXPECT_LT(outside, 2e-9 * integrate_sea_state(spectrum).m0_m2) << static_cast<int>(kind);
  }
}

TEST(SpectrumModels, RejectsValuesOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  struct Case {
    const char* name;
    std::function<void(SpectrumParameters&)> spoil;
  };
  const Case cases[] = {
      {"wind_speed_mps", [=](SpectrumParameters& p) { p.wind_speed_mps = nan; }},
      {"wind_speed_mps", [=](SpectrumParameters& p) { p.wind_speed_mps = infinity; }},
      {"wind_speed_mps", [](SpectrumParameters& p) { p.wind_speed_mps = 0.0; }},
      {"fetch_m", [](SpectrumParameters& p) { p.fetch_m = -1.0; }},
      {"gamma", [](SpectrumParameters& p) { p.gamma = 0.5; }},
      {"depth_m", [](SpectrumParameters& p) { p.dispersion.depth_m = -5.0; }},
      {"gravity_mps2", [](SpectrumParameters& p) { p.dispersion.gravity_mps2 = 0.0; }},
      {"capillary_length_m", [](SpectrumParameters& p) { p.dispersion.capillary_length_m = -1.0; }},
      {"direction_rad", [=](SpectrumParameters& p) { p.spreading.direction_rad = -infinity; }},
      {"phillips_upwind",
       [](SpectrumParameters& p) { p.model = SpectrumModel::phillips, p.phillips_upwind = 1.5; }},
      {"phillips_cutoff_m",
       [](SpectrumParameters& p) { p.model = SpectrumModel::phillips, p.phillips_cutoff_m = 1e3; }},
      {"phillips_constant",
       [](SpectrumParameters& p) { p.model = SpectrumModel::phillips, p.phillips_constant = 0.0; }},
      {"swell_hs_m", [](SpectrumParameters& p) { p.model = SpectrumModel::swell, p.swell_hs_m = 0.0; }},
      {"swell_period_s",
       [=](SpectrumParameters& p) { p.model = SpectrumModel::swell, p.swell_period_s = nan; }},
      {"swell_bandwidth_hz",
       [](SpectrumParameters& p) { p.model = SpectrumModel::swell, p.swell_bandwidth_hz = 0.0; }},
      {"swell_exponent_s",
       [](SpectrumParameters& p) { p.model = SpectrumModel::swell, p.swell_exponent_s = -1.0; }},
  };
  for (const Case& spoilt : cases) {
    SpectrumParameters parameters;
    spoilt.spoil(parameters);
    try {
      make_sea_spectrum(parameters);
      ADD_FAILURE() << spoilt.name << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(std::string(error.what()).find(spoilt.name), std::string::npos) << error.what();
      EXPECT_FALSE(error.hint().empty());
    }
  }
  EXPECT_THROW(integrate_sea_state(make_sea_spectrum({}), 1.0, 0.5), Error);
}

}  // namespace
}  // namespace offing::ocean
