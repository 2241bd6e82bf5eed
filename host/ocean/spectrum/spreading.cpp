#include "host/ocean/spectrum/spreading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/ocean/ocean_limits.h"
#include "host/ocean/spectrum/quadrature.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

// Wave-age formulas give absurdly narrow seas far outside the data that they were fitted to.
constexpr double largest_exponent = 1000.0;

// cos^2s(angle / 2); the half-angle formula keeps the base within [0, 1].
double cosine_2s(double angle_rad, double exponent_s) {
  return std::pow(0.5 + 0.5 * std::cos(angle_rad), exponent_s);
}

double hyperbolic_secant_squared(double x) {
  const double cosh_x = std::cosh(x);
  return 1.0 / (cosh_x * cosh_x);
}

double mitsuyasu_exponent(double ratio, double inverse_wave_age) {
  const double peak = 11.5 * std::pow(inverse_wave_age, -2.5);
  return peak * std::pow(ratio, ratio <= 1.0 ? 5.0 : -2.5);
}

// Below 1.05 peak frequencies the exponent rises, above it falls, faster for younger waves.
double hasselmann_exponent(double ratio, double inverse_wave_age) {
  if (ratio < 1.05) {
    return 6.97 * std::pow(ratio, 4.06);
  }
  return 9.77 * std::pow(ratio, -2.33 - 1.45 * (inverse_wave_age - 1.17));
}

double donelan_banner_beta(double ratio) {
  if (ratio < 0.95) {
    // The fit begins at 0.56 peak frequencies; below it, as there.
    return 2.61 * std::pow(std::max(ratio, 0.56), 1.3);
  }
  if (ratio < 1.6) {
    return 2.28 * std::pow(ratio, -1.3);
  }
  return std::pow(10.0, -0.4 + 0.8393 * std::exp(-0.567 * std::log(ratio * ratio)));
}

// 1 / integral of sech^2(beta theta) cos^2s(theta / 2) over a turn. Without the second factor the integral is
// 2 tanh(pi beta) / beta. With it there is a cusp |x|^2s opposite the mean direction, which the substitution
// theta = pi (1 - v^2) softens; sech^2 varies on scales above 1 / beta, which the panels resolve.
double donelan_banner_normaliser(double beta, double exponent_s) {
  if (exponent_s == 0.0) {
    return 0.5 * beta / std::tanh(pi * beta);
  }
  constexpr int panels = 8;
  double half_integral = 0.0;
  for (int panel = 0; panel < panels; ++panel) {
    for_each_gauss_node(1.0 * panel / panels, (panel + 1.0) / panels, [&](double v, double weight) {
      const double angle_rad = pi * (1.0 - v * v);
      half_integral += weight * 2.0 * pi * v * hyperbolic_secant_squared(beta * angle_rad) *
                       cosine_2s(angle_rad, exponent_s);
    });
  }
  return 0.5 / half_integral;
}

// 1 / integral of cos^2(theta) cos^2s(theta / 2) over a turn, from the second circular moment of cos^2s,
// s (s - 1) / ((s + 1) (s + 2)).
double phillips_normaliser(double exponent_s) {
  const double second_moment = exponent_s * (exponent_s - 1.0) / ((exponent_s + 1.0) * (exponent_s + 2.0));
  return cosine_2s_normaliser(exponent_s) / (0.5 + 0.5 * second_moment);
}

struct ModelledSpreading {
  SpreadingParameters parameters;
  double omega_peak_radps;
  double inverse_wave_age;  // U10 omega_peak / g

  DirectionalDensity operator()(double omega_radps) const {
    const double ratio = omega_radps / omega_peak_radps;
    const double direction_rad = parameters.direction_rad;
    const double swell_exponent =
        16.0 * std::tanh(1.0 / std::max(ratio, 1e-6)) * parameters.swell * parameters.swell;
    switch (parameters.model) {
      case SpreadingModel::donelan_banner: {
        const double beta = donelan_banner_beta(ratio);
        const double normaliser = donelan_banner_normaliser(beta, swell_exponent);
        return [=](double theta_rad) {
          const double angle_rad = std::remainder(theta_rad - direction_rad, 2.0 * pi);
          const double elongation = swell_exponent == 0.0 ? 1.0 : cosine_2s(angle_rad, swell_exponent);
          return normaliser * hyperbolic_secant_squared(beta * angle_rad) * elongation;
        };
      }
      case SpreadingModel::phillips_cosine: {
        const double normaliser = phillips_normaliser(swell_exponent);
        return [=](double theta_rad) {
          const double cosine = std::cos(theta_rad - direction_rad);
          return normaliser * cosine * cosine * std::pow(0.5 + 0.5 * cosine, swell_exponent);
        };
      }
      default: {
        const double exponent = std::min(base_exponent(ratio) + swell_exponent, largest_exponent);
        const double normaliser = cosine_2s_normaliser(exponent);
        return [=](double theta_rad) { return normaliser * cosine_2s(theta_rad - direction_rad, exponent); };
      }
    }
  }

  double base_exponent(double ratio) const {
    switch (parameters.model) {
      case SpreadingModel::mitsuyasu:
        return mitsuyasu_exponent(ratio, inverse_wave_age);
      case SpreadingModel::hasselmann:
        return hasselmann_exponent(ratio, inverse_wave_age);
      default:
        return parameters.exponent_s;
    }
  }
};

}  // namespace

double cosine_2s_normaliser(double exponent_s) {
  // By logarithms: Gamma itself overflows from s = 171 on. std::lgamma() would write a variable of all
  // threads.
  int sign = 0;
  return std::exp(lgamma_r(exponent_s + 1.0, &sign) - lgamma_r(exponent_s + 0.5, &sign)) /
         (2.0 * std::sqrt(pi));
}

double exponent_of_spread(double spread_rad) {
  return std::max(2.0 / (spread_rad * spread_rad) - 1.0, 0.0);
}

std::function<DirectionalDensity(double)> make_spreading(const SpreadingParameters& parameters,
                                                         double omega_peak_radps, double wind_speed_mps,
                                                         double gravity_mps2) {
  require_within("spreading.direction_rad", parameters.direction_rad, -1e6, 1e6);
  require_within("spreading.exponent_s", parameters.exponent_s, 0.0, largest_exponent);
  require_within("spreading.swell", parameters.swell, 0.0, 1.0);
  const double speed_mps = parameters.wind_speed_mps.value_or(wind_speed_mps);
  require_within("spreading.wind_speed_mps", speed_mps, 0.1, 100.0);
  return ModelledSpreading{parameters, omega_peak_radps, speed_mps * omega_peak_radps / gravity_mps2};
}

}  // namespace offing::ocean
