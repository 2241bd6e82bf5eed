#include "host/io/height_maps/ground_spacing.h"

#include <cmath>
#include <numbers>

namespace offing::height_maps {

DegreeLength degree_length(double latitude_deg, double equatorial_radius_m, double flattening) {
  constexpr double degree_rad = std::numbers::pi / 180.0;
  const double eccentricity_squared = flattening * (2.0 - flattening);
  const double sine = std::sin(latitude_deg * degree_rad);
  const double w = std::sqrt(1.0 - eccentricity_squared * sine * sine);
  const double prime_vertical_m = equatorial_radius_m / w;
  const double meridian_m = equatorial_radius_m * (1.0 - eccentricity_squared) / (w * w * w);
  return {prime_vertical_m * std::cos(latitude_deg * degree_rad) * degree_rad, meridian_m * degree_rad};
}

}  // namespace offing::height_maps
