#include "tests/sky/sky_reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offing::sky {
namespace {

using std::numbers::pi;

// Midpoint rule in the root of the distance, so that the air near the beginning is met in small steps.
template <class Take>
void walk(double length_m, int steps, Take take) {
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) / steps;
    take(length_m * u * u, length_m * 2.0 * u / steps);
  }
}
constexpr int depth_steps = 160, light_steps = 400, mean_steps = 80;

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
  return {-r * cosine + std::sqrt(std::max(0.0, top * top - nearest2)), false};
}

double SkyReference::altitude_after(double altitude_m, double cosine, double distance_m) const {
  const double r = a_.ground_radius_m + altitude_m;
  const double across2 = r * r * std::max(0.0, 1.0 - cosine * cosine);
  const double along = r * cosine + distance_m;
  return std::sqrt(across2 + along * along) - a_.ground_radius_m;
}

Spectrum SkyReference::transmittance(double altitude_m, double cosine) const {
  Spectrum depth{};
  // A ray that dips is walked both ways from its lowest point, where the air is densest.
  const double to_lowest_m = std::max(0.0, -(a_.ground_radius_m + altitude_m) * cosine);
  const double lowest_m = altitude_after(altitude_m, cosine, to_lowest_m);
  const double lowest_cosine = std::max(0.0, cosine);
  const auto add = [&](double length_m) {
    walk(length_m, depth_steps, [&](double distance_m, double step_m) {
      const Coefficients here = at_altitude(altitude_after(lowest_m, lowest_cosine, distance_m));
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
  const double horizon = -std::sqrt(std::max(0.0, 1.0 - sine * sine));
  const double half_disc = a_.sun_angular_radius_rad * sine;
  const double t = std::clamp((sun_cosine - horizon) / (2.0 * half_disc) + 0.5, 0.0, 1.0);
  const double visible = t * t * (3.0 - 2.0 * t);
  if (visible == 0.0) return {};
  Spectrum light = transmittance(altitude_m, std::max(sun_cosine, horizon));
  for (double& share : light) share *= visible;
  return light;
}

Spectrum SkyReference::scattered(const Ray& ray, const Isotropic& others) const {
  Spectrum light{}, depth{};
  const double r = a_.ground_radius_m + ray.altitude_m;
  const double once_aerosol = aerosol_phase(a_.aerosol_asymmetry, ray.between);
  const double once_rayleigh = rayleigh_phase(ray.between);
  walk(end_of(ray.altitude_m, ray.cosine).distance_m, light_steps, [&](double distance_m, double step_m) {
    const double here_m = std::max(0.0, altitude_after(ray.altitude_m, ray.cosine, distance_m));
    const double here_sun = (r * ray.sun_cosine + distance_m * ray.between) / (a_.ground_radius_m + here_m);
    const Coefficients here = at_altitude(here_m);
    const Spectrum sun = sunlight(here_m, here_sun), more = others(here_m, here_sun);
    for (std::size_t i = 0; i < 4; ++i) {
      depth[i] += 0.5 * here.extinction_perm[i] * step_m;
      light[i] += std::exp(-depth[i]) * step_m *
                  (sun[i] * (here.rayleigh_perm[i] * once_rayleigh + here.aerosol_perm * once_aerosol) +
                   more[i] * (here.rayleigh_perm[i] + here.aerosol_perm));
      depth[i] += 0.5 * here.extinction_perm[i] * step_m;
    }
  });
  return light;
}

Spectrum SkyReference::scattered_more(double altitude_m, double sun_cosine) const {
  constexpr int rings = 48, azimuths = 8;  // of one side
  Spectrum second{}, returned{};
  const double r = a_.ground_radius_m + altitude_m;
  const double sun_sine = std::sqrt(1.0 - sun_cosine * sun_cosine);
  for (int direction = 0; direction < rings * azimuths; ++direction) {
    const double cosine = 1.0 - 2.0 * (direction / azimuths + 0.5) / rings;
    const double between = cosine * sun_cosine + std::sqrt(1.0 - cosine * cosine) * sun_sine *
                                                     std::cos(pi * (direction % azimuths + 0.5) / azimuths);
    const End end = end_of(altitude_m, cosine);
    Spectrum depth{};
    walk(end.distance_m, mean_steps, [&](double distance_m, double step_m) {
      const double here_m = std::max(0.0, altitude_after(altitude_m, cosine, distance_m));
      const Coefficients here = at_altitude(here_m);
      const Spectrum sun =
          sunlight(here_m, (r * sun_cosine + distance_m * between) / (a_.ground_radius_m + here_m));
      for (std::size_t i = 0; i < 4; ++i) {
        depth[i] += 0.5 * here.extinction_perm[i] * step_m;
        const double scattered = std::exp(-depth[i]) * step_m * (here.rayleigh_perm[i] + here.aerosol_perm);
        second[i] += scattered * sun[i] / (4.0 * pi);
        returned[i] += scattered;
        depth[i] += 0.5 * here.extinction_perm[i] * step_m;
      }
    });
    if (end.on_ground) {
      const double ground_sun = (r * sun_cosine + end.distance_m * between) / a_.ground_radius_m;
      const Spectrum sun = sunlight(0.0, ground_sun);
      for (std::size_t i = 0; i < 4; ++i) {
        const double reflected = std::exp(-depth[i]) * a_.ground_albedo[i];
        second[i] += reflected / pi * std::max(0.0, ground_sun) * sun[i];
        returned[i] += reflected;
      }
    }
  }
  Spectrum mean{};
  for (std::size_t i = 0; i < 4; ++i) {
    mean[i] = second[i] / (rings * azimuths) / (1.0 - returned[i] / (rings * azimuths));
  }
  return mean;
}

}  // namespace offing::sky
