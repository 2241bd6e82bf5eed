#include "tests/sky/sky_reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offing::sky {
namespace {

using std::numbers::pi;

// Nodes of a ray: distances grow as the square of a parameter, so that the air near the beginning is met in
// small steps. Midpoint rule in that parameter.
constexpr int steps = 1200;

template <class Take>
void walk(double length_m, Take take) {
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) / steps;
    take(length_m * u * u, length_m * 2.0 * u / steps);
  }
}

}  // namespace

double rayleigh_phase(double cosine) {
  return 0.75 * (1.0 + cosine * cosine) / (4.0 * pi);
}

double aerosol_phase(double asymmetry, double cosine) {
  const double g = asymmetry;
  return 1.5 / (4.0 * pi) * (1.0 - g * g) / (2.0 + g * g) * (1.0 + cosine * cosine) *
         std::pow(1.0 + g * g - 2.0 * g * cosine, -1.5);
}

SkyReference::Coefficients SkyReference::at_altitude(double altitude_m) const {
  Coefficients here;
  const double rayleigh = std::exp(-altitude_m / a_.rayleigh_scale_height_m) / a_.rayleigh_scale_height_m;
  const double aerosol = a_.aerosol_optical_depth * std::exp(-altitude_m / a_.aerosol_scale_height_m) /
                         a_.aerosol_scale_height_m;
  const double ozone = std::max(0.0, 1.0 - std::abs(altitude_m - a_.ozone_peak_m) / a_.ozone_half_width_m) /
                       a_.ozone_half_width_m;
  here.aerosol_perm = aerosol * a_.aerosol_albedo;
  for (std::size_t i = 0; i < 4; ++i) {
    here.rayleigh_perm[i] = rayleigh * a_.rayleigh_optical_depth[i];
    here.extinction_perm[i] = here.rayleigh_perm[i] + aerosol + ozone * a_.ozone_optical_depth[i];
  }
  return here;
}

SkyReference::End SkyReference::end_of(double altitude_m, double cosine) const {
  const double r = a_.ground_radius_m + altitude_m;
  const double nearest2 = r * r * (1.0 - cosine * cosine);
  const double ground2 = a_.ground_radius_m * a_.ground_radius_m;
  if (cosine < 0.0 && nearest2 < ground2) return {-r * cosine - std::sqrt(ground2 - nearest2), true};
  const double top = a_.ground_radius_m + a_.thickness_m;
  return {-r * cosine + std::sqrt(top * top - nearest2), false};
}

double SkyReference::altitude_m(double altitude_m, double cosine, double distance_m) const {
  const double r = a_.ground_radius_m + altitude_m;
  return std::hypot(r * std::sqrt(1.0 - cosine * cosine), r * cosine + distance_m) - a_.ground_radius_m;
}

Spectrum SkyReference::transmittance(double altitude_m, double cosine) const {
  Spectrum depth{};
  // A ray that dips is walked both ways from its lowest point, where the air is densest.
  const double r = a_.ground_radius_m + altitude_m;
  const double to_lowest_m = std::max(0.0, -r * cosine);
  const double lowest_m = this->altitude_m(altitude_m, cosine, to_lowest_m);
  const double lowest_cosine = cosine < 0.0 ? 0.0 : cosine;
  const auto add = [&](double length_m) {
    walk(length_m, [&](double distance_m, double step_m) {
      const Coefficients here = at_altitude(this->altitude_m(lowest_m, lowest_cosine, distance_m));
      for (std::size_t i = 0; i < 4; ++i) depth[i] += here.extinction_perm[i] * step_m;
    });
  };
  add(end_of(lowest_m, lowest_cosine).distance_m);
  if (to_lowest_m > 0.0) add(to_lowest_m);
  Spectrum share{};
  for (std::size_t i = 0; i < 4; ++i) share[i] = std::exp(-depth[i]);
  return share;
}

Spectrum SkyReference::sunlight(double altitude_m, double sun_cosine) const {
  const double sine = a_.ground_radius_m / (a_.ground_radius_m + altitude_m);
  const double horizon = -std::sqrt(1.0 - sine * sine);
  const double half_disc = a_.sun_angular_radius_rad * sine;
  const double t = std::clamp((sun_cosine - horizon) / (2.0 * half_disc) + 0.5, 0.0, 1.0);
  const double visible = t * t * (3.0 - 2.0 * t);
  if (visible == 0.0) return {};
  Spectrum light = transmittance(altitude_m, std::max(sun_cosine, horizon));
  for (double& share : light) share *= visible;
  return light;
}

Spectrum SkyReference::scattered_once(double eye_altitude_m, double cosine, double sun_cosine,
                                      double between) const {
  Spectrum light{}, depth{};
  const double length_m = end_of(eye_altitude_m, cosine).distance_m;
  const double r = a_.ground_radius_m + eye_altitude_m;
  walk(length_m, [&](double distance_m, double step_m) {
    const double here_m = altitude_m(eye_altitude_m, cosine, distance_m);
    const Coefficients here = at_altitude(here_m);
    const Spectrum sun =
        sunlight(here_m, (r * sun_cosine + distance_m * between) / (a_.ground_radius_m + here_m));
    for (std::size_t i = 0; i < 4; ++i) {
      depth[i] += 0.5 * here.extinction_perm[i] * step_m;
      light[i] += std::exp(-depth[i]) * step_m * sun[i] *
                  (here.rayleigh_perm[i] * rayleigh_phase(between) +
                   here.aerosol_perm * aerosol_phase(a_.aerosol_asymmetry, between));
      depth[i] += 0.5 * here.extinction_perm[i] * step_m;
    }
  });
  return light;
}

}  // namespace offing::sky
