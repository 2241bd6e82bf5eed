#include "host/sky/direct_sunlight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offing::sky {
namespace {

/// Of the air above this height, in that of the sun in the zenith at sea level: the path's length (Kasten &
/// Young 1989) times the pressure (standard atmosphere).
double air_mass(double elevation_rad, double height_m) {
  const double elevation_deg = elevation_rad * 180.0 / std::numbers::pi;
  const double path = 1.0 / (std::sin(elevation_rad) + 0.50572 * std::pow(6.07995 + elevation_deg, -1.6364));
  const double pressure_pa =
      100.0 * std::pow(std::max(44331.514 - height_m, 0.0) / 11880.516, 1.0 / 0.1902632);
  return path * pressure_pa / 101325.0;
}

}  // namespace

double direct_sunlight_w_per_m2(double elevation_rad, double height_m, double distance_au,
                                double linke_turbidity) {
  if (elevation_rad <= 0.0) return 0.0;
  const double outside = solar_constant_w_per_m2 / (distance_au * distance_au);
  const double mass = air_mass(elevation_rad, height_m), haze = linke_turbidity - 1.0;
  const double f1 = std::exp(-height_m / 8000.0), f2 = std::exp(-height_m / 1250.0);
  const double beam = (0.664 + 0.163 / f1) * std::exp(-0.09 * mass * haze);
  // Of the light on level ground, which is the sun's and the sky's, not all is the sun's.
  const double level =
      (5.09e-5 * height_m + 0.868) * std::exp(-(3.92e-5 * height_m + 0.0387) * mass * (f1 + f2 * haze));
  const double most = level * (1.0 - (0.1 - 0.2 * std::exp(-linke_turbidity)) / (0.1 + 0.882 / f1));
  return outside * std::min(beam, most);
}

}  // namespace offing::sky
