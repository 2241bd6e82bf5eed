#pragma once

#include <limits>
#include <numbers>

namespace offing::ocean {

/// Radians of a whole wave: the wavenumber is two_pi / wavelength.
inline constexpr double two_pi = 2.0 * std::numbers::pi;

/// Relation between wavenumber and frequency of linear water waves (O3 of docs/sources.md):
/// omega^2 = g k (1 + k^2 l^2) tanh(k D), l^2 = sigma / (rho g). Deep water is D = +inf, gravity waves l = 0.
struct Dispersion {
  double gravity_mps2 = 9.81;
  double depth_m = std::numeric_limits<double>::infinity();
  double capillary_length_m = 0.0;  ///< l; 2.73e-3 m for clean sea water

  /// omega(k), rad/s, for k >= 0 in rad/m.
  double omega_radps(double k_radpm) const;
  /// d omega / d k, m/s, for k > 0.
  double group_speed_mps(double k_radpm) const;
  /// The k > 0 with omega(k) = omega, to 1e-12 relative.
  double wavenumber_radpm(double omega_radps) const;
};

}  // namespace offing::ocean
