#pragma once

#include <limits>

namespace offing::terrain {

/// How the Earth falls away below a level line, less what refraction bends light after it: at a distance d by
/// bend_perm() d^2, in plan, where d is small beside the radius.
struct EarthCurve {
  double radius_m = std::numeric_limits<double>::infinity();  ///< infinite: flat
  /// Radius of the Earth over that of a ray of light, 0 ... 1.
  double refraction = 0.0;

  double bend_perm() const { return (1.0 - refraction) / (2.0 * radius_m); }
};

/// The mean radius (2 a + b) / 3 of WGS 84.
inline constexpr double earth_radius_m = 6'371'008.8;
/// Of light near the ground by day, as surveyors take it (Gauss).
inline constexpr double light_refraction = 0.13;

/// Throws Error(bad_input) unless radius_m is at least 1000 m and refraction within 0 ... 1.
void require_valid(const EarthCurve& curve);

}  // namespace offing::terrain
