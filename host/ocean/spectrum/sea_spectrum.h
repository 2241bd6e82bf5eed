#pragma once

#include <complex>
#include <functional>
#include <limits>
#include <vector>

#include "host/ocean/spectrum/dispersion.h"

namespace offing::ocean {

/// D(theta) at one frequency, 1/rad, over directions of travel in rad; integrates to 1 over a full turn.
using DirectionalDensity = std::function<double(double direction_rad)>;

/// A directional sea: S(omega, theta) = E(omega) D(omega, theta), the one-sided variance density over
/// frequency and the full circle of directions of travel; m0 is its double integral (O5 of docs/sources.md).
/// Immutable; made by make_sea_spectrum() or from_measured().
struct SeaSpectrum {
  std::function<double(double omega_radps)> energy;  ///< E, m^2 s/rad
  /// D(omega, .) for one omega: what depends on omega alone is worked out once for a whole row of directions.
  std::function<DirectionalDensity(double omega_radps)> spreading_at;
  /// First circular moment of D(omega, .), integral of D e^(i theta) d theta, where it is known without that
  /// integral; may be empty. Of a measured record it is that of its listed directions: between them D is
  /// linear, which makes the moment of D itself smaller by sinc^2 of half their spacing.
  std::function<std::complex<double>(double omega_radps)> first_moment_at;
  double omega_min_radps = 0.0;  ///< E is 0 (or below 1e-9 of the total) outside [omega_min, omega_max]
  double omega_max_radps = 0.0;
  double omega_peak_radps = 0.0;  ///< where E is largest
  /// Frequencies where E has a kink, increasing; quadrature splits there. May be empty.
  std::vector<double> kinks_radps;
  Dispersion dispersion;

  /// D(omega, theta), 1/rad.
  double spreading(double omega_radps, double direction_rad) const {
    return spreading_at(omega_radps)(direction_rad);
  }
  /// S(omega, theta), m^2 s/rad^2.
  double density(double omega_radps, double direction_rad) const {
    return energy(omega_radps) * spreading(omega_radps, direction_rad);
  }
};

/// The figures of a sea state, integrated over a band of wavenumbers. All are 0 where the band holds no
/// energy.
struct SeaState {
  double m0_m2 = 0.0;
  double hs_m = 0.0;           ///< 4 sqrt(m0)
  double peak_period_s = 0.0;  ///< 1 / f where E(f) is largest
  double tp_s = 0.0;           ///< integral of E^4 df / integral of f E^4 df
  double tm01_s = 0.0;         ///< m0 / m1, moments over f in Hz
  double tm02_s = 0.0;         ///< sqrt(m0 / m2): Tz
  /// Of travel, 0 ... 2 pi, from the first circular moment of S; 0 where that vanishes, as for opposite seas
  /// of equal energy.
  double mean_direction_rad = 0.0;
  double peak_direction_rad = 0.0;  ///< the same of the waves at the peak period
  /// sqrt(2 (1 - r)), r the length of the first circular moment of S over m0 (Kuik, van Vledder and
  /// Holthuijsen 1988): the standard deviation of directions that spread little; sqrt(2) without a mean
  /// direction.
  double spread_rad = 0.0;
  double mss = 0.0;  ///< mean square slope, integral of k^2 S
};

/// Direction of the first circular moment (sum of E cos, sum of E sin) of energies with total m0, 0 ... 2 pi;
/// 0 when the moment is below 1e-9 m0, where its direction would be rounding noise.
double direction_of_moment(double cosine_m2, double sine_m2, double m0_m2);

/// The spread, rad, of energies with total m0 and this first circular moment.
double spread_of_moment(double cosine_m2, double sine_m2, double m0_m2);

/// Where E is largest between omega_min and omega_max, to 1e-7 of itself: the best of 1000 frequencies and of
/// the kinks, refined.
double find_peak_radps(const SeaSpectrum& spectrum);

/// Integrates the spectrum over k_min <= k < k_max, to 1e-5 relative. In a band without the
/// spectrum's peak, the peak is the largest of the integral's nodes. Throws Error(bad_input) unless
/// 0 <= k_min <= k_max.
SeaState integrate_sea_state(const SeaSpectrum& spectrum, double k_min_radpm = 0.0,
                             double k_max_radpm = std::numeric_limits<double>::infinity());

}  // namespace offing::ocean
