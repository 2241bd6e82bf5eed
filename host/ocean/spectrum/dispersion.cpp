#include "host/ocean/spectrum/dispersion.h"

#include <algorithm>
#include <cmath>

namespace offing::ocean {
namespace {

// tanh(q) is 1 and 2q / sinh(2q) is 0 in double precision from here on; clamping also keeps sinh finite.
constexpr double deep_water_kd = 40.0;

double clamped_kd(const Dispersion& dispersion, double k_radpm) {
  return std::min(k_radpm * dispersion.depth_m, deep_water_kd);
}

double capillary_term(const Dispersion& dispersion, double k_radpm) {
  const double kl = k_radpm * dispersion.capillary_length_m;
  return kl * kl;
}

// d ln(omega^2) / d ln k: between 1 (shallow) and 4 (deep capillary waves).
double logarithmic_slope(const Dispersion& dispersion, double k_radpm) {
  const double kd = clamped_kd(dispersion, k_radpm);
  const double capillary = capillary_term(dispersion, k_radpm);
  return 1.0 + 2.0 * capillary / (1.0 + capillary) + 2.0 * kd / std::sinh(2.0 * kd);
}

}  // namespace

double Dispersion::omega_radps(double k_radpm) const {
  if (k_radpm <= 0.0) {
    return 0.0;
  }
  return std::sqrt(gravity_mps2 * k_radpm * (1.0 + capillary_term(*this, k_radpm)) *
                   std::tanh(clamped_kd(*this, k_radpm)));
}

double Dispersion::group_speed_mps(double k_radpm) const {
  return 0.5 * omega_radps(k_radpm) / k_radpm * logarithmic_slope(*this, k_radpm);
}

double Dispersion::wavenumber_radpm(double omega_radps) const {
  if (omega_radps <= 0.0) {
    return 0.0;
  }
  // Newton in ln k on ln(omega^2): its slope stays within 1 ... 4, so that steps cannot run away. Gravity
  // waves have at least the wavenumber of either limit, deep or shallow.
  const double deep = omega_radps * omega_radps / gravity_mps2;
  const double shallow = omega_radps / std::sqrt(gravity_mps2 * depth_m);
  double k_radpm = std::max(deep, shallow);
  constexpr int most_steps = 50;
  for (int step = 0; step < most_steps; ++step) {
    const double excess = 2.0 * std::log(this->omega_radps(k_radpm) / omega_radps);
    const double change = excess / logarithmic_slope(*this, k_radpm);
    k_radpm *= std::exp(-change);
    // Convergence is quadratic: a step of 1e-8 leaves an error far below the promised 1e-12.
    if (std::abs(change) < 1e-8) {
      break;
    }
  }
  return k_radpm;
}

}  // namespace offing::ocean
