#include "tests/sky/sky_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offing::sky {
namespace {

using std::numbers::pi;
using Vector = SkyPaths::Vector;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector sum(const Vector& a, double factor, const Vector& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

Vector unit(const Vector& a) {
  return sum({}, 1.0 / std::sqrt(dot(a, a)), a);
}

}  // namespace

double SkyPaths::altitude_of(const Vector& position) const {
  return std::sqrt(dot(position, position)) - air_.atmosphere().ground_radius_m;
}

// A direction at this angle from another, its azimuth at random.
Vector SkyPaths::turned(const Vector& direction, double cosine) {
  const Vector other = std::abs(direction[0]) < 0.5 ? Vector{1.0, 0.0, 0.0} : Vector{0.0, 1.0, 0.0};
  const Vector across = unit(sum(other, -dot(other, direction), direction));
  const Vector third{direction[1] * across[2] - direction[2] * across[1],
                     direction[2] * across[0] - direction[0] * across[2],
                     direction[0] * across[1] - direction[1] * across[0]};
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), azimuth = 2.0 * pi * uniform();
  return sum(sum(sum({}, cosine, direction), sine * std::cos(azimuth), across), sine * std::sin(azimuth),
             third);
}

// By rejection: Rayleigh from the isotropic, Cornette-Shanks from Henyey-Greenstein, both through 1 +
// cosine^2.
double SkyPaths::scattering_cosine(bool is_aerosol) {
  const double g = air_.atmosphere().aerosol_asymmetry;
  for (;;) {
    double cosine = 2.0 * uniform() - 1.0;
    if (is_aerosol) {
      const double root = (1.0 - g * g) / (1.0 + g * cosine);
      cosine = (1.0 + g * g - root * root) / (2.0 * g);
    }
    if (2.0 * uniform() < 1.0 + cosine * cosine) return cosine;
  }
}

double SkyPaths::one_path(Vector position, Vector direction, const Vector& sun) {
  const Atmosphere& atmosphere = air_.atmosphere();
  const std::size_t w = wavelength_;
  // Nowhere is the air denser: tentative collisions at this rate, some of them rejected (Woodcock 1965).
  const double densest_perm =
      air_.at_altitude(0.0).extinction_perm[w] + air_.at_altitude(atmosphere.ozone_peak_m).extinction_perm[w];
  double light = 0.0, weight = 1.0;
  for (int collisions = 0; collisions < 200;) {
    const double altitude_m = std::max(0.0, altitude_of(position));
    const double cosine = dot(position, direction) / std::sqrt(dot(position, position));
    const SkyReference::End end = air_.end_of(altitude_m, cosine);
    double distance_m = 0.0, here_m = 0.0;
    SkyReference::Coefficients here;
    do {
      distance_m -= std::log(1.0 - uniform()) / densest_perm;
      if (distance_m >= end.distance_m) break;
      here_m = std::max(0.0, air_.altitude_after(altitude_m, cosine, distance_m));
      here = air_.at_altitude(here_m);
    } while (uniform() * densest_perm >= here.extinction_perm[w]);
    const bool leaves = distance_m >= end.distance_m;
    if (leaves && !end.on_ground) return light;
    position = sum(position, leaves ? end.distance_m : distance_m, direction);
    const Vector up = unit(position);
    if (leaves) {
      weight *= atmosphere.ground_albedo[w];
      const double sun_cosine = dot(up, sun);
      if (sun_cosine > 0.0) light += weight * air_.sunlight(0.0, sun_cosine)[w] * sun_cosine / pi;
      position = sum({}, atmosphere.ground_radius_m, up);
      direction = turned(up, std::sqrt(uniform()));
      continue;
    }
    const double scattering_perm = here.rayleigh_perm[w] + here.aerosol_perm;
    weight *= scattering_perm / here.extinction_perm[w];
    if (++collisions > 1) {
      const double between = dot(direction, sun);
      const double phase = (here.rayleigh_perm[w] * rayleigh_phase(between) +
                            here.aerosol_perm * aerosol_phase(atmosphere.aerosol_asymmetry, between)) /
                           scattering_perm;
      light += weight * phase * air_.sunlight(here_m, dot(up, sun))[w];
    }
    direction = turned(direction, scattering_cosine(uniform() * scattering_perm < here.aerosol_perm));
    // Paths of little weight end at random, the others gain what those lose.
    const double survival = std::min(1.0, 4.0 * weight);
    if (uniform() >= survival) return light;
    weight /= survival;
  }
  return light;
}

SkyPaths::Estimate SkyPaths::scattered_more(double eye_altitude_m, const Vector& view, const Vector& sun,
                                            int paths) {
  const Vector eye{0.0, air_.atmosphere().ground_radius_m + eye_altitude_m, 0.0};
  double total = 0.0, squares = 0.0;
  for (int i = 0; i < paths; ++i) {
    const double light = one_path(eye, view, sun);
    total += light;
    squares += light * light;
  }
  const double mean = total / paths;
  return {mean, std::sqrt(std::max(0.0, squares / paths - mean * mean) / paths)};
}

}  // namespace offing::sky
