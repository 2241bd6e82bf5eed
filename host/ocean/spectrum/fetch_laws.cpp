#include "host/ocean/spectrum/fetch_laws.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offing::ocean {
namespace {

double variance_of_height_m2(double hs_m) {
  return hs_m * hs_m / 16.0;
}

}  // namespace

double wind_of_height_and_period_mps(double hs_m, double peak_period_s, double gravity_mps2) {
  const double omega_peak_radps = 2.0 * std::numbers::pi / peak_period_s;
  const double wind_mps = variance_of_height_m2(hs_m) * std::pow(omega_peak_radps, 3.0) /
                          (1.6e-7 * 22.0 * 22.0 * 22.0 * gravity_mps2);
  return std::clamp(wind_mps, 0.1, 100.0);
}

double developed_peak_period_s(double hs_m, double gravity_mps2) {
  constexpr double alpha = 0.0081;
  return 2.0 * std::numbers::pi *
         std::pow(5.0 * variance_of_height_m2(hs_m) / (alpha * gravity_mps2 * gravity_mps2), 0.25);
}

}  // namespace offing::ocean
